"""What a report tells, without the packages that make a page of it."""

import datetime
import math
import pathlib
import re
import subprocess

import numpy as np
import pytest

import roughcontact as rc
from roughcontact._command import program
from roughcontact.report import command, page, wording
from roughcontact._blocks import largest, means, side_of_blocks
from roughcontact.report.content import collect
from roughcontact.report.quantities import with_prefix
from roughcontact.report.run import CURVE_POINTS, run_of, with_curve

STEEL = ["--E", "210GPa", "--nu", "0.3"]
pytestmark = pytest.mark.skipif(program() is None, reason="the command, which solves for a report, is not beside the package")


@pytest.fixture
def file(tmp_path, rough):
    np.save(tmp_path / "rough.npy", rough.heights * 1e6)
    return str(tmp_path / "rough.npy")


def of(words):
    with run_of(words) as (folder, curve):
        return collect(folder, curve)


def collected(file, *arguments):
    return of([file, "--unit", "um", "--pitch", "1", *STEEL, "--boundary", "periodic", *arguments])


def test_one_target_becomes_the_last_of_a_curve(file):
    content = collected(file, "--load", "1mN")
    loads = [step.load for step in content.steps]
    assert content.curve and len(loads) == CURVE_POINTS
    assert (loads[-1], loads[0]) == pytest.approx((1e-3, 1e-5), rel=1e-6)
    assert with_curve(["--area", "10%"]) == (["--area", "0.1%..10%:10log"], True)
    assert with_curve(["--pressure=2e-3"]) == (["--pressure", "2e-05..2e-3:10log"], True)
    for several in ("1,2", "1..2:3", "1MPa:2MPa:3", "0", "much"):
        assert with_curve(["--load", several]) == (["--load", several], False)


def test_the_folder_of_solve_is_read(file, tmp_path):
    words = ["solve", file, "--unit", "um", "--pitch", "1", *STEEL, "--pressure", "20MPa", "--quiet", "--set", "max_iter=900"]
    folder = tmp_path / "run"
    subprocess.run([program(), *words, "--out", str(folder)], check=True)
    content = of([str(folder)])
    assert len(content.steps) == 1 and not content.curve and content.steps[0].mean_pressure == pytest.approx(20e6)
    assert (
        content.command
        == f"roughcontact solve {file} --pitch 1 --unit um --E 210GPa --nu 0.3 --pressure 20MPa --set=max_iter=900"
    )
    subprocess.run([program(), *words, "--out", str(tmp_path / "bare"), "--no-maps"], check=True)
    for place, says in ((tmp_path / "bare", "has no heights.npy"), (tmp_path, "has no summary.json")):
        with pytest.raises(rc.ArgumentError, match=says):
            of([str(place)])


def test_one_clear_line_and_status_1(file, tmp_path, capfd, monkeypatch):
    good = [file, "--pitch", "1um", "--unit", "um", *STEEL, "--load", "1mN", "--out", str(tmp_path / "page.html")]
    for arguments, words in (
        (["report"], "give the folder"),
        (["rapport"], "is no command"),
        (["report", file, "--load", "1"], "the elastic modulus is missing"),
        (["report", *good, "--pressure", "1"], "only one of"),
        (["report", *good, "--hardnes", "1"], "did you mean"),
        (["report", "absent.x3p", *STEEL, "--load", "1"], "No such file"),
        (["report", *good[:-1], str(tmp_path / "none" / "page.html")], "does not exist"),
        (["report", *good[:-1], str(tmp_path)], "is a folder"),
        (["report", *good[:-1], file], "is the surface's file"),
        (["report", *good, "--law", file], "does not begin with"),
    ):
        monkeypatch.setattr(page, "NEEDED", ("numpy",))
        assert command.main(arguments) == 1, arguments
        said = capfd.readouterr()
        assert said.out == "" and words in said.err.splitlines()[-1], (arguments, said.err)
    monkeypatch.setattr(page, "NEEDED", ("numpy", "no_such_package"))
    assert command.main(["report", *good]) == 1
    assert (
        "no_such_package not installed, which a page is made with: pip install 'roughcontact[report]'" in capfd.readouterr().err
    )
    assert not (tmp_path / "page.html").exists()


def test_the_smooth_answer_and_the_leak_are_told(file):
    shaped = of([file, "--unit", "um", "--pitch", "1", *STEEL, "--shape", "sphere:R=1mm", "--load", "1N"])
    radius = (3 * 1e-3 / (4 * shaped.modulus)) ** (1 / 3)
    assert f"Without roughness (Hertz): contact {with_prefix(2 * radius, 'm')} wide" in wording.conclusion(shaped)
    assert shaped.persson is None and "Boundary free, as the shape ends somewhere." in wording.assumptions(shaped)
    words = ["solve", file, "--unit", "um", "--pitch", "1", *STEEL, "--load", "1mN", "--leak", "viscosity=1mPas,drop=1bar"]
    if "built without" not in subprocess.run([program(), *words, "--quiet"], stderr=subprocess.PIPE, text=True).stderr:
        leaking = collected(file, "--load", "1mN", *words[-2:])
        rows, fluid = wording.leak_rows(leaking), leaking.maps.fluid
        assert len(rows) == len(leaking.steps) and len(rows[0]) == len(wording.LEAK_HEAD)
        assert f"{leaking.steps[-1].leak_lower:.6g} to {leaking.steps[-1].leak_upper:.6g} m³/s" in rows[-1]
        assert fluid.shape == leaking.maps.gap.shape and np.nanmin(fluid) >= 0 and np.nanmax(fluid) <= 1
        assert np.nanmean(fluid[:, 0]) > np.nanmean(fluid[:, -1]) and np.isnan(fluid[leaking.maps.pressure > 0]).all()
        assert collected(file, "--load", "1mN").maps.fluid is None
        assert re.search(r" Leak \d\.\d·10⁻[⁰¹²³⁴⁵⁶⁷⁸⁹]+ m³/s \(", wording.conclusion(leaking)), wording.conclusion(leaking)


def test_bodies_that_creep(file):
    content = collected(file, "--creep", "0.5:1s,1.5:1min", "--pressure", "20MPa", "--time", "0,1,10,100,1000")
    assert not content.curve and content.times == [0, 1, 10, 100, 1000] and content.persson is None
    assert wording.conclusion(content).startswith("After 1000 s: Contact area")
    assert wording.step_head(content)[:3] == ("step", "after", "load")
    assert [row[1] for row in wording.step_rows(content)] == ["0 s", "1 s", "10 s", "100 s", "1000 s"]
    assert any("compliance grows with time as 0.5:1s,1.5:1min says" in text for text in wording.assumptions(content))
    assert len(set(map(len, [wording.step_head(content), *wording.step_rows(content)]))) == 1
    assert with_curve(["--load", "1mN", "--steps=file.csv"])[1] is False


def test_the_numbers_are_those_of_solve(file, rough):
    content = collected(file, "--pressure", "20MPa,100MPa", "--tol", "1e-8")
    assert len(content.steps) == 2 and content.certified and content.surface.periodic
    for step, target in zip(content.steps, (20e6, 100e6)):
        result = rc.solve(rough, modulus=content.modulus, pressure=target, tol=1e-8, want_gap=True, stiffness=1)
        assert step.load == pytest.approx(result.load) and step.area_fraction == pytest.approx(
            result.contacts / result.points, abs=1e-3
        )
        assert step.mean_gap == pytest.approx(result.gap.mean(), rel=1e-4) and step.max_pressure == pytest.approx(
            result.pressure.max(), rel=1e-4
        )
        assert step.stiffness == pytest.approx(result.stiffness, rel=1e-3)
        assert content.corrected(step) == pytest.approx(result.corrected_area / content.nominal_area, rel=1e-3)
    assert step.patches == len(content.patches) and content.histogram.contacts == step.contacts
    assert content.persson == pytest.approx(rc.surface.analyze(rough).rms_slope)
    assert content.persson_area(step.load) == pytest.approx(math.erf(math.sqrt(2) * 100e6 / content.modulus / content.persson))
    assert content.maps.side == 1 and np.array_equal(content.maps.pressure > 0, content.maps.contact > 0)
    assert (
        content.bearing[1][0] == pytest.approx(rough.heights.max() - rough.heights.mean())
        and (np.diff(content.bearing[1]) <= 0).all()
    )


def test_words(file):
    content = collected(file, "--pressure", "5GPa")
    assert f"Contact area {100 * content.steps[-1].area_fraction:.3g} % at" in wording.conclusion(content)
    assert "10 of 10 steps are certified" in wording.certificate(content)
    said = " ".join(wording.assumptions(content))
    for words in (
        "Lengths without a unit are in um",
        "The pitch was given: 1 µm × 1 µm",
        "No point is missing",
        "no hardness was given",
        "E = 210GPa",
        "were added for the curves",
    ):
        assert words in said, said
    assert all(len(row) == len(wording.STEP_HEAD) for row in wording.step_rows(content))
    assert all(len(row) == len(wording.PROOF_HEAD) for row in wording.proof_rows(content))
    tables = (wording.step_rows(content), wording.proof_rows(content), wording.surface_rows(content))
    cells = [cell for rows in tables for row in rows for cell in row]
    assert not [cell for cell in cells if re.search(r"\de[-+]\d|(^|\s)-0(\s|$)", cell)]  # in programmers' form
    assert dict(wording.surface_rows(content))["rms height"] == "100 nm"
    assert wording.conclusion(collected(file, "--pressure", "5GPa", "--hardness", "1TPa")).endswith(
        "below the hardness of 1 TPa."
    )
    yielding = collected(file, "--pressure", "5GPa", "--hardness", "8GPa")
    assert (
        "of the contact is at the hardness of 8 GPa and carries" in wording.conclusion(yielding)
        and yielding.steps[-1].mean_gap >= 0
    )
    assert "no hardness" not in " ".join(wording.assumptions(yielding))


def test_facts_intervals_and_where_theory_holds(file):
    content = collected(file, "--pressure", "20MPa,100MPa", "--hardness", "8GPa")
    said = " ".join(wording.facts(content))
    loads = [with_prefix(step.load, "N") for step in content.steps]
    for words in ("E* 231 GPa", "hardness 8 GPa", "periodic boundary", f"2 loads, {loads[0]} to {loads[1]}", content.version):
        assert words in said, said
    assert datetime.date.fromisoformat(content.date) and content.date in said
    r = content.steps[-1]
    middle, half = (r.load_lower + r.load_upper) / 2, (r.load_upper - r.load_lower) / 2
    assert wording.proof_rows(content)[-1][3] == f"{with_prefix(middle, 'N', 6)} ± {with_prefix(half, 'N', 2)}"
    assert "load, proven" in wording.PROOF_HEAD and "area, proven" in wording.PROOF_HEAD
    assert wording._interval(np.nan, 1.0, "N") == "not known" and wording._interval(1.0, 2.0, "%") == "1.5 % ± 0.5 %"
    free = [file, "--pitch", "1um", "--unit", "um", *STEEL, "--boundary", "free", "--pressure", "20MPa"]
    assert content.persson is None and of(free).persson is None and collected(file, "--pressure", "20MPa").persson


def test_the_page_follows_the_dark():
    template = (pathlib.Path(page.__file__).parent / "page.html.j2").read_text(encoding="utf-8")
    assert "prefers-color-scheme: dark" in template and "facts" in template
    style = template[template.index("<style>") : template.index("</style>")]
    found = [line for line in style.splitlines() if re.search("#[0-9a-f]{3,6};", line) and ":root" not in line]
    assert found == []  # every colour is in the two sets


def test_a_goal_for_the_accuracy(tmp_path):
    smooth = rc.surface.spectral((256, 256), pitch=1e-6, rms_height=1e-7, hurst=1, q_high=2 * np.pi / 32e-6)
    np.save(tmp_path / "smooth.npy", smooth.heights)
    goal = [str(tmp_path / "smooth.npy"), "--pitch=1um", *STEEL, "--boundary=periodic", "--pressure=50MPa,100MPa", "--set=accuracy=0.2"]
    content = of(goal)
    assert content.certified and [step.status for step in content.steps] == 2 * [rc.Status.WITHIN_GOAL]
    assert "2 were solved on a coarser grid" in wording.certificate(content)
    assert "Contact area" in wording.conclusion(content) and "Not certified" not in wording.conclusion(content)
    assert all("points solved" in row[-2] for row in wording.proof_rows(content))


def test_missing_points_and_a_plane(tmp_path, rough):
    z = rough.heights + 1e-6 * np.arange(64) / 64
    z[3, 4] = np.nan
    np.save(tmp_path / "z.npy", z)
    file = [str(tmp_path / "z.npy"), "--pitch", "1um", *STEEL, "--pressure", "20MPa,50MPa"]
    tilted = of([*file, "--missing", "fill"])
    assert any("level them with --remove plane" in doubt for doubt in wording.doubts(tilted))
    level = of([*file, "--missing", "exclude", "--remove", "plane"])
    assert (
        not any("plane" in doubt for doubt in wording.doubts(level))
        and level.input["missing"] == 1
        and level.statistics is None
    )
    assert np.isnan(level.maps.heights).sum() == 1 and level.maps.pressure[3, 4] == 0
    assert "1 missing points were kept out of contact." in wording.assumptions(level)


def test_nothing_in_contact(file):
    content = collected(file, "--load", "0")
    assert wording.conclusion(content) == "Load 0 N, no contact." and content.histogram is None


def test_blocks_are_true():
    values = np.arange(35.0).reshape(5, 7)
    assert side_of_blocks((5, 7), 35) == 1 and side_of_blocks((5, 7), 34) == 2 and side_of_blocks((1, 1000), 10) == 100
    assert np.array_equal(largest(values, 2)[0], [8, 10, 12, 13]) and largest(values, 2)[2, 3] == 34
    assert means(values, 2)[0, 0] == 4 and means(values, 2)[2, 3] == 34
    values[0, 0] = np.nan
    assert means(values, 2)[0, 0] == np.mean([1, 7, 8]) and np.array_equal(means(values, 1), values, equal_nan=True)


def test_numbers_have_sensible_digits():
    assert with_prefix(1.7e-7, "N", 2) == "170 nN" and with_prefix(1.734e-7, "N", 2) == "170 nN"
    assert with_prefix(-0.0, "m") == "0 m" and with_prefix(12.345e-9, "m", 2) == "12 nm"
    assert wording._power(1e-8) == "1.0·10⁻⁸" and wording._power(0.0) == "0" and wording._power(1.26e-13) == "1.3·10⁻¹³"

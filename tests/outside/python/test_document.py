"""The first example of docs/python.md works when copied into an empty folder; so does every other one, after it."""

import importlib
import pathlib
import re
import subprocess
import sys

import pytest

import roughcontact as rc

DOCUMENT = pathlib.Path(__file__).resolve().parents[3] / "docs" / "python.md"


def blocks(document=DOCUMENT):
    if not document.exists():
        pytest.skip(f"{document.name} is not beside the tests")
    return re.findall(r"^```python\n(.*?)^```", document.read_text(), re.M | re.S)


@pytest.mark.parametrize(
    "page, printed", [("docs/python.md", r"\n+prints\n+```\n"), ("README.md", r"[^`]*?```sh\n.*?```\n+```text\n")]
)
def test_the_first_program_runs_in_an_empty_folder_as_printed(page, printed, tmp_path):
    document = DOCUMENT.parents[1] / page
    (tmp_path / "press.py").write_text(blocks(document)[0])
    ran = subprocess.run([sys.executable, "press.py"], cwd=tmp_path, capture_output=True, text=True)
    expected = re.search(rf"^```python\n.*?^```{printed}(.*?)^```", document.read_text(), re.M | re.S)[1]
    assert (ran.stderr, ran.stdout) == ("", expected)


def test_other_examples_run_one_after_another(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    names = {}
    for block in blocks() + blocks(DOCUMENT.with_name("how-to") / "many-machines.md"):
        if "matplotlib" in block:
            pytest.importorskip("matplotlib").use("agg")
        exec(compile(block, str(DOCUMENT), "exec"), names)


def test_examples_of_derivatives_run(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    names = {}
    for block in blocks(DOCUMENT.with_name("derivatives.md")):
        if "roughcontact.jax" in block:
            try:
                import jax
            except ImportError:
                continue
            names["jax"] = jax
        exec(compile(block, "derivatives.md", "exec"), names)
    reverse, forward = map(float, capsys.readouterr().out.splitlines()[1].split())
    assert reverse == pytest.approx(forward, rel=1e-3)


def test_a_texture_is_fitted_and_heights_are_carried_to_the_load():
    pytest.importorskip("scipy")
    example = DOCUMENT.parents[1] / "examples" / "fit_texture.py"
    ran = subprocess.run([sys.executable, str(example), "--points", "32", "--iterations", "15"], capture_output=True, text=True)
    assert ran.returncode == 0, ran.stderr
    misfit, *uncertain = ran.stdout.splitlines()
    first, best = (float(number) for number in re.findall(r"([\d.]+) %", misfit))
    assert best < 0.15 * first
    for line in uncertain:
        linear, sampled = (float(number) for number in re.findall(r"([\d.]+) N(?=,|$)", line)[1:])
        assert linear == pytest.approx(sampled, rel=0.25)


def printed(example, points):
    """The numbers of each line that an example prints."""
    program = [sys.executable, str(DOCUMENT.parents[1] / "examples" / example), "--points", str(points)]
    ran = subprocess.run(program, capture_output=True, text=True)
    assert ran.returncode == 0, ran.stderr
    return [[float(each) for each in re.findall(r"(?<![\^\d.])\d[\d.]*(?:e-?\d+)?", line)] for line in ran.stdout.splitlines()]


def test_a_pin_wears_flat():
    *steps, (volume, radius) = printed("wear.py", 64)
    assert [step[0] for step in steps] == [1, 2, 5, 10, 20]
    assert all(off < 1e-8 for *_, off in steps)
    assert steps[-1][3] == pytest.approx(volume, rel=1e-6)
    assert steps[-1][1] == pytest.approx(radius, rel=0.01)


def test_roughness_finer_than_the_grid_is_a_bed_of_springs():
    for _, approach, steps, off, fine_grid, rigid in printed("fine_roughness.py", 16):
        assert steps < 30 and off < 1e-7
        assert abs(approach - fine_grid) < 0.3 * (rigid - fine_grid)


def test_a_micro_simulation_goes_back_to_a_state(monkeypatch):
    monkeypatch.syspath_prepend(DOCUMENT.parents[1] / "integrations" / "precice")
    micro = importlib.import_module("micro_simulation")
    point, other = micro.MicroSimulation(0), micro.MicroSimulation(1)
    assert point.initialize() == point.solve({"Overclosure": -1e-7}, 1.0) == {"Pressure": 0.0, "Slope": 0.0, "Solved": 0.0}
    step = 1e-10
    for overclosure, solved in ((1e-7, 1), (3e-7, 0)):
        first = point.solve({"Overclosure": overclosure}, 1.0)
        state = point.get_state()
        beyond = point.solve({"Overclosure": overclosure + step}, 1.0)
        assert first["Solved"] == beyond["Solved"] == solved
        assert (beyond["Pressure"] - first["Pressure"]) / step == pytest.approx(first["Slope"], rel=0.02)
        other.set_state(state)
        assert other.solve({"Overclosure": overclosure}, 1.0)["Pressure"] == pytest.approx(first["Pressure"], rel=1e-6)


def test_everything_public_is_documented():
    text = DOCUMENT.read_text()
    modules = {"surface": rc.surface, "analysis": rc.analysis, "direct": rc.direct, "plot": rc.plot}
    for name in rc.__all__:
        assert re.search(rf"\b{name}\b", text), f"{name} is not in {DOCUMENT.name}"
        assert name == "raw" or name in modules or getattr(rc, name).__doc__, f"{name} has no docstring"
    for module, found in modules.items():
        for name, thing in vars(found).items():
            if callable(thing) and getattr(thing, "__module__", "") == found.__name__ and not name.startswith("_"):
                assert thing.__doc__ and re.search(rf"\b{name}\b", text), f"{module}.{name} is not in {DOCUMENT.name}"


@pytest.mark.slow
def test_the_tour_makes_its_pictures(tmp_path):
    pytest.importorskip("matplotlib")
    ran = subprocess.run(
        [sys.executable, str(DOCUMENT.with_name("python_tour.py")), str(tmp_path)], capture_output=True, text=True
    )
    assert ran.returncode == 0, ran.stderr
    assert {each.name for each in tmp_path.iterdir()} == {
        each.name for each in (DOCUMENT.parent / "images").glob("python-*.png")
    }

"""Budgets of uncertainties: closed forms, derivatives against samples, the registration of a joint, and what is refused."""

import json
import subprocess

import numpy as np
import pytest
from conftest import refused

import roughcontact as rc
from roughcontact._command import program

STEEL = {"E": "210GPa", "nu": 0.3, "boundary": "periodic", "unit": "m"}


def surface(seed, **spec):
    spec = {"rms_height": 0.3e-6, "hurst": 0.8, "q_rolloff": 2 * np.pi / 16e-6, **spec}
    return rc.surface.spectral((64, 64), pitch=1e-6, seed=seed, **spec)


KINDS = {  # of the height's standard deviation
    "self-affine": lambda: surface(1),
    "smooth": lambda: surface(2, q_high=2 * np.pi / 8e-6),
    "ridges": lambda: rc.surface.waves((64, 64), pitch=1e-6, amplitude=0.3e-6, period=(16e-6, 0)),
    "skew": lambda: rc.Surface(np.exp(surface(4).heights / 0.3e-6) * 0.1e-6, (1e-6, 1e-6), True),
    "plateau": lambda: rc.Surface(np.minimum(surface(5).heights, 0.2e-6) + 0.01 * surface(9).heights, (1e-6, 1e-6), True),
    "anisotropic": lambda: rc.Surface(
        np.repeat(surface(6).heights[:, ::4], 4, axis=1) + 0.02 * surface(7).heights, (1e-6, 1e-6), True
    ),
}


def test_load_goes_with_modulus_and_pitch():
    """H is proportional to pitch / E*: at a given approach the load is proportional to both, and the gap keeps."""
    found = rc.budget(surface(1), "modulus=5%,pitch=1%", modulus="100GPa", approach="0.4um", boundary="periodic")
    for name in ("load", "stiffness"):
        assert found[name]["modulus"].standard == pytest.approx(0.05 * found[name].value, rel=1e-6)
        assert found[name]["pitch"].standard == pytest.approx(0.01 * found[name].value, rel=1e-6)
        assert found[name].standard == pytest.approx(np.hypot(0.05, 0.01) * found[name].value, rel=1e-6)
    assert found["conductance"]["modulus"].standard < 1e-6 * found["conductance"].value
    assert found["mean_gap"].standard < 1e-6 * found["mean_gap"].value and found["approach"].standard == 0
    assert (found["load"].dominant, found["load"].coverage) == ("modulus", pytest.approx(1.96, abs=0.01))
    assert found["load"]["modulus"].share == pytest.approx(25 / 26, rel=1e-6)


def test_heights_scale_the_gap_as_the_modulus_scales_the_pressure():
    """Heights times f at modulus E* is the contact at f E* with all lengths along the normal times f."""
    found = rc.budget(surface(3), "height=2%,modulus=2%", modulus="100GPa", pressure="1GPa", boundary="periodic")
    assert found["area"]["height"].standard == pytest.approx(found["area"]["modulus"].standard)
    gaps = [
        rc.solve(surface(3), modulus=f * 100e9, pressure=1e9, boundary="periodic", want_gap=True).mean_gap * f
        for f in (0.98, 1.02)
    ]
    assert found["mean_gap"]["height"].standard == pytest.approx((gaps[1] - gaps[0]) / 2, rel=1e-5)


def test_a_ratio_and_a_load_are_relative_or_absolute():
    found = rc.budget(surface(1), {"nu": 0.03, "pressure": "20MPa"}, pressure="1GPa", **STEEL)
    same = rc.budget(surface(1), "nu=10%,pressure=2%", pressure="1GPa", **STEEL)
    assert [each.standard for each in found.quantities] == pytest.approx([each.standard for each in same.quantities])
    assert found["load"].standard == pytest.approx(0.02 * found["load"].value)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("correlation", ["", "3um"])
def test_derivatives_agree_with_samples(kind, correlation):
    words = {"noise": "0.3nm", "samples": 400, **({"correlation": correlation} if correlation else {})}
    found = rc.budget(KINDS[kind](), words, pressure="1GPa", **STEEL)
    part = found["mean_gap"]["noise"]
    assert part.sampled == pytest.approx(part.first_order, rel=0.15) and part.standard == part.first_order
    if not correlation and kind != "ridges":  # of which 64 points are the highest, and noise lifts another one
        assert found["approach"]["noise"].sampled == pytest.approx(found["approach"]["noise"].first_order, rel=0.15)


def test_noise_is_the_spread_of_noisy_maps_and_their_shift():
    rough, noise, random = KINDS["smooth"](), 20e-9, np.random.default_rng(5)
    found = rc.budget(rough, {"noise": noise, "samples": 100}, pressure="1GPa", **STEEL)["area"]
    areas = [
        rc.solve(
            rough.heights + noise * random.standard_normal(rough.shape), pitch=1e-6, pressure="1GPa", **STEEL
        ).area_fraction
        for _ in range(100)
    ]
    assert found["noise"].standard == pytest.approx(np.std(areas, ddof=1), rel=0.25)
    sampling = 4 * np.std(areas) * np.sqrt(2 / 100)
    assert (
        found["noise"].shift == pytest.approx(np.mean(areas) - found.value, abs=sampling) and found["noise"].shift < -sampling
    )
    assert found.standard == pytest.approx(np.hypot(found["noise"].standard, found["noise"].shift))


def test_registration_is_the_spread_of_shifted_maps():
    one, other, random = surface(1), surface(2), np.random.default_rng(3)
    found = rc.budget(one, "shift=1mm,samples=60", against=other, pressure="0.3GPa", **STEEL)["stiffness"]
    spread = []
    for _ in range(60):
        moved = np.roll(other.heights, random.integers(0, 64, 2), axis=(0, 1))
        spread.append(rc.solve(one.heights + moved, pitch=1e-6, pressure="0.3GPa", stiffness=1, **STEEL).stiffness)
    assert found["shift"].standard == pytest.approx(np.std(spread, ddof=1), rel=0.35)
    assert found.coverage > 1.99 and found["shift"].shift == 0 and found.dominant == "shift"
    still = rc.budget(one, "shift=0.2um,samples=4", against=other, pressure="0.3GPa", **STEEL)["stiffness"]
    assert still["shift"].standard == 0  # less than half a cell


def test_other_preparations_are_half_widths():
    rough = surface(1)
    tilted = rc.Surface(rough.heights + 1e-8 * np.arange(64), (1e-6, 1e-6), True)
    found = rc.budget(tilted, "remove=plane,bandwidth=4um", pressure="1GPa", **STEEL)["area"]
    flat = rc.solve(tilted, remove="plane", pressure="1GPa", **STEEL).area_fraction
    assert found["remove"].standard == pytest.approx(abs(flat - found.value) / np.sqrt(3))
    f = np.fft.fftfreq(64, 1e-6)
    cut = np.fft.ifft2(np.fft.fft2(tilted.heights) * np.exp(-np.log(2) * (f[:, None] ** 2 + f**2) * 4e-6**2)).real
    smooth = rc.solve(cut, pitch=1e-6, pressure="1GPa", **STEEL).area_fraction
    assert found["bandwidth"].standard == pytest.approx(abs(smooth - found.value) / np.sqrt(3), rel=0.02)
    holes = tilted.heights.copy()
    holes[20:24, 30:40] = np.nan
    found = rc.budget(holes, "missing", pitch=1e-6, missing="fill", pressure="1GPa", **STEEL)["mean_gap"]
    other = rc.solve(holes, pitch=1e-6, missing="exclude", pressure="1GPa", want_gap=True, **STEEL).mean_gap
    assert found["missing"].standard == pytest.approx(abs(other - found.value) / np.sqrt(3))


def test_windows_and_grids():
    rough = surface(1)
    found = rc.budget(rough, "window=2,grid", load="1N", **STEEL)
    parts = [
        rc.solve(rough.heights[y : y + 32, x : x + 32], pitch=1e-6, load="0.25N", stiffness=1, **STEEL)
        for y in (0, 32)
        for x in (0, 32)
    ]
    assert found["area"]["window"].standard == pytest.approx(np.std([part.area_fraction for part in parts], ddof=1) / 2)
    assert found["stiffness"]["window"].standard == pytest.approx(
        np.std([4 * part.stiffness for part in parts], ddof=1) / 2, rel=1e-6
    )
    assert found["load"].standard < 1e-6

    def gap(side):
        means = rough.heights.reshape(64 // side, side, 64 // side, side).mean(axis=(1, 3))
        return rc.solve(means, pitch=side * 1e-6, load="1N", want_gap=True, **STEEL).mean_gap

    last, before = abs(gap(2) - gap(1)), abs(gap(4) - gap(2))
    order = np.clip(np.log2(before / last), 0.5, 2)
    assert found["mean_gap"]["grid"].standard == pytest.approx(last / (2**order - 1), rel=1e-6)


@pytest.mark.parametrize("by", [{"pressure": "1GPa"}, {"load": "1N"}, {"approach": "0.4um"}])
def test_maps_are_the_spread_of_separate_answers(by):
    maps = [surface(seed) for seed in (1, 2, 3, 4)]
    found = rc.budget(maps[0], {"maps": maps[1:]}, **by, **STEEL)
    apart = [rc.solve(each, **by, stiffness=1, want_gap=True, **STEEL) for each in maps]
    answers = {
        "load": [each.load for each in apart],
        "approach": [each.approach for each in apart],
        "area": [each.area_fraction for each in apart],
        "stiffness": [each.stiffness for each in apart],
        "mean_gap": [each.mean_gap for each in apart],
    }
    for name, values in answers.items():
        part = found[name]["maps"]
        assert part.standard == pytest.approx(np.std(values, ddof=1), rel=1e-12, abs=1e-12 * abs(values[0]))
        assert (part.given, part.shift, part.solves) == ("3 maps", 0, 3)
    assert found["area"].dominant == "maps" and found["area"].freedom == pytest.approx(3, rel=1e-3)


def test_maps_are_prepared_as_the_first(tmp_path):
    tilted = [surface(seed).heights + 1e-8 * np.arange(64) for seed in (1, 2, 3)]
    tilted[1][20:24, 30:40] = np.nan
    paths = [str(tmp_path / f"{k}.npy") for k in range(3)]
    for path, heights in zip(paths, tilted):
        np.save(path, heights * 1e6)
    words = {"remove": "plane", "missing": "fill", "pitch": "1um", "pressure": "1GPa", **STEEL, "unit": "um"}
    areas = [rc.solve(path, **words).area_fraction for path in paths]
    for sources in (f"maps={paths[1]};{paths[2]}", {"maps": paths[1:]}, {"maps": [paths[1], tilted[2] * 1e6]}):
        found = rc.budget(paths[0], sources, **words)["area"]
        assert found["maps"].standard == pytest.approx(np.std(areas, ddof=1), rel=1e-12)


def test_the_solver_brings_its_proven_interval():
    words = {"approach": "0.4um", "tol": 1e-3, **STEEL}
    found, result = rc.budget(surface(1), "E=1%", **words), rc.solve(surface(1), stiffness=2, **words)
    assert found["load"]["solver"].standard == pytest.approx((result.load_upper - result.load_lower) / np.sqrt(12))
    assert found["area"]["solver"].standard == pytest.approx(
        (result.area_upper - result.area_lower) / np.sqrt(12) / result.grid.area
    )


def test_a_hardness_a_shape_and_a_gap():
    hard = rc.budget(surface(1), "hardness=10%,noise=1nm,samples=8", hardness="2GPa", pressure="1GPa", **STEEL)
    ends = [rc.solve(surface(1), hardness=f * 2e9, pressure="1GPa", **STEEL).area_fraction for f in (0.9, 1.1)]
    assert hard["area"]["hardness"].standard == pytest.approx(abs(ends[1] - ends[0]) / 2)
    conductance = hard["conductance"]  # 2 stiffness / E* is too small where points at the hardness conduct
    assert np.isnan(conductance.value) and conductance.standard == 0 and conductance.sentence == "conductance is not known"
    ball = rc.budget(surface(1), "height=1%,E=1%", shape="sphere:R=1mm", load="1N", E="210GPa", nu=0.3, unit="m")
    assert ball["load"].standard < 1e-8 and ball["approach"]["height"].standard > 0
    rough = surface(1)
    both = [
        rc.budget(*heights, sources="noise=0.3nm,height=1%,samples=4", pressure="1GPa", **STEEL, **words)
        for heights, words in (([rough], {}), ([], {"undeformed_gap": rough.heights.max() - rough.heights, "pitch": 1e-6}))
    ]
    for name in ("area", "stiffness", "mean_gap"):
        assert both[0][name].standard == pytest.approx(both[1][name].standard, rel=1e-6)
    assert both[0]["approach"].standard > both[1]["approach"].standard  # which counts from the zero that the caller gave


def test_the_same_seed_gives_the_same_budget_and_progress_ends_it():
    words = {"pressure": "1GPa", **STEEL}
    first, again, other = (rc.budget(surface(1), f"noise=5nm,seed={seed}", **words) for seed in (1, 1, 2))
    assert repr(first) == repr(again) and first["area"].standard != other["area"].standard
    seen = []
    with pytest.raises(rc.NotCertifiedError):
        rc.budget(surface(1), "noise=5nm,E=5%", progress=lambda done, of: seen.append((done, of)) or done == 3, **words)
    assert seen[0] == (0, 19) and seen[-1] == (3, 19)
    assert first.solves == 17 and "noise brings 100 % of the variance" in str(first)
    pytest.importorskip("pandas")
    assert len(first.to_dataframe()) == 14


BARE, OTHER = {"surface": surface(1).heights, "pitch": 1e-6}, rc.Surface(surface(2).heights, (1e-6, 1e-6), True, unit="m")


@pytest.mark.parametrize(
    "sources, words, message",
    [
        ("", {}, "sources is empty"),
        ("noize=1nm", {}, 'did you mean "noise"'),
        ("noise", {}, "noise has no value"),
        ("noise=1nm,noise=2nm", {}, "given twice"),
        ("noise=-1nm", {}, "noise"),
        ("nu2=1%", {}, "nu2 is uncertain by 1%, but nu2 is not given"),
        ("shift=1um", {}, "against is not given"),
        ("missing", {}, "no point of the map is missing"),
        ("window=2", {"shape": "sphere:R=1mm"}, "nominal shape"),
        ("window=9", {}, "whole number in 2 .. 8"),
        ("correlation=1um", {}, "correlation is of noise"),
        ("height=1nm", {}, "not a share"),
        ("E=100%", {}, "not below 100 %"),
        ("samples=1", {}, "samples"),
        ({"maps": []}, {}, "maps names no map, give at least one other"),
        ({"maps": [surface(1)]}, {}, "has the heights of the surface itself"),
        ({"maps": [surface(2), rc.surface.spectral((64, 66), pitch=1e-6, rms_height=0.3e-6)]}, {}, "map 2: .* 3.1 %"),
        ({"maps": [np.full((64, 64), np.nan)]}, {}, "map 1: .* missing"),
        ({"maps": [surface(2), rc.Surface(surface(2).heights, (1e-6, 1e-6), False)]}, {"boundary": None}, "map 2: its edges .* give boundary"),
        ({"maps": "nowhere.gsf"}, {}, "maps, map 1: nowhere.gsf"),
        ({"maps": "one.gsf;;two.gsf"}, {}, "has an empty name"),
        ({"maps": OTHER}, {**BARE, "unit": None, "E": 2e11, "load": 1.0}, "must both have units"),
        ({"maps": OTHER}, {**BARE, "mask": surface(1).heights < 0}, "mask is of the first"),
        ({"maps": ["nowhere.gsf"]}, BARE, "nowhere.gsf"),
    ],
)
def test_what_is_refused(sources, words, message):
    words = {"load": "1mN", "E": "210GPa", "nu": 0.3, "unit": "m", "boundary": "free", **words}
    refused((rc.RoughContactError, FileNotFoundError), message, rc.budget, words.pop("surface", surface(1)), sources, **words)


@pytest.mark.skipif(program() is None, reason="the command is not beside the package")
def test_command_and_report_say_what_dominates(tmp_path):
    np.save(tmp_path / "rough.npy", surface(1).heights)
    np.save(tmp_path / "other.npy", surface(2).heights)
    sources = f"noise=5nm,E=5%,maps={tmp_path / 'other.npy'}"
    words = ["--pitch=1um", "--unit=m", "--E=210GPa", "--nu=0.3", "--boundary=periodic", "--pressure=0.5GPa,1GPa"]
    asked = [program(), "solve", str(tmp_path / "rough.npy"), *words, "--budget", sources]
    printed = subprocess.run([*asked, "--out", str(tmp_path / "run")], check=True, capture_output=True, text=True).stdout
    found = rc.budget(surface(1), {"noise": "5nm", "E": "5%", "maps": [surface(2)]}, pressure="1GPa", **STEEL)
    assert "".join(f"\n  {each}" for each in map(str, found.quantities)) in printed
    saved = json.loads((tmp_path / "run/summary.json").read_text())["budget"]
    assert saved["area"]["contributions"]["noise"]["shift"] == pytest.approx(found["area"]["noise"].shift)
    again = subprocess.run(
        [*asked, "--out", str(tmp_path / "run"), "--resume", "--quiet"], check=True, capture_output=True, text=True
    )
    assert "2 of 2 steps are complete" in again.stderr

    from roughcontact.report import wording
    from roughcontact.report.content import collect

    content = collect(tmp_path / "run")
    assert any("Area" in each and "of the variance" in each for each in wording.sentences(content))
    assert [row[0] for row in wording.budget_rows(content)][:3] == ["noise 5nm", "E 5%", f"maps {tmp_path / 'other.npy'}"]
    assert [row[0] for row in wording.budget_rows(content)][3:] == ["solver", "combined", "coverage"]
    assert f"--budget {sources}" in content.command


def test_the_leak_has_a_budget():
    try:
        rc.raw.flow_library()
    except rc.LibraryNotFoundError as absent:
        pytest.skip(str(absent))
    words = {"leak": "viscosity=1mPas,drop=1bar", "pressure": "0.3GPa", **STEEL}
    found = rc.budget(surface(1), "height=2%,shift=1mm,samples=4", against=surface(2), **words)["leak"]
    pressed = {"against": surface(2), "pressure": "0.3GPa", "want_gap": True, **STEEL}
    fluid = {"viscosity": 1e-3, "pressure_drop": 1e5}
    result = rc.solve(surface(1), **pressed)
    leak = result.leak(**fluid)
    assert found.value == pytest.approx(leak.flow) and found.unit == "m^3/s"
    assert found["solver"].standard == pytest.approx((leak.upper - leak.lower) / np.sqrt(12), rel=1e-3)
    flows = []
    for f in (0.98, 1.02):
        scaled = rc.Surface(f * surface(1).heights, (1e-6, 1e-6), True), rc.Surface(f * surface(2).heights, (1e-6, 1e-6), True)
        flows.append(rc.solve(scaled[0], **{**pressed, "against": scaled[1]}).leak(**fluid).flow)
    assert found["height"].standard == pytest.approx(abs(flows[1] - flows[0]) / 2, rel=1e-4)
    assert found["shift"].standard > 0 and "m^3/s" in found.sentence
    most = rc.budget(surface(1), "height=60%", against=surface(2), **{**words, "pressure": "1GPa"})["leak"]  # it may close
    assert most.coverage * most.standard > most.value > 0 and ", 0 to " in most.sentence and "so not linear" in most.sentence

"""One meaning of `unit` in every door: that of lengths without one. A surface with a unit is used in metres."""

import json
import os
import pathlib
import subprocess
import sys
import warnings

import numpy as np
import pytest

import roughcontact as rc
from conftest import refused

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "support"))
from unit_matrix import STEP, cases, heights  # noqa: E402

PRESS = {"modulus": 1e9, "boundary": "free"}
AREA = (24 * 0.5e-6) ** 2


@pytest.fixture
def micrometres():
    """[24, 24] heights in micrometres, with a pitch of 0.5."""
    return rc.surface.spectral((24, 24), pitch=0.5, rms_height=0.02, hurst=0.8, seed=5).heights


def test_every_place_of_a_unit_against_every_other(tmp_path):
    z = np.array(heights())
    for name, contents, unit, metres in cases():
        path = tmp_path / name
        path.write_bytes(contents.encode())
        per_unit = 1.0 if unit is None or metres is None else rc.Surface(z, 1.0, unit=unit).in_unit("m").pitch[0]
        pitch = None if name[0] == "a" else 2e-6 / per_unit
        with warnings.catch_warnings(record=True) as seen:
            warnings.simplefilter("always")
            if metres is None:
                refused(rc.ArgumentError, "unit", rc.read, path, pitch=pitch, unit=unit)
                continue
            surface = rc.read(path, pitch=pitch, unit=unit)
        assert np.allclose(surface.heights, z * metres[1], rtol=1e-12, atol=0), contents
        assert surface.pitch[0] == pytest.approx(STEP * metres[0] if pitch is None else 2e-6) and surface.unit == "m"
        assumed = unit is None and metres == (1, 1)
        assert [each.category for each in seen] == [rc.AssumedUnit] * assumed, contents
        assert ("names none" in surface.assumed) == assumed


def test_the_same_words_mean_the_same(tmp_path, micrometres):
    """pitch .5, unit um, pressure 1 MPa: a load of 1 MPa on 12 x 12 square micrometres, whatever has the heights."""
    path = tmp_path / "r.npy"
    np.save(path, micrometres)
    words = {"pitch": 0.5, "unit": "um", **PRESS}
    named = rc.Surface(micrometres, 0.5, unit="um")
    metres = rc.Surface(micrometres * 1e-6, 0.5e-6)
    want = rc.solve(metres, pressure=1e6, **PRESS)
    assert want.load == pytest.approx(1e6 * AREA)
    for how, given in (
        (path, words),
        (str(path), words),
        (micrometres, words),
        (rc.Surface(micrometres, 0.5), {**PRESS, "unit": "um"}),
        (named, PRESS),
    ):
        assert rc.solve(how, pressure=1e6, **given).approach == pytest.approx(want.approach, rel=1e-9)
        assert rc.history(how, pressure=[1e6], **given).load == pytest.approx([want.load])
        assert rc.batch([how, how], pressure=1e6, **given).load == pytest.approx(np.full((2, 1), want.load))
        assert rc.law(how, pressure=(1e5, 1e6), tolerance=0.05, **given).info["area"] == pytest.approx(AREA)
        if given is words:
            assert rc.solve(how, approach=0.04, **given).load == pytest.approx(rc.solve(metres, approach=0.04e-6, **PRESS).load)
    gap = micrometres.max() - micrometres
    assert rc.solve(undeformed_gap=gap, pressure=1e6, **words).approach == pytest.approx(want.approach, rel=1e-9)
    assert rc.batch(undeformed_gap=gap, pressure=1e6, **words).approach[0, 0] == pytest.approx(want.approach, rel=1e-9)
    assert rc.surface.analyze(named).rms_height == pytest.approx(rc.surface.analyze(metres).rms_height)
    assert rc.HalfSpace.under(named, modulus=1e9, boundary="free").pitch == pytest.approx((0.5e-6, 0.5e-6))
    with rc.Contact(rc.HalfSpace.under(named, modulus=1e9, boundary="free")) as contact:
        assert contact.solve(named, pressure=1e6).approach == pytest.approx(want.approach, rel=1e-9)
    ball = {"shape": "sphere:R=100", "load": 1e-4}
    assert rc.solve(micrometres, **words, **ball).approach == pytest.approx(
        rc.solve(micrometres, **words, **{**ball, "shape": "sphere:R=0.1mm"}).approach, rel=1e-12
    )


def test_without_units_any_consistent_set_stays(micrometres):
    free = rc.solve(micrometres, pitch=0.5, modulus=1e-3, boundary="free", pressure=1e-6)
    assert free.load == pytest.approx(1e-6 * 144)
    assert rc.solve(rc.Surface(micrometres, 0.5), modulus=1e-3, boundary="free", pressure=1e-6).approach == free.approach


def test_what_could_mean_either_is_refused(tmp_path, micrometres):
    named = rc.Surface(micrometres, 0.5, unit="um")
    for unit in ("um", "m", "nm"):
        for call, how in (
            (rc.solve, {"load": 1e-4}),
            (rc.history, {"load": [1e-4]}),
            (rc.batch, {"load": 1e-4}),
            (rc.law, {"pressure": (1e5, 1e6)}),
        ):
            refused(rc.ArgumentError, "leave unit out", call, named, unit=unit, **PRESS, **how)
    metres = named.in_unit("m")
    assert rc.solve(metres, unit="m", load=1e-4, **PRESS).certified
    refused(rc.ArgumentError, "give R its unit", rc.solve, named, shape="sphere:R=100", modulus=1e9, load=1e-4)
    refused(rc.ArgumentError, "has its own", rc.solve, named, pitch=0.5, load=1e-4, **PRESS)
    assert rc.solve(named, pitch=0.5e-6, load=1e-4, **PRESS).certified
    refused(rc.ArgumentError, "the other says no unit", named.__add__, rc.Surface(micrometres, 0.5))
    metres.save(tmp_path / "m.gsf")
    refused(
        rc.ArgumentError,
        "is m in the file, but the unit given is um",
        rc.solve,
        tmp_path / "m.gsf",
        unit="um",
        load=1e-4,
        **PRESS,
    )


def test_what_is_assumed_is_said(tmp_path, micrometres):
    np.save(tmp_path / "r.npy", micrometres * 1e-6)
    for call in (
        lambda: rc.read(tmp_path / "r.npy", pitch=1e-6),
        lambda: rc.solve(tmp_path / "r.npy", pitch=1e-6, load=1e-4, **PRESS),
    ):
        with pytest.warns(rc.AssumedUnit, match="r.npy") as seen:
            call()
        assert seen[0].filename == __file__
    metres = rc.Surface(micrometres * 1e-6, 0.5e-6, unit="m")
    with pytest.warns(rc.AssumedUnit, match="against"):
        rc.solve(metres, against=micrometres * 1e-6, load=1e-4, **PRESS)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        rc.solve(metres, against=metres, load=1e-4, **PRESS)
        rc.solve(micrometres, pitch=0.5, unit="um", against=tmp_path / "r.npy", load=1e-4, **PRESS)
        metres.save(tmp_path / "other.gsf")
        rc.solve(micrometres, pitch=0.5, unit="um", against=tmp_path / "other.gsf", load=1e-4, **PRESS)


@pytest.mark.parametrize("first", [True, False, None])
@pytest.mark.parametrize("second", [True, False, None])
def test_two_bodies_repeat_if_both_do(tmp_path, micrometres, first, second):
    """As by the command: free if either says so, not known if one does not say."""
    repeats = {True: "Periodic = 1\n", False: "Periodic = 0\n", None: ""}
    for name, flag in (("one.gsf", first), ("other.gsf", second)):
        rc.Surface(micrometres * 1e-6, 0.5e-6, flag, unit="m").save(tmp_path / name)
    free = False in (first, second)
    known = free or None not in (first, second)
    with warnings.catch_warnings(record=True) as seen:
        warnings.simplefilter("always")
        found = rc.solve(tmp_path / "one.gsf", against=tmp_path / "other.gsf", modulus=1e9, load=1e-4)
    assert found.grid.periodic is not free and [each.category for each in seen] == [rc.AssumedBoundary] * (not known), repeats
    command = (
        os.environ.get("ROUGHCONTACT_COMMAND") or pathlib.Path(rc.library_file()).resolve().parents[1] / "bin/roughcontact"
    )
    if not pathlib.Path(command).exists():
        pytest.skip("the command is not beside the library")
    words = [
        command,
        "solve",
        "one.gsf",
        "--against",
        "other.gsf",
        "--modulus",
        "1GPa",
        "--load",
        "100uN",
        "--out",
        "out",
        "--quiet",
    ]
    done = subprocess.run(
        list(map(str, words)), cwd=tmp_path, capture_output=True, text=True, env={**os.environ, "PATH": "/nonexistent"}
    )
    assert done.returncode == 0, done.stderr
    summary = json.loads((tmp_path / "out/summary.json").read_text())
    assert (
        summary["input"]["boundary"] == ("free" if free else "periodic")
        and ("note: boundary periodic" in done.stderr) is not known
    )
    assert summary["steps"][0]["approach"] == pytest.approx(found.approach, rel=1e-9)


def test_one_list_of_units(micrometres):
    for name, metres in (
        ("km", 1e3),
        ("cm", 1e-2),
        ("\u00b5m", 1e-6),
        ("\u03bcm", 1e-6),
        ("A", 1e-10),
        ("\u00c5", 1e-10),
        ("micron", 1e-6),
        ("fm", 1e-15),
    ):
        assert rc.Surface(micrometres, 1.0, unit=name).in_unit("m").pitch[0] == pytest.approx(metres)
        if metres > 1e-3:
            assert rc.solve(
                rc.Surface(micrometres * 0, 1e-5, unit="m"), shape="sphere:R=1" + name, modulus=1e9, load=1.0
            ).contacts
    for name in ("MM", "inch", "V"):
        refused(rc.ArgumentError, "is not a length", rc.Surface(micrometres, 1.0, unit=name).in_unit, "m")

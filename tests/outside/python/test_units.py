"""One meaning of `unit` in every door: that of lengths without one. A surface with a unit is used in metres. And which boundary a
surface is pressed with."""

import warnings

import numpy as np
import pytest

import roughcontact as rc
from conftest import refused

PRESS = {"modulus": 1e9, "boundary": "free"}
AREA = (24 * 0.5e-6) ** 2


@pytest.fixture
def micrometres():
    """[24, 24] heights in micrometres, with a pitch of 0.5."""
    return rc.surface.spectral((24, 24), pitch=0.5, rms_height=0.02, hurst=0.8, seed=5).heights


def test_the_same_words_mean_the_same(micrometres):
    """pitch .5, unit um, pressure 1 MPa: a load of 1 MPa on 12 x 12 square micrometres, whatever has the heights."""
    words = {"pitch": 0.5, "unit": "um", **PRESS}
    named = rc.Surface(micrometres, 0.5, unit="um")
    metres = rc.Surface(micrometres * 1e-6, 0.5e-6)
    want = rc.solve(metres, pressure=1e6, **PRESS)
    assert want.load == pytest.approx(1e6 * AREA)
    for how, given in ((micrometres, words), (rc.Surface(micrometres, 0.5), {**PRESS, "unit": "um"}), (named, PRESS)):
        assert rc.solve(how, pressure=1e6, **given).approach == pytest.approx(want.approach, rel=1e-9)
        assert rc.history(how, pressure=[1e6], **given).load == pytest.approx([want.load])
        assert rc.batch([how, how], pressure=1e6, **given).load == pytest.approx(np.full((2, 1), want.load))
        assert rc.law(how, pressure=(1e5, 1e6), tolerance=0.05, **given).info["area"] == pytest.approx(AREA)
    gap = micrometres.max() - micrometres
    assert rc.solve(undeformed_gap=gap, pressure=1e6, **words).approach == pytest.approx(want.approach, rel=1e-9)
    assert rc.batch(undeformed_gap=gap, pressure=1e6, **words).approach[0, 0] == pytest.approx(want.approach, rel=1e-9)
    assert rc.surface.analyze(named).rms_height == pytest.approx(rc.surface.analyze(metres).rms_height)
    assert rc.HalfSpace.under(named, modulus=1e9, boundary="free").pitch == pytest.approx((0.5e-6, 0.5e-6))
    with rc.Contact(rc.HalfSpace.under(named, modulus=1e9, boundary="free")) as contact:
        assert contact.solve(named, pressure=1e6).approach == pytest.approx(want.approach, rel=1e-9)


def test_what_could_mean_either_is_refused(micrometres):
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


HOW = {"modulus": 1e9, "load": 1e-4}


def pressed_periodically(*surface, **more):
    """Whether the grid of the answer is periodic; a warning is an error."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        return rc.solve(*surface, **{**HOW, **more}).grid.periodic


def test_the_surface_decides(rough):
    ball = rc.surface.sphere((16, 16), pitch=1e-6, radius=1e-4)
    assert rough.periodic is True and pressed_periodically(rough)
    assert ball.periodic is False and not pressed_periodically(ball)
    assert not pressed_periodically(rough, boundary="free") and pressed_periodically(ball, boundary="periodic")
    assert not pressed_periodically(rough, shape="sphere:R=1e-3")


@pytest.mark.parametrize(
    "call",
    [
        lambda heights: rc.solve(heights, pitch=1e-6, **HOW).grid.periodic,
        lambda heights: rc.solve(undeformed_gap=-heights, pitch=1e-6, **HOW).grid.periodic,
        lambda heights: rc.history(heights, pitch=1e-6, modulus=1e9, load=[1e-4]).certificate.max() < 1,
        lambda heights: rc.batch(undeformed_gap=-heights, pitch=1e-6, **HOW).certified == 1,
        lambda heights: rc.HalfSpace(heights.shape, pitch=1e-6, modulus=1e9).periodic,
        lambda heights: rc.HalfSpace.under(heights, pitch=1e-6, modulus=1e9).periodic,
    ],
)
def test_what_nobody_says_is_periodic_with_a_warning_at_the_callers_line(rough, call):
    with pytest.warns(rc.AssumedBoundary, match="boundary='free' if") as seen:
        assert call(rough.heights)
    assert [warning.filename for warning in seen] == [__file__]


def test_a_batch_of_surfaces_that_differ_needs_a_boundary(rough):
    with pytest.raises(rc.ArgumentError, match="differ in whether they repeat"):
        rc.batch([rough, rc.Surface(rough.heights, rough.pitch)], **HOW)

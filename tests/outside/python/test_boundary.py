"""Which boundary a surface is pressed with, and what results with free edges say of it."""

import warnings

import pytest

import roughcontact as rc

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

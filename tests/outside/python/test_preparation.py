"""against=, shape= and remove= prepare heights as the command does."""

import numpy as np
import pytest

import roughcontact as rc
from conftest import refused

SIDE = 48
PRESS = {"modulus": 1e9, "load": 1e-4}


def pressed(heights, **how):
    return rc.solve(heights, pitch=None if isinstance(heights, rc.Surface) else 1e-6, boundary="free", **PRESS, **how)


@pytest.fixture
def two():
    return [rc.surface.spectral((SIDE, SIDE), pitch=1e-6, rms_height=1e-7, hurst=0.8, seed=seed) for seed in (3, 4)]


def test_two_surfaces_are_added(two, tmp_path):
    together = pressed(two[0].heights + two[1].heights)
    np.save(tmp_path / "other.npy", two[1].heights)
    for other in (two[1], two[1].heights, tmp_path / "other.npy"):
        assert pressed(two[0], against=other).load_lower == together.load_lower
    assert rc.history(two[0], against=two[1], boundary="free", modulus=1e9, load=[1e-4]).approach[0] == together.approach


def test_another_grid_is_refused(two):
    for other in (two[1].heights[1:], rc.Surface(two[1].heights, (2e-6, 1e-6))):
        refused(rc.ShapeError, "against: .* give two maps on the same grid", pressed, two[0], against=other)


def test_units_of_both_are_those_of_the_first(two):
    micrometres = rc.Surface(two[1].heights * 1e6, (1.0, 1.0), unit="um")
    metres = rc.Surface(two[0].heights, (1e-6, 1e-6), unit="m")
    assert pressed(metres, against=micrometres).approach == pytest.approx(pressed(two[0], against=two[1]).approach, rel=1e-12)


def test_forms_are_removed_before_a_shape_is_put_on(two):
    y, x = np.mgrid[:SIDE, :SIDE] * 1e-6
    tilted = two[0].heights + 0.05 * x - 0.02 * y
    level = rc.Surface(two[0].heights, (1e-6, 1e-6)).without("plane")
    assert pressed(tilted, remove="plane").approach == pytest.approx(pressed(level).approach, rel=1e-9)
    shaped = pressed(tilted, remove="quadric", shape="sphere:R=1e-3")
    sphere = rc.surface.sphere((SIDE, SIDE), pitch=1e-6, radius=1e-3).heights
    by_hand = rc.Surface(tilted, (1e-6, 1e-6)).without("quadric").heights + sphere
    assert shaped.approach == pytest.approx(pressed(by_hand).approach, rel=1e-9)
    assert pressed(tilted, remove="plane", shape=rc.Surface(sphere, (1e-6, 1e-6))).approach == pytest.approx(
        pressed(level.heights + sphere).approach, rel=1e-9
    )
    refused(rc.ArgumentError, "parabola.* is not known", pressed, tilted, remove="parabola")


@pytest.mark.parametrize(
    "text, depth",
    [
        ("sphere:R=1mm", lambda x, y: 1e-3 - np.sqrt(1e-6 - x**2 - y**2)),
        ("cylinder:R=500um,axis=x", lambda x, y: 5e-4 - np.sqrt(25e-8 - y**2)),
        ("cylinder:R=500um,axis=y", lambda x, y: 5e-4 - np.sqrt(25e-8 - x**2)),
        ("cylinder:R=500um", lambda x, y: 5e-4 - np.sqrt(25e-8 - y**2)),
        ("wedge:angle=5deg,axis=x", lambda x, y: np.abs(y) * np.tan(np.pi / 36)),
        ("wedge:angle=0.01rad,axis=y", lambda x, y: np.abs(x) * np.tan(0.01)),
    ],
)
def test_shapes(text, depth):
    ny, nx = 20, 33
    y, x = ((np.arange(n) - (n - 1) / 2) * h for n, h in ((ny, 2e-6), (nx, 1e-6)))
    expected = -depth(x + 0 * y[:, None], y[:, None] + 0 * x)
    flat = rc.Surface(np.zeros((ny, nx)), (1e-6, 2e-6), unit="m")
    found = rc.solve(flat, shape=text, modulus=1e9, approach=0.0, want_gap=True)
    assert np.allclose(found.gap, expected.max() - expected, rtol=1e-9, atol=1e-18)


@pytest.mark.parametrize(
    "text, words",
    [("ball:R=1mm", "give sphere, cylinder or wedge"), ("sphere", "give sphere:R=1mm"), ("sphere:R=10um", "beyond R = 10 ")],
)
def test_shapes_that_are_refused(text, words):
    flat = rc.Surface(np.zeros((SIDE, SIDE)), (1e-6, 1e-6), unit="m")
    refused(rc.ArgumentError, words, pressed, flat, shape=text)


def test_a_shape_with_a_unit_makes_lengths_metres(two):
    with pytest.warns(rc.AssumedUnit):
        with_unit = pressed(two[0].heights, shape="sphere:R=1mm")
    assert with_unit.approach == pressed(two[0].heights, shape="sphere:R=0.001").approach


def test_missing_points_of_both_are_left_out(two):
    a, b = (each.heights.copy() for each in two)
    a[3, 5] = b[10, 11] = np.nan
    refused(rc.ArgumentError, "missing value", pressed, a, against=two[1].heights)
    refused(rc.ArgumentError, "missing value", pressed, two[0].heights, against=b)
    found = pressed(a, against=b, missing="exclude", remove="plane")
    assert found.grid.mask[3, 5] == found.grid.mask[10, 11] == 0 and found.grid.mask.sum() == SIDE**2 - 2
    assert pressed(a, against=b, missing="fill").grid.mask is None
    refused(rc.ArgumentError, "reject, fill or exclude", pressed, a, against=b, missing="ignore")


def test_gaps_are_not_prepared(two):
    gap = two[0].undeformed_gap()
    for how in ({"against": two[1]}, {"shape": "sphere:R=1"}, {"remove": "plane"}):
        refused(
            rc.ArgumentError,
            "changes heights, but undeformed_gap is given",
            rc.solve,
            undeformed_gap=gap,
            pitch=1e-6,
            **PRESS,
            **how,
        )


def test_systems_press_what_is_prepared(two):
    system = rc.HalfSpace((SIDE, SIDE), pitch=1e-6, modulus=1e9, boundary="free")
    found = rc.solve(two[0].heights, system=system, load=1e-4, against=two[1].heights)
    assert found.approach == pressed(two[0], against=two[1]).approach


@pytest.mark.parametrize(
    "text, width",
    [
        ("sphere:R=50um", lambda load: 2 * (3 * load * 50e-6 / 4e9) ** (1 / 3)),
        ("cylinder:R=50um,axis=x", lambda load: 2 * (4 * load / (SIDE * 1e-6) * 50e-6 / (np.pi * 1e9)) ** 0.5),
        ("wedge:angle=1deg,axis=y", lambda load: 2 * load / (SIDE * 1e-6 * 1e9 * np.tan(np.pi / 180))),
    ],
)
def test_a_contact_wider_than_the_map_is_told(text, width):
    """Hertz' width, and Johnson's of a wedge (1985, equation 5.5)."""
    flat = rc.Surface(np.zeros((SIDE, SIDE)), (1e-6, 1e-6), unit="m")
    side = SIDE * 1e-6
    fits, too_much = (
        min(np.geomspace(1e-9, 1e6, 2000), key=lambda load: abs(width(load) - times * side)) for times in (0.98, 1.02)
    )
    how = {"shape": text, "modulus": 1e9, "tol": 1e-4}
    assert "Hertz" not in rc.solve(flat, load=fits, **how).note
    assert "wide, the map 48 \u00b5m: press a larger map" in rc.solve(flat, load=too_much, **how).note
    assert [("Hertz" in step.note) for step in rc.history(flat, load=[fits, too_much], **how)] == [False, True]

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


def test_units_of_both_are_those_of_the_first(two):
    micrometres = rc.Surface(two[1].heights * 1e6, (1.0, 1.0), unit="um")
    metres = rc.Surface(two[0].heights, (1e-6, 1e-6), unit="m")
    assert pressed(metres, against=micrometres).approach == pytest.approx(pressed(two[0], against=two[1]).approach, rel=1e-12)


def test_a_shape_with_a_unit_makes_lengths_metres(two):
    with pytest.warns(rc.AssumedUnit):
        with_unit = pressed(two[0].heights, shape="sphere:R=1mm")
    assert with_unit.approach == pressed(two[0].heights, shape="sphere:R=0.001").approach


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

"""against=, shape= and remove= prepare heights as the command does."""

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

"""Flow through gaps: what it takes from a result, and what is refused. (Arguments: test_passed_on.py; Ctrl-C: test_guest.py)"""

import numpy as np
import pytest
from conftest import refused

import roughcontact as rc

try:
    rc.raw.flow_library()
except rc.LibraryNotFoundError as absent:
    pytest.skip(str(absent), allow_module_level=True)

FLUID = {"viscosity": 1 / 12, "pressure_drop": 1.0}  # the flow is then the conductance


@pytest.fixture(name="rough_gap", scope="module")
def _rough_gap():
    surface = rc.surface.spectral((64, 64), rms_slope=0.1, q_rolloff=2 * np.pi / 24, q_high=2 * np.pi / 8, seed=5)
    return surface.heights.max() - surface.heights


PRESSED = {"pitch": 1, "modulus": 1, "boundary": "periodic"}


def test_a_wall_and_a_hardness_are_the_results_own(rough_gap):
    """And a history's result brings them too."""
    wall = np.ones(rough_gap.shape, bool)
    wall[:, 20] = False
    hard = {**PRESSED, "undeformed_gap": rough_gap, "hardness": 0.03, "want_gap": True}
    blocked, found = rc.solve(mask=wall, pressure=0.01, **hard), []
    assert blocked.capped > 0 and blocked.leak(**FLUID).upper == 0 < blocked.leak(along="y", **FLUID).lower
    refused(rc.IncompatibleError, "hardness", blocked.leak, load=0.01 * rough_gap.size, **FLUID)
    rc.history(mask=wall, pressure=[0.01], each=lambda k, r: found.append(r.leak(**FLUID).upper), **hard)
    assert found == [0]


def test_a_matrix_needs_its_system(small_matrix):
    system = rc.Matrix(small_matrix, pitch=1, shape=(3, 4))
    gap = np.array([[0, 1, 0.5, 1], [2, 1, 0.3, 1], [1, 2, 1, 0]])
    result = rc.solve(undeformed_gap=gap, system=system, approach=0.4, want_gap=True)
    refused(rc.ArgumentError, "system=", result.leak, **FLUID)
    found = result.leak(system=system, **FLUID)
    assert 0 < found.lower <= found.flow <= found.upper


def test_what_cannot_be_is_refused(rough_gap):
    gap = np.ones((4, 4))
    refused(rc.ArgumentError, "viscosity = 0", rc.flow, gap, pitch=1, viscosity=0, pressure_drop=1)
    refused(rc.ArgumentError, "along is 'z'", rc.flow, gap, pitch=1, along="z", **FLUID)
    refused(rc.ArgumentError, "sides is 'open'", rc.flow, gap, pitch=1, sides="open", **FLUID)
    refused(rc.ArgumentError, "one axis", rc.flow, gap[0], pitch=1, **FLUID)
    refused(rc.ShapeError, "gap_error", rc.flow, gap, pitch=1, gap_error=gap[:2], **FLUID)
    refused(rc.ArgumentError, "want_gap", rc.solve(undeformed_gap=rough_gap, approach=0.1, **PRESSED).leak, **FLUID)
    with rc.Contact(rc.HalfSpace(rough_gap.shape, **PRESSED)) as contact:
        single = contact.solve(undeformed_gap=rough_gap, approach=0.1, want_gap=True, single=True)
    refused(rc.ArgumentError, "float32", single.leak, **FLUID)

"""Flow through gaps: exact cases, intervals of contacts, what is refused, and Ctrl-C."""

import signal
import threading

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


@pytest.fixture(name="pressed", scope="module")
def _pressed(rough_gap):
    return rc.solve(undeformed_gap=rough_gap, pressure=0.01, want_gap=True, tol=1e-4, **PRESSED)


def test_flow_factors_are_over_the_cube_of_the_mean_gap():
    factors = rc.flow_factors(np.tile([1.0, 0.5], (6, 3)), pitch=1)
    assert np.allclose(factors.phi, np.diag([2 / (1 + 8), (1 + 1 / 8) / 2]) / 0.75**3, atol=1e-9)


def test_masks_hardness_and_history_are_the_results_own(rough_gap, pressed):
    wall = np.ones(rough_gap.shape, bool)
    wall[:, 20] = False
    blocked = rc.solve(undeformed_gap=rough_gap, mask=wall, pressure=0.01, want_gap=True, **PRESSED)
    assert blocked.leak(**FLUID).upper == 0 < blocked.leak(along="y", **FLUID).lower
    hard = rc.solve(undeformed_gap=rough_gap, pressure=0.01, hardness=0.03, want_gap=True, **PRESSED)
    assert hard.capped > 0 and hard.grid.hardness == 0.03 and hard.leak(**FLUID).upper < pressed.leak(**FLUID).upper
    refused(rc.IncompatibleError, "hardness", hard.leak, load=0.01 * rough_gap.size, **FLUID)
    found = []
    rc.history(
        undeformed_gap=rough_gap,
        pressure=[0.005, 0.01],
        want_gap=True,
        each=lambda k, r: found.append(r.leak(**FLUID)),
        **PRESSED,
    )
    assert found[0].lower > found[1].upper and found[1].flow == pytest.approx(pressed.leak(**FLUID).flow, rel=0.05)


def test_a_matrix_needs_its_system(small_matrix):
    system = rc.Matrix(small_matrix, pitch=1, shape=(3, 4))
    gap = np.array([[0, 1, 0.5, 1], [2, 1, 0.3, 1], [1, 2, 1, 0]])
    result = rc.solve(undeformed_gap=gap, system=system, approach=0.4, want_gap=True)
    refused(rc.ArgumentError, "system=", result.leak, **FLUID)
    found = result.leak(system=system, **FLUID)
    assert 0 < found.lower <= found.flow <= found.upper


def test_what_cannot_be_is_refused(rough_gap, pressed):
    gap = np.ones((4, 4))
    refused(rc.ArgumentError, "negative", rc.flow, -gap, pitch=1, **FLUID)
    refused(rc.ArgumentError, "1 values .* the first at 2", rc.flow, [[1, 1, np.nan]], pitch=1, **FLUID)
    refused(rc.ArgumentError, "viscosity = 0", rc.flow, gap, pitch=1, viscosity=0, pressure_drop=1)
    refused(rc.ArgumentError, "pressure_drop = -1", rc.flow, gap, pitch=1, viscosity=1, pressure_drop=-1)
    refused(rc.ArgumentError, "along is 'z'", rc.flow, gap, pitch=1, along="z", **FLUID)
    refused(rc.ArgumentError, "sides is 'open'", rc.flow, gap, pitch=1, sides="open", **FLUID)
    refused(rc.ArgumentError, "width = 2", rc.flow, gap, pitch=1, width=2, **FLUID)
    refused(rc.ArgumentError, "one axis", rc.flow, gap[0], pitch=1, **FLUID)
    refused(rc.ShapeError, "gap_error", rc.flow, gap, pitch=1, gap_error=gap[:2], **FLUID)
    refused(rc.ArgumentError, "want_gap", rc.solve(undeformed_gap=rough_gap, approach=0.1, **PRESSED).leak, **FLUID)
    with rc.Contact(rc.HalfSpace(rough_gap.shape, **PRESSED)) as contact:
        single = contact.solve(undeformed_gap=rough_gap, approach=0.1, want_gap=True, single=True)
    refused(rc.ArgumentError, "float32", single.leak, **FLUID)


def test_control_c_ends_it():
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    gap = np.random.default_rng(1).random((700, 700))
    try:
        threading.Timer(0.3, signal.raise_signal, [signal.SIGINT]).start()
        refused(KeyboardInterrupt, "", lambda: [rc.flow(gap, pitch=1, memory=1, width=1e-12, **FLUID) for _ in range(1000)])
    finally:
        signal.signal(signal.SIGINT, before)
    assert rc.flow(gap[:9, :9], pitch=1, **FLUID).lower > 0

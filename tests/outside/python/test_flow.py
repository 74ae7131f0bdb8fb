"""Flow through gaps: exact cases, intervals of contacts, what is refused, and Ctrl-C."""

import signal
import threading
import time

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


def test_strips_add_in_parallel_and_in_series():
    heights = np.array([0.3, 1.0, 0.05, 0.6])
    gap = np.tile(heights, (5, 1))
    across = rc.flow(gap, pitch=(2.0, 1.0), along="y", width=1e-9, **FLUID)
    assert across.lower <= (heights**3).sum() * 2 / 5 * (1 + 1e-12) and across.upper >= (heights**3).sum() * 2 / 5 * (1 - 1e-12)
    assert across.status == rc.Status.OK and across.upper - across.lower <= 1e-9 * across.upper
    series = rc.flow(gap, pitch=(2.0, 1.0), viscosity=2.0, pressure_drop=3.0)
    assert series.flow == pytest.approx(3 / 24 / (2 * (1 / heights**3).sum() / 5), rel=1e-9)
    assert (series.constriction, series.constriction_x, series.crosses) == (pytest.approx(0.05), 2, True)
    assert rc.flow(heights, pitch=(2.0, 5.0), viscosity=2.0, pressure_drop=3.0).flow == pytest.approx(series.flow, rel=1e-9)


def test_a_closed_gap_and_one_that_may_be_open():
    gap = np.ones((4, 6))
    gap[:, 3] = 0
    closed = rc.flow(gap, pitch=1, **FLUID)
    assert closed.upper == 0 and not closed.crosses and closed.constriction_x == -1 and "upper=0" in repr(closed)
    gap[0, 3] = 1e-3
    doubt = rc.flow(gap, pitch=1, gap_error=np.where(gap < 1, 2e-3, 0), **FLUID)
    assert doubt.status == rc.Status.STOP_STALLED and "wider" in doubt.message
    assert doubt.lower == 0 and doubt.upper > doubt.flow > 0


def test_the_potential_is_an_array_of_the_grid():
    gap = np.ones((3, 4))
    gap[1, 1] = 0
    potential = rc.flow(gap, pitch=1, want_potential=True, **FLUID).potential
    assert potential.shape == gap.shape and np.isnan(potential[1, 1]) and potential[0, 0] > potential[0, 3] > 0
    assert rc.flow(gap, pitch=1, **FLUID).potential is None


def test_a_channel_around_the_sides():
    gap = np.zeros((4, 4))
    gap[0, :2] = gap[3, 1:] = 1
    assert rc.flow(gap, pitch=1, **FLUID).upper == 0
    assert rc.flow(gap, pitch=1, sides="periodic", **FLUID).flow == pytest.approx(1 / 5)


def test_flow_factors_of_stripes():
    gap = np.tile([1.0, 0.5], (6, 3))
    factors = rc.flow_factors(gap, pitch=1)
    assert (
        factors.xx == pytest.approx(2 / (1 + 8)) and factors.yy == pytest.approx((1 + 1 / 8) / 2) and factors.mean_gap == 0.75
    )
    assert factors.xx_lower <= factors.xx <= factors.xx_upper and factors.xy_lower <= 0 <= factors.xy_upper
    assert np.allclose(factors.phi, np.diag([factors.xx, factors.yy]) / 0.75**3, atol=1e-9)


def test_the_exact_contact_leaks_within_the_interval_of_a_loose_one(rough_gap, pressed):
    exact = rc.solve(undeformed_gap=rough_gap, approach=pressed.approach, want_gap=True, tol=1e-12, **PRESSED)
    for along in "xy":
        loose, sharp = (each.leak(along=along, width=1e-9, **FLUID) for each in (pressed, exact))
        assert loose.lower <= sharp.upper and sharp.lower <= loose.upper and loose.lower > 0
        assert loose.upper - loose.lower > 10 * (sharp.upper - sharp.lower) and loose.gap_error > sharp.gap_error > 0
    at_load = rc.solve(undeformed_gap=rough_gap, pressure=0.01, want_gap=True, tol=1e-12, **PRESSED).leak(**FLUID)
    bounds = pressed.leak(load=0.01 * rough_gap.size, **FLUID)
    assert bounds.lower <= at_load.upper and at_load.lower <= bounds.upper


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


def test_at_a_load_the_error_of_the_gap_is_that_of_the_results_kernel(rough_gap):
    """2 sqrt(2 H00 G/A) + |min g| where the load is exact, and rounding"""
    half_space = {**PRESSED, "boundary": "free"}
    for kernel in ("love", "disc"):
        result = rc.solve(undeformed_gap=rough_gap, pressure=0.01, want_gap=True, tol=1e-4, kernel=kernel, **half_space)
        own = np.zeros(rough_gap.shape)
        own[0, 0] = 1
        deflection = (rc.Influence(rc.HalfSpace(rough_gap.shape, **half_space), options={"kernel": kernel}) @ own)[0, 0]
        error = 2 * np.sqrt(2 * deflection * result.duality_gap) + abs(result.gap.min())
        assert result.leak(load=result.load, **FLUID).gap_error == pytest.approx(error, rel=1e-3)
        assert result.leak(**FLUID).gap_error == pytest.approx(result.gap_error, rel=1e-3)


def test_a_matrix_needs_its_system(small_matrix):
    system = rc.Matrix(small_matrix, pitch=1, shape=(3, 4))
    gap = np.array([[0, 1, 0.5, 1], [2, 1, 0.3, 1], [1, 2, 1, 0]])
    result = rc.solve(undeformed_gap=gap, system=system, approach=0.4, want_gap=True)
    refused(rc.ArgumentError, "system=", result.leak, **FLUID)
    found = result.leak(system=system, **FLUID)
    assert 0 < found.lower <= found.flow <= found.upper


def test_a_seal_closes_between_two_pressures(rough_gap):
    found = rc.closing_pressure(undeformed_gap=rough_gap, along="y", width=0.02, **PRESSED)
    assert found.status == rc.Status.OK and 0 < found.lower < found.upper <= found.lower / 0.98
    for pressure, closed in ((found.lower * 0.99, False), (found.upper * 1.01, True)):
        result = rc.solve(undeformed_gap=rough_gap, pressure=pressure, want_gap=True, **PRESSED)
        assert (result.leak(along="y", **FLUID).upper == 0) == closed == ("y" not in result.gap_crosses)
    refused(rc.ArgumentError, "only one of load and closing", rc.closing_pressure, undeformed_gap=rough_gap, load=1, **PRESSED)


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
        begun = time.monotonic()
        refused(rc.Interrupted, "", lambda: [rc.flow(gap, pitch=1, memory=1, width=1e-12, **FLUID) for _ in range(1000)])
        assert time.monotonic() - begun < 30
    finally:
        signal.signal(signal.SIGINT, before)
    assert rc.flow(gap[:9, :9], pitch=1, **FLUID).lower > 0

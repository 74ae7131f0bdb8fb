"""Grids that repeat along one axis."""

import numpy as np
import pytest

import roughcontact as rc

HOW = dict(pitch=1.0, modulus=2.0)


def rough(ny, nx):
    x, y = np.meshgrid(np.arange(nx) / nx, np.arange(ny) / ny)
    return np.sin(2 * np.pi * (x + 2 * y)) + np.cos(2 * np.pi * (3 * x - y)) + 0.5 * np.sin(2 * np.pi * 5 * x)


def test_axes_are_named_as_the_grid_has_them():
    heights = rough(18, 24)
    along_x = rc.solve(heights, boundary="periodic-x", load=50.0, **HOW)
    along_y = rc.solve(heights.T.copy(), boundary="periodic-y", load=50.0, **HOW)
    assert along_x.certified and along_x.grid.periodic == "x" and along_y.grid.periodic == "y"
    np.testing.assert_allclose(along_y.pressure.T, along_x.pressure, atol=1e-6 * along_x.pressure.max())
    moved = rc.solve(np.roll(heights, 7, axis=1), boundary="periodic-x", load=50.0, **HOW)
    np.testing.assert_allclose(moved.pressure, np.roll(along_x.pressure, 7, axis=1), atol=1e-6 * along_x.pressure.max())
    assert "periodic-x" in repr(rc.HalfSpace((4, 4), boundary="periodic-x", **HOW))


def test_patches_join_the_sides_of_their_axis():
    pressure = np.zeros((5, 6))
    pressure[2, 0] = pressure[2, 5] = pressure[0, 3] = pressure[4, 3] = 1
    counted = {repeats: len(rc.analysis.patches(pressure, pitch=1.0, periodic=repeats)) for repeats in (False, True, "x", "y")}
    assert counted == {False: 4, True: 2, "x": 3, "y": 3}
    band = np.zeros((5, 6))
    band[2] = 1
    assert rc.analysis.crossing(band, periodic="x").contact == "x"
    with pytest.raises(rc.ArgumentError, match="True, False, 'x' or 'y'"):
        rc.analysis.area(pressure, pitch=1.0, periodic="z")


def test_a_long_period_is_a_free_edge():
    heights = rough(12, 16)
    free = rc.solve(heights, boundary="free", load=20.0, **HOW)
    off = []
    for times in (2, 8):
        padded = np.zeros((12, 16 * times))
        padded[:, :16] = heights
        mask = np.zeros(padded.shape, bool)
        mask[:, :16] = True
        strip = rc.solve(padded, mask=mask, boundary="periodic-x", load=20.0, **HOW)
        off.append(abs(strip.pressure[:, :16] - free.pressure).max() / free.pressure.max())
    assert off[1] < 1e-3 and off[1] < off[0] / 8


def test_a_wide_margin_is_a_free_edge_of_a_periodic_grid():
    x, y = np.meshgrid(np.arange(32) / 32, np.arange(-24, 25) / 24)
    heights = 2 * np.cos(2 * np.pi * x) - 6 * y**2  # smooth, and in contact far from its edges
    strip = rc.solve(heights, boundary="periodic-x", load=200.0, **HOW)
    off = []
    for times in (1, 6):
        padded = np.full((49 * times, 32), -100.0)
        padded[:49] = heights
        periodic = rc.solve(padded, boundary="periodic", load=200.0, **HOW)
        off.append(abs(periodic.pressure[:49] - strip.pressure).max() / strip.max_pressure)
    assert off[1] < 0.01 and off[1] < off[0]

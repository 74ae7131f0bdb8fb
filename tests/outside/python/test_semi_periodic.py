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

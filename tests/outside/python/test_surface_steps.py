"""Surfaces before they are pressed: spikes, parts, turned and moved maps, other grids; against NumPy and closed forms."""

import numpy as np
import pytest
from conftest import refused

import roughcontact as rc


@pytest.fixture
def rough():
    return rc.surface.spectral((40, 56), pitch=0.5, rms_height=1.0, hurst=0.7, seed=4)


def despiked_by_hand(z, factor):
    """NaN at spikes: by windows of the map with reflected edges."""
    wide = np.pad(z, 2, "symmetric")
    windows = np.lib.stride_tricks.sliding_window_view(wide, (5, 5)).reshape(*z.shape, 25)
    off = np.abs(z - np.nanmedian(windows, axis=-1))
    typical = np.nanmedian(off)
    return np.where((off > factor * typical) & (typical > 0), np.nan, z)


@pytest.mark.parametrize("factor", [3.0, 10.0, 40.0])
def test_spikes_are_far_from_the_median_around_them(rough, factor):
    z = rough.heights.copy()
    places = [(0, 0), (3, 55), (39, 20), (12, 30), (12, 31)]
    for k, place in enumerate(places):
        z[place] += (-1) ** k * 50 * np.std(z)
    z[20:23, 10:14] = np.nan
    found = rc.Surface(z, 0.5).despiked(factor)
    expected = despiked_by_hand(z, factor)
    assert np.array_equal(found.heights, expected, equal_nan=True)
    count = np.isnan(expected).sum() - 12
    assert found.remarks[-1].startswith(f"{count} points removed as spikes, the largest of ") and count >= 5
    assert np.all(np.isfinite(found.filled().heights)) and f"{count + 12} points filled" in found.filled().remarks


def test_a_part_has_the_cells_whose_middles_are_inside(rough):
    rows, columns = np.arange(40) * 0.5 + 0.25, np.arange(56) * 0.5 + 0.25
    for x, y in (((3.0, 9.9), (0.25, 7.75)), ((-5.0, 100.0), (19.0, 20.0)), ((0.0, 28.0), (0.0, 20.0))):
        part = rough.cropped(x, y)
        inside = np.ix_((rows >= y[0]) & (rows <= y[1]), (columns >= x[0]) & (columns <= x[1]))
        assert np.array_equal(part.heights, rough.heights[inside])
        assert part.periodic == (rough.periodic if part.shape == rough.shape else False)
    assert np.array_equal(rough.cropped(margin=1.0).heights, rough.heights[2:-2, 2:-2])
    assert rough.cropped(margin=1.0).remarks == ("2240 points cut to 1872",)
    assert rc.Surface(np.arange(6.0), (1.0, 1.0)).cropped((1, 4)).heights.tolist() == [1.0, 2.0, 3.0]
    refused(rc.ArgumentError, "has the middle of no cell; the map is 28 x 20", rough.cropped, (3.0, 3.1))
    refused(rc.ArgumentError, "is not a number", rough.cropped, (np.nan, 3.1))


def along_one_axis(z, places, method, periodic):
    """Values of z [n] at places, in pitches: formulas of Keys (1981), equations 15 and 19."""
    n = len(z)

    def at(i):
        if periodic:
            return z[i % n]
        if i == -1:
            return 3 * z[0] - 3 * z[1] + z[2]
        return 3 * z[n - 1] - 3 * z[n - 2] + z[n - 3] if i == n else z[i]

    def u(s):
        s = abs(s)
        if s < 1:
            return 1.5 * s**3 - 2.5 * s**2 + 1
        return -0.5 * s**3 + 2.5 * s**2 - 4 * s + 2 if s < 2 else 0.0

    weight = u if method == "cubic" else lambda s: max(0.0, 1 - abs(s))
    found = []
    for place in places:
        cell = int(np.floor(place))
        reach = range(cell - 1, cell + 3) if method == "cubic" else range(cell, cell + 2)
        there = periodic or 0 <= place <= n - 1
        found.append(sum(weight(place - i) * at(i) for i in reach if weight(place - i) != 0) if there else np.nan)
    return np.array(found)


@pytest.mark.parametrize("method", ["linear", "cubic"])
@pytest.mark.parametrize("periodic", [True, False])
def test_heights_between_points_are_those_of_the_formulas(rough, method, periodic):
    z = rough.heights
    shifted = rc.Surface(z, 0.5, periodic=periodic).shifted(0.17, -0.9, method=method).heights
    rows = np.array([along_one_axis(row, np.arange(56) - 0.34, method, periodic) for row in z])
    both = np.array([along_one_axis(column, np.arange(40) + 1.8, method, periodic) for column in rows.T]).T
    assert np.allclose(shifted, both, rtol=0, atol=1e-12, equal_nan=True)
    finer = rc.Surface(z, 0.5, periodic=periodic).resampled((0.2, 0.3), method=method)
    assert finer.shape == (66, 140) and finer.pitch == (0.2, 0.3)
    x, y = ((np.arange(140) + 0.5) * 0.2 - 0.25) / 0.5, ((np.arange(66) + 0.5) * 0.3 - 0.25) / 0.5
    rows = np.array([along_one_axis(row, x, method, periodic) for row in z])
    both = np.array([along_one_axis(column, y, method, periodic) for column in rows.T]).T
    assert np.allclose(finer.heights, both, rtol=0, atol=1e-12, equal_nan=True)
    assert finer.periodic is False  # 66 rows of 0.3 are less than the map


def test_missing_heights_stay_missing(rough):
    z = rough.heights.copy()
    z[10, 20] = np.nan
    same = rc.Surface(z, 0.5, periodic=True).shifted(0.5)
    assert np.array_equal(np.argwhere(same.missing), [[10, 21]])
    between = rc.Surface(z, 0.5, periodic=True).shifted(0.25)
    assert np.array_equal(np.argwhere(between.missing), [[10, 19 + k] for k in range(4)])
    assert between.remarks == ("shifted by 0.25, 0: 4 points missing",)


def test_a_map_on_the_grid_of_another_can_be_added(rough):
    other = rc.surface.spectral((60, 84), pitch=1 / 3, rms_height=1.0, hurst=0.7, seed=5)
    there = rough.resampled(other)
    assert there.shape == other.shape and there.periodic and (there + other).shape == other.shape
    with_units = rc.Surface(rough.heights, 0.5, periodic=True, unit="um").resampled(
        rc.Surface(other.heights, 1e3 / 3, periodic=True, unit="nm")
    )
    assert np.allclose(with_units.heights, there.heights, rtol=0, atol=1e-9) and with_units.unit == "um"
    refused(rc.ArgumentError, "interpolation would skip summits", rough.resampled, 0.76)
    refused(rc.ArgumentError, "method is 'spline': linear, cubic", rough.resampled, 0.3, method="spline")
    refused(rc.ArgumentError, "one surface is in 'um', the other says no unit", rough.resampled, with_units)


@pytest.mark.parametrize(
    "name, expected", [("subsample", [[0, 2], [6, 8]]), ("mean", [[2, 3.5], [6.5, 8]]), ("max", [[4, 5], [7, 8]])]
)
def test_downsampling(name, expected):
    heights = np.arange(9.0).reshape(3, 3)
    coarse = rc.surface.downsample(heights, name, pitch=(1.0, 2.0))
    assert np.array_equal(coarse.heights, expected) and coarse.pitch == (2.0, 4.0) and coarse.mask is None
    mask = np.ones((3, 3), bool)
    mask[2, 2] = False
    holes = rc.surface.downsample(heights, name, pitch=1.0, mask=mask)
    assert holes.mask.tolist() == [[1, 1], [1, 0]] and np.isnan(holes.heights[1, 1])
    refused(rc.ArgumentError, "filter", rc.surface.downsample, heights, "median", pitch=1.0)

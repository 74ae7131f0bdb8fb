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


@pytest.mark.parametrize("periodic", [True, False])
def test_grids_that_are_finer_have_their_size_and_pitch(rough, periodic):
    finer = rc.Surface(rough.heights, 0.5, periodic=periodic).resampled((0.2, 0.3))
    assert finer.shape == (66, 140) and finer.pitch == (0.2, 0.3)
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

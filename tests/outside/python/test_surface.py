"""Generators and judgement of surfaces."""

import numpy as np
import pytest
from conftest import refused

import roughcontact as rc


def test_midpoint_displacement():
    fine = rc.surface.rmd(5, hurst=0.8, rms_height=2e-6, pitch=1e-6, seed=7, crop=False)
    assert fine.heights.shape == (33, 33) and fine.pitch == (1e-6, 1e-6) and fine.periodic is None
    assert fine.heights.std() == pytest.approx(2e-6, rel=1e-9)
    coarse = rc.surface.rmd(5, hurst=0.8, rms_height=2e-6, seed=7, crop=False, stage=4)
    assert np.array_equal(coarse.heights, fine.heights[::2, ::2])
    assert np.array_equal(rc.surface.rmd(5, hurst=0.8, rms_height=2e-6, seed=7).heights, fine.heights[:-1, :-1])
    assert not np.array_equal(rc.surface.rmd(5, seed=8).heights, rc.surface.rmd(5, seed=9).heights)
    assert not np.array_equal(rc.surface.rmd(5).heights, rc.surface.rmd(5, additions=True).heights)
    for how in ({"levels": 0}, {"levels": 99}, {"levels": 3, "stage": 4}, {"levels": 3, "hurst": 2.0}):
        refused(rc.ArgumentError, "rc_surface_rmd", rc.surface.rmd, **how)


def test_spectral_surfaces():
    surface = rc.surface.spectral((64, 96), pitch=(2.0, 1.0), rms_slope=0.1, hurst=0.6, q_low=0.2, fixed_amplitudes=True)
    assert surface.shape == (64, 96) and surface.periodic and surface.pitch == (2.0, 1.0)
    assert surface.heights.mean() == pytest.approx(0, abs=1e-12)
    refused(rc.ArgumentError, "rms", rc.surface.spectral, (8, 8), rms_height=1.0, rms_slope=1.0)
    refused(rc.ShapeError, "", rc.surface.spectral, (-8, 8))
    assert rc.surface.spectral(64).heights.shape == (64,)


def test_shapes():
    x = np.arange(10.0) - 4.5
    assert all(made((4, 4), radius=5.0).periodic is False for made in (rc.surface.sphere, rc.surface.paraboloid))
    r2 = x[:, None] ** 2 + x**2
    assert np.allclose(rc.surface.paraboloid((10, 10), radius=5.0).heights, -r2 / 10)
    inside = r2 < 25
    assert np.allclose(rc.surface.sphere((10, 10), radius=5.0).heights[inside], np.sqrt(25 - r2[inside]) - 5)
    waves = rc.surface.waves((4, 8), amplitude=2.0, period=(8.0, 0.0))
    assert np.allclose(waves.heights, 2 * np.cos(2 * np.pi * np.arange(8) / 8)) and waves.periodic
    assert rc.surface.pyramids((8, 8), height=3.0, period=(4.0, 4.0)).heights.max() == 3.0
    assert rc.surface.noise((64, 64), rms_height=2.0).heights.std() == pytest.approx(2.0, rel=0.1)
    refused(rc.ArgumentError, "radius", rc.surface.paraboloid, (4, 4), radius=-1.0)


def test_statistics_of_waves():
    found = rc.surface.analyze(rc.surface.waves((64, 64), amplitude=2.0, period=(64.0, 0.0)))
    assert found.rms_height == pytest.approx(np.sqrt(2)) and found.kurtosis == pytest.approx(1.5) and found.highest == 2.0
    tilted = np.add.outer(np.arange(16.0), np.arange(16.0))
    assert rc.surface.analyze(tilted, pitch=1.0).rms_height == pytest.approx(0, abs=1e-12)
    assert rc.surface.analyze(tilted, pitch=1.0, trend="mean").rms_height > 1
    refused(rc.ArgumentError, "trend is 'line'", rc.surface.analyze, tilted, pitch=1.0, trend="line")
    refused(rc.ArgumentError, "missing points", rc.surface.analyze, np.where(tilted > 29, np.nan, tilted), pitch=1.0)


def test_spectrum_sums_to_the_variance():
    surface = rc.surface.spectral((64, 64), pitch=2.0, rms_height=3.0)
    found = rc.surface.psd(surface)
    assert (found.psd * found.modes).sum() / (128.0 * 128.0) == pytest.approx(9.0)
    assert np.all(np.diff(found.q) > 0)


def test_power_law_finds_the_exponent():
    law = rc.surface.power_law(rc.surface.spectral((256, 256), hurst=0.6, seed=2))
    assert law.hurst == pytest.approx(0.6, abs=0.05) and law.slope == pytest.approx(-2 - 2 * law.hurst)
    waves = (
        rc.surface.spectral((128, 128), rms_height=1.0).heights
        + rc.surface.waves((128, 128), amplitude=1.0, period=(8.0, 0.0)).heights
    )
    peaks = rc.surface.power_law(waves, pitch=1.0, periodic=True)
    assert len(peaks.peak_q) == len(peaks.peak_share) >= 1
    assert np.abs(peaks.peak_q[0]) == pytest.approx([2 * np.pi / 8, 0], abs=1e-3)


def test_advice_on_cascades():
    smooth = rc.surface.cmr_advice(rc.surface.waves((64, 64), amplitude=1.0, period=(64.0, 64.0)), 2)
    noisy = rc.surface.cmr_advice(rc.surface.noise((64, 64)), 2, approach=0.5)
    assert smooth.trustworthy and smooth.safe_levels == 2 and not noisy.trustworthy and noisy.approach == 0.5
    assert noisy.reason.startswith("not trustworthy with 2 halvings")


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


@pytest.mark.parametrize("missing", ["reject", "exclude"])
def test_infinite_heights_are_refused_at_their_place(missing):
    heights = np.random.default_rng(1).random((10, 12))
    heights[3, 4] = np.inf
    with pytest.raises(rc.ArgumentError, match=r"at ix=4, iy=3"):
        rc.solve(heights, pitch=1.0, modulus=1.0, approach=0.1, missing=missing)
    heights[0, 0] = -np.inf
    with pytest.raises(rc.ArgumentError, match=r"at ix=0, iy=0"):
        rc.solve(heights, pitch=1.0, modulus=1.0, approach=0.1, missing=missing)
    mask = np.isfinite(heights)
    assert rc.solve(heights, pitch=1.0, modulus=1.0, approach=0.1, mask=mask, missing=missing).certified

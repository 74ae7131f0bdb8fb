"""Answers, by what makes them differ."""

import numpy as np
import pytest
from conftest import MODULUS, PITCH

import roughcontact as rc


def test_heights_are_gaps_upside_down(sphere_gap):
    gap = rc.solve(undeformed_gap=sphere_gap - sphere_gap.min(), pitch=PITCH, modulus=MODULUS, boundary="free", approach=3e-7)
    heights = rc.solve(-sphere_gap, pitch=PITCH, modulus=MODULUS, boundary="free", approach=3e-7)
    assert np.array_equal(gap.pressure, heights.pressure)


def test_axes_are_rows_and_columns():
    """A ridge along x on cells that are not square: what varies along the last axis has pitch hx."""
    y = np.arange(33) - 16.0
    gap = np.repeat((y**2 / 50)[:, None], 20, axis=1)
    result = rc.solve(undeformed_gap=gap, pitch=(2.0, 1.0), modulus=1.0, boundary="free", approach=1.0)
    assert result.pressure.shape == (33, 20)
    assert result.pressure[16].min() > 0 and result.pressure[0].max() == 0
    turned = rc.solve(undeformed_gap=gap.T, pitch=(1.0, 2.0), modulus=1.0, boundary="free", approach=1.0)
    assert turned.load == pytest.approx(result.load, rel=1e-7)
    assert np.allclose(turned.pressure.T, result.pressure, atol=1e-6 * result.pressure.max())


def test_accuracy_is_a_success_on_a_coarser_grid():
    surface = rc.surface.spectral((512, 512), pitch=1e-6, rms_height=1e-7, hurst=0.8, q_high=2e5)
    result = rc.solve(surface, modulus=1e9, load=1e-2, options={"accuracy": 0.2})
    assert result.status == rc.Status.WITHIN_GOAL and not result.certified
    assert result.accuracy.model_nx < 512 and result.accuracy.error_estimate <= 0.2 and result.pressure.shape == (512, 512)

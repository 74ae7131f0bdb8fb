"""Answers: against theory, and bit by bit against the C functions called with nothing of this package in between."""

import ctypes

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


def directly(system, gap, control, target, pressure):
    """rc_solve from the bare shared library: memory offsets by hand."""
    library = ctypes.CDLL(rc.library_file())
    step, result = bytearray(ctypes.sizeof(rc.raw.rc_step)), bytearray(ctypes.sizeof(rc.raw.rc_result))

    def put(buffer, offset, kind, value):
        kind.from_buffer(buffer, offset).value = value

    put(step, 0, ctypes.c_size_t, len(step))
    put(step, 8, ctypes.c_int32, control)
    put(step, 12, ctypes.c_int32, 1)
    put(step, 16, ctypes.c_double, target)
    put(step, 24, ctypes.c_size_t, gap.ctypes.data)
    put(result, 0, ctypes.c_size_t, len(result))
    put(result, 8, ctypes.c_size_t, pressure.ctypes.data)
    buffers = [(ctypes.c_char * len(each)).from_buffer(each) for each in (system, step, result)]
    return library.rc_solve(buffers[0], buffers[1], None, buffers[2])


@pytest.mark.parametrize("control, name, target", [(1, "approach", 3e-7), (2, "load", 0.5)])
@pytest.mark.parametrize("boundary", ["free", "periodic"])
def test_same_bits_as_the_c_function(control, name, target, boundary):
    surface = rc.surface.spectral((40, 56), pitch=PITCH, rms_height=2e-7, hurst=0.7)
    gap = surface.undeformed_gap()
    system = bytearray(ctypes.sizeof(rc.raw.rc_system))
    for offset, kind, value in (
        (0, ctypes.c_size_t, ctypes.sizeof(rc.raw.rc_system)),
        (8, ctypes.c_int32, 1),
        (12, ctypes.c_int32, 1 if boundary == "free" else 2),
        (16, ctypes.c_int64, 56),
        (24, ctypes.c_int64, 40),
        (32, ctypes.c_double, PITCH),
        (40, ctypes.c_double, PITCH),
        (48, ctypes.c_double, MODULUS),
    ):
        kind.from_buffer(system, offset).value = value
    expected = np.zeros_like(gap)
    assert directly(system, gap, control, target, expected) == 0
    result = rc.solve(surface, modulus=MODULUS, boundary=boundary, **{name: target})
    assert result.contacts > 10
    assert np.array_equal(result.pressure, expected)

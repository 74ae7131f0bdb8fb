"""Arrays on a device: stand-ins that only the host build of the plugin for devices can read."""

import ctypes
import os
import pathlib

import numpy as np
import pytest
from conftest import MODULUS, PITCH, refused

import roughcontact as rc
from roughcontact import _device

ABOVE = 1 << 62  # where this build has the addresses of a device
PAIR = {"solver": "haar-cuda-host", "backend": "cuda-host"}


@pytest.fixture(scope="module")
def context():
    folder = pathlib.Path(os.environ.get("ROUGHCONTACT_LIBRARY", "")).parent / "test-plugins"
    if not list(folder.glob("rcb_cuda_host.*")):
        pytest.skip("the host build of the plugin for devices is not there")
    return rc.Context(plugin_path=str(folder))


@pytest.fixture(autouse=True)
def host_in_the_place_of_a_device(monkeypatch):
    monkeypatch.setattr(_device, "BACKENDS", {2: b"cuda-host"})


class Package:
    """What makes arrays: as NumPy's asarray, with a device."""

    def __init__(self, kind):
        self.kind = kind

    def asarray(self, values, device):
        return self.kind(np.array(values), device)


class Exported:
    """As arrays of PyTorch and JAX are: by DLPack."""

    def __init__(self, values, device="the device"):
        self.values, self.device, self.exports = values, device, 0
        self.shape, self.dtype = values.shape, values.dtype

    def __dlpack_device__(self):
        return 2, 0

    def __dlpack__(self, stream=None):
        self.exports += 1
        capsule = self.values.__dlpack__()
        find = ctypes.pythonapi.PyCapsule_GetPointer
        find.restype, find.argtypes = ctypes.c_void_p, [ctypes.py_object, ctypes.c_char_p]
        tensor = ctypes.cast(find(capsule, b"dltensor"), ctypes.POINTER(_device._Tensor)).contents
        tensor.data, tensor.device_type = tensor.data + ABOVE, 2
        return capsule

    def __array_namespace__(self):
        return Package(Exported)

    def __array__(self, *_):
        raise TypeError("the array is on a device")

    def cpu(self):
        return self.values


class Current:
    """CuPy's devices: arrays are made on the one that is current."""

    entered = 0

    def __enter__(self):
        Current.entered += 1

    def __exit__(self, *_):
        Current.entered -= 1


class Interfaced:
    """As arrays of CuPy were before DLPack."""

    def __init__(self, values):
        self.values, self.device = values, Current()

    @property
    def __cuda_array_interface__(self):
        about = dict(self.values.__array_interface__)
        about["data"] = (about["data"][0] + ABOVE, False)
        return about

    def __array_namespace__(self):
        class CuPy:
            @staticmethod
            def asarray(values):
                assert Current.entered == 1
                return Interfaced(np.array(values))

        return CuPy

    def get(self):
        return self.values


def solved(gap, context, **more):
    arguments = {"pitch": PITCH, "modulus": MODULUS, "approach": 3e-7, "options": PAIR, "context": context, **more}
    return rc.solve(undeformed_gap=gap, **arguments)


@pytest.mark.parametrize("kind", [Exported, Interfaced])
@pytest.mark.parametrize("width", [np.float64, np.float32])
def test_answers_are_arrays_there(kind, width, sphere_gap, context):
    gap = sphere_gap.astype(width)
    there = solved(kind(gap), context, want_gap=True)
    here = solved(gap.astype(float), context, want_gap=True)
    for name in ("pressure", "gap"):
        array = getattr(there, name)
        assert isinstance(array, kind) and array.values.dtype == width
        assert np.array_equal(array.values, getattr(here, name).astype(width))
    assert there.load == here.load


def test_masks_and_starts_go_to_the_device(sphere_gap, context):
    mask = np.ones(sphere_gap.shape, bool)
    mask[30:34, 20:40] = False
    start = np.full(sphere_gap.shape, 1e6)
    here = solved(sphere_gap, context, mask=mask, start=start)
    assert np.array_equal(solved(Exported(sphere_gap), context, mask=mask, start=start).pressure.values, here.pressure)
    assert np.array_equal(
        solved(Exported(sphere_gap), context, mask=Exported(mask), start=Exported(start)).pressure.values, here.pressure
    )


def test_a_contact_keeps_the_gap_of_a_step(half_space, sphere_gap, context):
    with rc.Contact(half_space, options=PAIR, context=context) as contact:
        gap = Exported(sphere_gap)
        first = contact.solve(undeformed_gap=gap, approach=3e-7, borrow=True)
        again = contact.solve(approach=3e-7, warm_start=False)
    assert gap.exports == 1 and isinstance(again.pressure, np.ndarray)
    assert np.array_equal(first.pressure.values, again.pressure)


def test_answers_there_can_be_looked_at(sphere_gap, context, tmp_path):
    there, here = solved(Exported(sphere_gap), context), solved(sphere_gap, context)
    assert (
        there.measure_area() == here.measure_area()
        and there.patches == here.patches
        and there._repr_html_() == here._repr_html_()
    )
    there.save(tmp_path / "answer.npz")
    assert np.array_equal(rc.load(tmp_path / "answer.npz").pressure, here.pressure)


def test_other_functions_copy_them(sphere_gap, context):
    arguments = {"pitch": PITCH, "modulus": MODULUS, "approach": [1e-7, 3e-7], "context": context}
    there = rc.history(undeformed_gap=Exported(sphere_gap), **arguments)
    assert np.array_equal(there.load, rc.history(undeformed_gap=sphere_gap, **arguments).load)


def test_what_cannot_be_handed_over_is_refused(sphere_gap, context, monkeypatch):
    refused(rc.ArgumentError, "not in C order", solved, Exported(sphere_gap[:, ::2]), context)
    refused(TypeError, "neither float64 nor float32", solved, Exported(sphere_gap.astype(np.int64)), context)
    refused(rc.ShapeError, "has shape", rc.Contact(rc.HalfSpace((8, 8), pitch=1.0, modulus=1.0, boundary="free")).solve,
            undeformed_gap=Exported(sphere_gap), approach=1.0)  # fmt: skip
    monkeypatch.setattr(_device, "BACKENDS", {})
    refused(rc.ArgumentError, "kind 2, which no backend reaches", solved, Exported(sphere_gap), context)
    monkeypatch.setattr(_device, "BACKENDS", {2: b"dense"})
    refused(rc.IncompatibleError, "no device with a memory of its own", solved, Exported(sphere_gap), context)


def test_a_batch_is_solved_at_once_where_nobody_looks_at_each_step(context):
    gaps = np.stack([gap * k for k in (1.0, 1.2, 1.4) for gap in [rc.surface.spectral((24, 24), seed=1).undeformed_gap()]])
    how = dict(pitch=PITCH, modulus=MODULUS, boundary="free", load=1e6, context=context, keep_pressure=True, **PAIR)
    together = rc.batch(undeformed_gap=gaps, **how)
    alone = rc.batch(undeformed_gap=gaps, each=lambda *_: None, **how)
    assert together.certified == alone.certified == 3
    # The one gives other bits than the other, with the same certificate.
    assert np.allclose(together.pressure, alone.pressure, atol=1e-4 * alone.pressure.max())
    assert not np.array_equal(together.pressure, alone.pressure)


def test_a_progress_bar_does_not_part_a_batch(context, monkeypatch):
    seen = []
    monkeypatch.setattr("roughcontact._batch.Bars.show", lambda _, ended: seen.append(ended))
    gaps = np.stack([rc.surface.spectral((24, 24), seed=k).undeformed_gap() for k in range(3)])
    rc.batch(undeformed_gap=gaps, pitch=PITCH, modulus=MODULUS, boundary="free", load=[1e-4, 1e-3], context=context, **PAIR)
    assert seen == [6]

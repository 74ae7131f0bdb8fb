"""Arrays in a device's memory: those of CuPy, PyTorch, JAX and others that describe theirs by DLPack or the CUDA array interface."""

import ctypes
import importlib
from dataclasses import dataclass
from typing import Any, ClassVar, Dict, List, Optional, Tuple

import numpy as np
from numpy.typing import NDArray

from ._errors import ArgumentError, ShapeError

#: backends by the numbers that DLPack has for the devices whose memory they reach
BACKENDS: Dict[int, bytes] = {2: b"cuda", 13: b"cuda"}
ON_HOST = (1, 3)  # the host's memory, pinned or not
TYPES = {(2, 64): "float64", (2, 32): "float32", (1, 8): "uint8", (6, 8): "uint8"}  # a truth value is a byte, 0 or 1


class _Tensor(ctypes.Structure):
    """DLTensor, the first member of DLManagedTensor."""

    _fields_: ClassVar[List[Tuple[str, Any]]] = [
        ("data", ctypes.c_void_p),
        ("device_type", ctypes.c_int32),
        ("device_id", ctypes.c_int32),
        ("ndim", ctypes.c_int32),
        ("code", ctypes.c_uint8),
        ("bits", ctypes.c_uint8),
        ("lanes", ctypes.c_uint16),
        ("shape", ctypes.POINTER(ctypes.c_int64)),
        ("strides", ctypes.POINTER(ctypes.c_int64)),
        ("byte_offset", ctypes.c_uint64),
    ]


@dataclass(frozen=True)
class DeviceArray:
    """A C-ordered array there. like: as it was given; keeper: what must live as long as the address is used."""

    address: int
    shape: Tuple[int, ...]
    dtype: str
    memory: bytes
    like: Any
    keeper: Any

    @property
    def ndim(self) -> int:
        return len(self.shape)


def _device_of(values: Any) -> Optional[int]:
    """DLPack's number; None: NumPy can read it."""
    if isinstance(values, (np.ndarray, DeviceArray)):
        return None
    if hasattr(values, "__dlpack_device__"):
        kind = int(values.__dlpack_device__()[0])
        return None if kind in ON_HOST else kind
    return 2 if hasattr(values, "__cuda_array_interface__") else None


def on_host(values: Any) -> Any:
    """A copy on the host of an array that is on a device; all else as it is."""
    if _device_of(values) is None:
        return values
    for leave in ("get", "cpu"):  # CuPy, PyTorch
        if hasattr(values, leave):
            return np.asarray(getattr(values, leave)())
    return np.asarray(values)  # JAX


def _by_dlpack(values: Any) -> Tuple[int, Tuple[int, ...], Any, str, Any]:
    """(address, shape, steps between neighbours or None, type, what keeps them)"""
    capsule = values.__dlpack__()
    find = ctypes.pythonapi.PyCapsule_GetPointer
    find.restype, find.argtypes = ctypes.c_void_p, [ctypes.py_object, ctypes.c_char_p]
    tensor = ctypes.cast(find(capsule, b"dltensor"), ctypes.POINTER(_Tensor)).contents
    kind = TYPES.get((tensor.code, tensor.bits), "") if tensor.lanes == 1 else ""
    steps = tuple(tensor.strides[: tensor.ndim]) if tensor.strides else None
    return (tensor.data or 0) + tensor.byte_offset, tuple(tensor.shape[: tensor.ndim]), steps, kind, capsule


def _by_cuda(values: Any) -> Tuple[int, Tuple[int, ...], Any, str, Any]:
    """The same by the CUDA array interface."""
    about = values.__cuda_array_interface__
    dtype = np.dtype(about["typestr"])
    steps = about.get("strides")
    kind = "uint8" if dtype == bool else dtype.name
    return about["data"][0], tuple(about["shape"]), steps and tuple(n // dtype.itemsize for n in steps), kind, values


def device_array(values: Any, name: str) -> Optional[DeviceArray]:
    """None where it is not on a device."""
    if isinstance(values, DeviceArray):
        return values
    device = _device_of(values)
    if device is None:
        return None
    if device not in BACKENDS:
        raise ArgumentError(f"{name} is on a device of DLPack's kind {device}, which no backend reaches; copy it to the host")
    described = _by_dlpack(values) if hasattr(values, "__dlpack__") else _by_cuda(values)
    address, shape, steps, kind, keeper = described
    if kind not in TYPES.values():
        raise TypeError(f"{name} is on a device and holds neither float64 nor float32, nor bytes for a mask")
    expected = tuple(int(np.prod(shape[k + 1 :])) for k in range(len(shape)))
    if steps is not None and any(n > 1 and step != wanted for n, step, wanted in zip(shape, steps, expected)):
        raise ArgumentError(f"{name} is on a device and not in C order; make it contiguous there")
    return DeviceArray(address, shape, kind, BACKENDS[device], values, keeper)


def in_shape(array: DeviceArray, name: str, shape: Tuple[int, ...]) -> DeviceArray:
    if array.shape != shape:
        raise ShapeError(f"{name} has shape {array.shape}, the grid {shape}")
    return array


def package_of(like: Any) -> Any:
    """The module that makes arrays of this kind."""
    if hasattr(like, "__array_namespace__"):
        return like.__array_namespace__()
    module = importlib.import_module(type(like).__module__.partition(".")[0])
    if not hasattr(module, "asarray"):
        raise ArgumentError(
            f"{module.__name__} has no asarray, by which answers would become its arrays; pass an array of CuPy"
        )
    return module


def in_kind(values: NDArray[Any], like: Any) -> Any:
    """values as an array of the package that made `like`, on its device."""
    package = package_of(like)
    try:
        return package.asarray(values, device=like.device)
    except TypeError:  # CuPy's arrays come to the device that is current
        with like.device:
            return package.asarray(values)

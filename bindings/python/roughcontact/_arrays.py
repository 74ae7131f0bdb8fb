"""Arrays of any order, type and kind as the library wants them, copied only where they differ from that."""

import ctypes
import operator
from typing import Any, Optional, Sequence, Tuple, Type, TypeVar, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._c import S, bytes_, ctype, doubles, integers, singles, statuses
from ._constants import RC_NATIVE, RC_SINGLE
from ._data_arrays import in_order
from ._device import DeviceArray, on_host
from ._errors import ArgumentError, RoughContactError, ShapeError
from ._structs import rc_array, rc_const_array

_KINDS = {"float64": doubles, "float32": singles, "int64": integers, "int32": statuses, "uint8": bytes_}
_SINGLE = (np.dtype(np.float32), "float32")  # as NumPy and as arrays on a device say it
_POINTERS = {np.dtype(name): ctype(kind) for name, kind in _KINDS.items()}
Doubles = NDArray[np.float64]
Reals = Union[Doubles, NDArray[np.float32]]
Mask = NDArray[np.uint8]
Shape = Tuple[int, ...]
Pitch = Union[float, Sequence[float]]


def as_int(value: Any, name: str, bits: int = 64) -> int:
    """value as a signed whole number of that size (bits: 32 or 64). ctypes would drop the bits that are too many."""
    try:
        number = operator.index(value)
    except TypeError:
        raise ArgumentError(f"{name} is {value!r}; a whole number is needed") from None
    limit = 2 ** (bits - 1)
    if not -limit <= number < limit:
        raise ArgumentError(f"{name} is {number}; the library takes {-limit} .. {limit - 1}")
    return number


def as_switch(value: Optional[bool]) -> Optional[int]:
    """1 or 0 as C has it; None stays."""
    return None if value is None else int(bool(value))


def as_text(value: str, name: str, error: Type[RoughContactError] = ArgumentError) -> bytes:
    """value as C reads it, which ends at the first NUL."""
    try:
        text = value.encode()
    except UnicodeEncodeError:
        raise error(f"{name} is {value!r}, which is not text: it has half of a surrogate pair") from None
    if b"\0" in text:
        raise error(f"{name} is {value!r}; text with a NUL character cannot be passed on")
    return text


def as_seed(value: Any) -> Optional[int]:
    """A whole number of 64 bits without a sign; None stays."""
    if value is None:
        return None
    try:
        number = operator.index(value)
    except TypeError:
        raise ArgumentError(f"seed is {value!r}; a whole number is needed") from None
    if not 0 <= number < 2**64:
        raise ArgumentError(f"seed is {number}; the library takes 0 .. {2**64 - 1}")
    return number


def as_doubles(values: ArrayLike, name: str, shape: Optional[Shape] = None) -> Doubles:
    """values as a C-ordered array of doubles; the same memory if they are one already."""
    found: Doubles = as_reals(values, name, shape, single=False)
    return found


def as_reals(values: ArrayLike, name: str, shape: Optional[Shape], single: bool) -> Any:
    """values as a C-ordered array of doubles, or of float32; the same memory if they are one already. From a device: a copy."""
    if type(values) is np.ndarray and values.dtype == (np.float32 if single else np.float64) and values.flags.carray:
        array: Any = values  # most callers': no question need be asked
    else:
        array, absent = _numbers(values, name)
        if absent is not None:
            raise ArgumentError(
                f"{name} is a masked array with {int(absent.sum())} masked values: pass mask=, which "
                "is 0 where a point takes no part, or heights with missing='exclude'"
            )
        if array.dtype.kind not in "fiub":
            raise TypeError(f"{name} holds {array.dtype}; real numbers are needed")
        array = np.require(array, np.float32 if single else np.float64, ["C", "A"]).reshape(array.shape)
    if shape is not None and array.shape != shape:
        raise ShapeError(f"{name} has shape {array.shape}, the grid {shape}")
    return array


def without_masked(values: ArrayLike, name: str) -> Tuple[Doubles, Optional[NDArray[np.bool_]]]:
    """values as `as_doubles` has them, and where they are masked; None: nowhere."""
    array, absent = _numbers(values, name)
    return as_doubles(array, name), absent


def _numbers(values: Any, name: str) -> Tuple[NDArray[Any], Optional[NDArray[np.bool_]]]:
    """values as an array with x along its last axis, and where they are masked; None: nowhere."""
    values = in_order(on_host(values))
    if isinstance(values, (list, tuple)) and any(np.ma.isMaskedArray(each) for each in values):
        values = np.ma.stack(values)  # NumPy would forget the masks
    absent = np.ma.getmaskarray(values) if np.ma.isMaskedArray(values) else None
    try:
        array = np.asarray(np.ma.getdata(values) if absent is not None else values)
    except ValueError as error:
        raise ShapeError(f"{name} is not an array of numbers: {error}") from None
    if array.dtype.kind == "O" and not any(value is None for value in array.flat):
        try:
            array = _from_table(values) if hasattr(values, "to_numpy") else array.astype(np.float64)
        except (TypeError, ValueError):
            pass
    return array, absent if absent is not None and absent.any() else None


def _from_table(values: Any) -> NDArray[Any]:
    """The numbers of a DataFrame, NaN where pandas has its own mark of a missing one."""
    found: NDArray[Any] = values.to_numpy(np.float64, na_value=np.nan)
    return found


def as_mask(values: Optional[ArrayLike], name: str, shape: Optional[Shape] = None) -> Optional[Mask]:
    """1 where a value is true."""
    if values is None:
        return None
    array = np.asarray(in_order(on_host(values)))
    if array.dtype.kind not in "biu":
        raise TypeError(f"{name} holds {array.dtype}; bool or integers are needed: 0 where a point takes no part")
    array = np.ascontiguousarray(array != 0).view(np.uint8)
    if shape is not None and array.shape != shape:
        raise ShapeError(f"{name} has shape {array.shape}, the grid {shape}")
    return array


def as_pitch(pitch: Pitch) -> Tuple[float, float]:
    """(hx, hy)"""
    refuse_text("pitch", pitch)
    sides = np.atleast_1d(np.asarray(pitch, dtype=np.float64)).tolist()
    if len(sides) not in (1, 2):
        raise ShapeError(f"pitch has {len(sides)} values: one, or (hx, hy) with hx along the last axis")
    return float(sides[0]), float(sides[-1])


def refuse_text(name: str, value: Any) -> None:
    """Texts with units are words: functions that take numbers alone name the call that reads them."""
    if isinstance(value, str):
        raise ArgumentError(f"{name} is {value!r}: give a number; solve, law, prepare and budget read texts with units")


def refuse_one_row(array: NDArray[Any], name: str, pitch: Any, axes: int = 1) -> None:
    """Arrays with so few axes are rows of cells, whose width has to be said: by a pitch of two numbers."""
    if array.ndim == axes and pitch is not None and np.ndim(pitch) == 0:
        raise ArgumentError(
            f"{name} has one axis: give pitch=(hx, hy), hy being the width of that row of points, or an array [ny, nx]"
        )


def as_shape(shape: Union[int, Sequence[int]]) -> Shape:
    """(ny, nx) or (nx,)"""
    each = tuple(shape) if isinstance(shape, (Sequence, np.ndarray)) and np.ndim(shape) else (shape,)
    sides = tuple(as_int(n, "a side of the shape") for n in each)
    if len(sides) not in (1, 2):
        raise ShapeError(f"shape {sides} has {len(sides)} axes: one, or (ny, nx)")
    return sides


def columns_and_rows(shape: Shape) -> Tuple[int, int]:
    """(nx, ny); a one-dimensional array is one row."""
    return shape[-1], shape[0] if len(shape) == 2 else 1


def pointer(array: Optional[NDArray[Any]]) -> Any:
    """A pointer to an array's first element; None for None. The array must be kept as long as the pointer is used."""
    return None if array is None else array.ctypes.data_as(_POINTERS[array.dtype])


def doubles_at(array: Union[rc_array, rc_const_array], shape: Shape) -> Doubles:
    """The C library's array of doubles, not copied."""
    return np.ctypeslib.as_array(ctypes.cast(array.data, ctypes.POINTER(ctypes.c_double)), shape)


A = TypeVar("A", rc_array, rc_const_array)


def _describe(array: A, values: Any) -> A:
    """values: kept as long as the struct; a member of another struct keeps nothing."""
    if values is None:
        return array
    array.kept = values
    array.type = RC_SINGLE if values.dtype in _SINGLE else RC_NATIVE
    if isinstance(values, DeviceArray):
        array.data, array.memory = values.address, values.memory
    else:
        array.data = values.ctypes.data
    return array


def array_in(values: Optional[NDArray[Any]]) -> rc_const_array:
    """An array that the library reads; None: none."""
    return _describe(rc_const_array(), values)


def array_out(values: Optional[NDArray[Any]]) -> rc_array:
    """The same of an array that the library writes."""
    return _describe(rc_array(), values)


def given(members: S, **values: Any) -> S:
    """Sets members of a struct, of arrays to their address; those that are None stay as they are. The struct keeps the arrays."""
    members.kept = (members.kept, values)
    for name, value in values.items():
        if isinstance(value, (np.ndarray, DeviceArray)):
            member: Any = getattr(members, name)
            described = type(member) in (rc_array, rc_const_array)
            if described:
                _describe(member, value)
            else:
                setattr(members, name, pointer(value))  # type: ignore[arg-type]
        elif value is not None:
            setattr(members, name, value)
    return members

"""Files of heights: Gwyddion Simple Field, NetCDF as contact.engineering has it, and NumPy's arrays."""

import io
import math
import os
import struct
import warnings
from typing import IO, Dict, Optional, Sequence, Tuple, Union

import numpy as np

from ._arrays import Doubles, pointer
from ._calls import check_formats
from ._constants import RC_SURFACE_FORM_PLANE
from ._errors import ArgumentError
from ._library import formats_library
from ._paths import Path, write_file
from ._units import metres_of


def _largest(values: Doubles) -> float:
    return float(np.max(np.abs(values[~np.isnan(values)]), initial=0.0))


def _rounding(heights: Doubles) -> float:
    """The largest error of heights in single precision."""
    with np.errstate(over="ignore"):
        return _largest(heights.astype(np.float32) - heights)


def _roughness(heights: Doubles) -> float:
    """rms about the mean plane"""
    flat, (ny, nx) = heights.copy(), heights.shape
    check_formats(formats_library().rc_surface_remove_form(nx, ny, RC_SURFACE_FORM_PLANE, pointer(flat)))
    largest = _largest(flat)
    return largest * math.sqrt(np.nanmean((flat / largest) ** 2)) if largest > 0 else 0.0


def _write_gsf(
    file: IO[bytes], heights: Doubles, pitch: Tuple[float, float], unit: Optional[str], periodic: Optional[bool]
) -> None:
    """Heights less their mean where rounding would change the roughness; the file says so."""
    noticed, round_off = 1e-4, 1e-12  # shares of the roughness, and of the heights where a plane has no more
    metres = metres_of(unit or "m")
    (ny, nx), (hx, hy) = heights.shape, pitch
    heights = np.where(np.isfinite(heights), heights * metres, np.nan)
    roughness = _roughness(heights)
    plain, offset = _rounding(heights), 0.0
    if plain > noticed * roughness:
        mean = float(np.nanmean(heights))
        offset = mean if _rounding(heights - mean) < plain / 2 else 0.0
    heights = heights - offset
    largest, error = _largest(heights), _rounding(heights)
    if not error <= 1e-6 * largest:
        raise ArgumentError("the heights are beyond the range of single precision, which a .gsf file has")
    if roughness > round_off * largest and error > noticed * roughness:
        warnings.warn(
            f"single precision, which a .gsf file has, changes heights by up to {error / roughness:.2g} of their roughness; "
            "a .nc file keeps them",
            stacklevel=4,
        )
    single = heights.astype("<f4")
    lines = ["Gwyddion Simple Field 1.0", f"XRes = {nx}", f"YRes = {ny}"]
    lines += [f"XReal = {hx * metres * nx!r}", f"YReal = {hy * metres * ny!r}"]
    lines += [] if unit is None else ["XYUnits = m", "ZUnits = m"]
    lines += [] if periodic is None else [f"Periodic = {int(periodic)}"]
    lines += [f"ZOffset = {offset!r}"] if offset else []
    header = "".join(line + "\n" for line in lines).encode("ascii")
    file.write(header + b"\0" * (4 - len(header) % 4) + single.tobytes())


def _named(name: str) -> bytes:
    text = name.encode("ascii")
    return struct.pack(">i", len(text)) + text + b"\0" * (-len(text) % 4)


def _attribute(name: str, value: Union[str, int, float]) -> bytes:
    """An attribute of type char, int or double."""
    if isinstance(value, str):
        return _named(name) + struct.pack(">i", 2) + _named(value)
    kind, form = (4, ">i") if isinstance(value, int) else (6, ">d")
    return _named(name) + struct.pack(">ii", kind, 1) + struct.pack(form, value)


def _listed(tag: int, items: Sequence[bytes]) -> bytes:
    return struct.pack(">ii", tag if items else 0, len(items)) + b"".join(items)


def _write_netcdf(
    file: IO[bytes], heights: Doubles, pitch: Tuple[float, float], unit: Optional[str], periodic: Optional[bool]
) -> None:
    """The classic format with offsets of 64 bits."""
    known: Dict[str, Union[str, int, float]] = {}
    if unit is not None:
        metres = metres_of(unit)
        heights, pitch, known["unit"] = heights * metres, (pitch[0] * metres, pitch[1] * metres), "m"
    lateral = known if periodic is None else {**known, "periodic": int(periodic)}
    axes = [("x", heights.shape[1], pitch[0]), ("y", heights.shape[0], pitch[1])]
    dimensions = _listed(10, [_named(name) + struct.pack(">i", points) for name, points, _ in axes])
    variables = [(name, [k], {"length": h * n, **lateral}, h * np.arange(n)) for k, (name, n, h) in enumerate(axes)]
    variables.append(("heights", [1, 0], known, heights))

    def header(at: int) -> bytes:
        entries = []
        for name, shape, attributes, values in variables:
            about = _listed(12, [_attribute(key, value) for key, value in attributes.items()])
            size = min(values.size * 8, 2**32 - 1)
            entry = _named(name) + struct.pack(f">{1 + len(shape)}i", len(shape), *shape) + about
            entries.append(entry + struct.pack(">iIq", 6, size, at))
            at += values.size * 8
        return b"CDF\2" + struct.pack(">i", 0) + dimensions + _listed(12, []) + _listed(11, entries)

    file.write(header(len(header(0))))
    for *_, values in variables:
        file.write(np.ascontiguousarray(values, ">f8").data)


def save_surface(
    path: Path, heights: Doubles, pitch: Tuple[float, float], unit: Optional[str], periodic: Optional[bool]
) -> None:
    """heights: [ny, nx], NaN where a point is missing."""
    suffix = os.path.splitext(os.fsdecode(path))[1].lower()
    if suffix not in (".gsf", ".nc", ".npy"):
        raise ArgumentError(f"{os.fsdecode(path)}: the file's name must end in .gsf, .nc or .npy")
    if unit is not None and suffix != ".npy":
        metres_of(unit)
    file = io.BytesIO()
    if suffix == ".npy":
        np.save(file, heights)
    else:
        (_write_gsf if suffix == ".gsf" else _write_netcdf)(file, heights, pitch, unit, periodic)
    write_file(path, file.getvalue())

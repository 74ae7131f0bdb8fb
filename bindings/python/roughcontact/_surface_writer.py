"""Files of heights: Gwyddion Simple Field, NetCDF as contact.engineering has it, and NumPy's arrays."""

import os
import struct
from typing import IO, Dict, Optional, Sequence, Tuple, Union

import numpy as np

from ._arrays import Doubles
from ._errors import ArgumentError
from ._units import metres_of
from ._whole_file import whole_file


def _write_gsf(
    file: IO[bytes], heights: Doubles, pitch: Tuple[float, float], unit: Optional[str], periodic: Optional[bool]
) -> None:
    metres = metres_of(unit or "m")
    (ny, nx), (hx, hy) = heights.shape, pitch
    with np.errstate(over="ignore"):  # checked below
        single = (heights * metres).astype("<f4")
    known = heights[np.isfinite(heights)] * metres
    kept = single[np.isfinite(heights)].astype(np.float64)
    if known.size and not np.abs(kept - known).max() <= 1e-6 * np.abs(known).max():
        raise ArgumentError("the heights are beyond the range of single precision, which a .gsf file has")
    lines = ["Gwyddion Simple Field 1.0", f"XRes = {nx}", f"YRes = {ny}"]
    lines += [f"XReal = {hx * metres * nx!r}", f"YReal = {hy * metres * ny!r}"]
    lines += [] if unit is None else ["XYUnits = m", "ZUnits = m"]
    lines += [] if periodic is None else [f"Periodic = {int(periodic)}"]
    header = "".join(line + "\n" for line in lines).encode("ascii")
    file.write(header + b"\0" * (4 - len(header) % 4) + single.tobytes())


def _named(name: str) -> bytes:
    text = name.encode("ascii")
    return struct.pack(">i", len(text)) + text + b"\0" * (-len(text) % 4)


def _attribute(name: str, value: Union[str, int, float]) -> bytes:
    """Of type char, int or double."""
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
    path: str, heights: Doubles, pitch: Tuple[float, float], unit: Optional[str], periodic: Optional[bool]
) -> None:
    """heights: [ny, nx], NaN where a point is missing."""
    suffix = os.path.splitext(path)[1].lower()
    if suffix not in (".gsf", ".nc", ".npy"):
        raise ArgumentError(f"{path}: the file's name must end in .gsf, .nc or .npy")
    if unit is not None and suffix != ".npy":
        metres_of(unit)
    with whole_file(path) as file:
        if suffix == ".npy":
            np.save(file, heights)
        else:
            (_write_gsf if suffix == ".gsf" else _write_netcdf)(file, heights, pitch, unit, periodic)

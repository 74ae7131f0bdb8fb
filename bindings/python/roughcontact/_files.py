"""Surfaces from files."""

import importlib
import io
import os
import pathlib
from dataclasses import dataclass
from typing import IO, Any, List, Optional, Tuple, Union, cast

import numpy as np

from ._arrays import Pitch, as_pitch, as_text, given
from ._calls import check_formats, of_a_file, short_traceback
from ._errors import ArgumentError
from ._data_arrays import METRES
from ._height_map import Surface
from ._library import formats_library
from ._structs import rc_surface_file, rc_surface_format, rc_surface_read_spec

PACKAGE = "SurfaceTopography"
File = Union[str, "os.PathLike[str]", bytes, IO[bytes]]


def is_file(thing: Any) -> bool:
    """Whether it names a file or is an open one."""
    return isinstance(thing, (str, os.PathLike)) or callable(getattr(thing, "read", None))


@dataclass(frozen=True)
class Format:
    """A format that `read` reads. suffixes: of files' names; says: the lengths that such a file contains."""

    name: str
    summary: str
    suffixes: Tuple[str, ...]
    says: str


def formats() -> List[Format]:
    """The formats that `read` reads without other packages."""
    library, found = formats_library(), []
    for index in range(library.rc_surface_format_count()):
        each = rc_surface_format()
        check_formats(library.rc_surface_format_describe(index, each))
        words = [value.decode() for value in (each.name, each.summary, each.suffixes, each.says)]
        found.append(Format(words[0], words[1], tuple(words[2].split()), words[3]))
    return found


@short_traceback
def read(file: File, *, pitch: Optional[Pitch] = None, unit: Optional[str] = None, format: Optional[str] = None) -> Surface:
    """A surface from a file; heights and pitch in metres, NaN where a point is missing.

    file: a path, an open binary file, or the bytes of one
    pitch: one number or (hx, hy) [unit]; needed if the file has none, otherwise replaces the file's
    unit: of lengths whose unit the file does not name, and of pitch: "um"; None: "m"
    format: one of `formats()`, or one of the package SurfaceTopography ("opd"); None: by the contents, else by the suffix

    `assumed` of the surface lists what the file leaves open. A file whose suffix or format is none of `formats()` is read by the
    package SurfaceTopography if it is installed; `assumed` then says so as well.
    """
    return surface_in(file, pitch, unit, format)


def surface_in(
    file: File,
    pitch: Optional[Pitch] = None,
    unit: Optional[str] = None,
    format: Optional[str] = None,
    otherwise: Optional[Pitch] = None,
) -> Surface:
    """`read`, with a pitch in metres for files that do not say theirs."""
    spec = given(rc_surface_read_spec(), format=_text(format, "format"), unit=_text(unit, "unit"))
    if pitch is not None:
        spec.hx, spec.hy = as_pitch(pitch)
    library, out = formats_library(), rc_surface_file()
    contents = file if isinstance(file, bytes) else None
    named: Any = "" if isinstance(file, bytes) else getattr(file, "name", "") if _is_open(file) else file
    name = os.fsdecode(named) if isinstance(named, (str, bytes, os.PathLike)) else ""
    if _is_open(file):
        contents = cast(IO[bytes], file).read()
        if not isinstance(contents, bytes):
            raise ArgumentError("the file is open as text; open it with mode 'rb'")
    elif contents is None:
        try:
            with open(name, "rb"):  # Python's exception where that is not possible
                pass
        except OSError as error:
            raise of_a_file(error) from None
    if contents is None:
        status = library.rc_surface_read(os.fsencode(name), spec, out)
    else:
        status = library.rc_surface_read_memory(contents, len(contents), os.fsencode(name), spec, out)
    try:
        check_formats(status)
    except ArgumentError as error:
        known = formats()
        if format is None:
            mine = pathlib.Path(name).suffix.lower() in {suffix for each in known for suffix in each.suffixes}
        else:
            mine = format in {each.name for each in known}
        if mine and PACKAGE not in str(error):
            raise
        source = name if contents is None else io.BytesIO(contents)
        return _read_by_surface_topography(source, name, pitch, unit, format, otherwise, error)
    try:
        heights = np.ctypeslib.as_array(out.heights, (out.ny, out.nx)).copy()
        assumed, sides = out.assumed.decode(errors="replace"), (out.hx, out.hy)
        periodic = None if out.periodic < 0 else bool(out.periodic)
    finally:
        library.rc_surface_file_free(out)
    if not min(sides) > 0:
        sides = _pitch_or_error(otherwise, name)
    return Surface(heights, sides, periodic, None, "m", assumed)


def _pitch_or_error(pitch: Optional[Pitch], name: str) -> Tuple[float, float]:
    if pitch is None:
        raise ArgumentError(f"{name or 'the file'}: the file does not say its pitch; give pitch=, one number or (hx, hy)")
    return as_pitch(pitch)


def _is_open(file: Any) -> bool:
    return callable(getattr(file, "read", None))


def _text(value: Optional[str], name: str) -> Optional[bytes]:
    return None if value is None else as_text(value, name)


def _read_by_surface_topography(
    file: Any,
    name: str,
    pitch: Optional[Pitch],
    unit: Optional[str],
    format: Optional[str],
    otherwise: Optional[Pitch],
    error: ArgumentError,
) -> Surface:
    """error: why this library does not read the file."""
    try:
        package = importlib.import_module(PACKAGE)
    except ImportError:
        known = PACKAGE in str(error)
        more = f"{PACKAGE} is not installed" if known else f"the package {PACKAGE}, which is not installed, reads more formats"
        raise ArgumentError(f"{error}; {more}") from None
    try:
        reader = package.open_topography(file, format=format)
        channel = reader.default_channel
        own, sizes, points = channel.unit, channel.physical_sizes, channel.nb_grid_pts
        if len(points) != 2:
            raise ArgumentError("it holds a profile; a map is needed")
        topography = reader.topography(**({} if sizes is not None else {"physical_sizes": tuple(map(float, points))}))
        heights = np.ma.filled(np.ma.asarray(topography.heights(), np.float64), np.nan).T  # its x is the first axis
    except Exception as other:
        raise ArgumentError(f"{error}; nor does SurfaceTopography: {type(other).__name__}: {other}") from other
    factor = METRES.get(str(own or unit or "m"))
    if factor is None:
        raise ArgumentError(f"{name}: the unit {own or unit!r} is not a length unit; one of {', '.join(METRES)} is needed")
    if pitch is not None:
        hx, hy = (side * METRES[unit or "m"] for side in as_pitch(pitch))
    elif sizes is not None:
        hx, hy = sizes[0] / heights.shape[1] * factor, sizes[1] / heights.shape[0] * factor
    else:
        hx, hy = _pitch_or_error(otherwise, name)
    assumed = f"read by the package SurfaceTopography, as {reader.format()}"
    assumed += "" if own else "; lengths without a unit are in " + (unit or "m")
    periodic = getattr(topography, "is_periodic", False) or None  # the package says False where a file says nothing
    return Surface(np.ascontiguousarray(heights * factor), (hx, hy), periodic, None, "m", assumed)

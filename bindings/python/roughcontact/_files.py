"""Surfaces from files."""

import importlib
import io
import os
from dataclasses import dataclass
from typing import IO, Any, List, Optional, Tuple, Union, cast

import numpy as np

from ._arrays import Pitch, as_pitch, as_text, given
from ._calls import check_formats, of_a_file, short_traceback
from ._errors import ArgumentError
from ._height_map import Surface, same_pitch
from ._library import formats_library
from ._structs import rc_surface_file, rc_surface_format, rc_surface_read_spec
from ._units import AssumedUnit, metres_of, warn

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
def read(
    file: File,
    *,
    pitch: Optional[Pitch] = None,
    unit: Optional[str] = None,
    format: Optional[str] = None,
    height_range: float = 0.0,
) -> Surface:
    """A surface from a file; heights and pitch in metres, NaN where a point is missing.

    file: a path, an open binary file, or the bytes of one
    pitch: one number or (hx, hy) [unit]; needed if the file has none, otherwise equal to the file's
    unit: of lengths whose unit the file does not name, and of pitch: "um"; None: "m", with an `AssumedUnit` warning if the file
        leaves a unit open
    height_range: height between 0 and the largest value of a picture of whole numbers (TIFF, PNG) [unit]; other files ignore it
    format: one of `formats()`, or one of the package SurfaceTopography ("opd"); None: by the contents, else by the suffix

    `assumed` of the surface lists what the file leaves open. A file whose suffix or format is none of `formats()` is read by the
    package SurfaceTopography if it is installed; `assumed` then says so as well.
    """
    return surface_in(file, pitch, unit, format, height_range=height_range)


def surface_in(
    file: File,
    pitch: Optional[Pitch] = None,
    unit: Optional[str] = None,
    format: Optional[str] = None,
    otherwise: Optional[Pitch] = None,
    height_range: float = 0.0,
) -> Surface:
    """`read`, with a pitch in metres for files that do not say theirs."""
    found, assumes_metres = surface_and_doubt(file, pitch, unit, format, otherwise, height_range)
    if assumes_metres:
        warn(
            f"{name_of(file) or 'the file'} does not name the unit of all its lengths: m is taken; pass unit='m' if that is right, "
            "else their unit",
            AssumedUnit,
        )
    return found


def name_of(file: File) -> str:
    named: Any = "" if isinstance(file, bytes) else getattr(file, "name", "") if _is_open(file) else file
    return os.fsdecode(named) if isinstance(named, (str, bytes, os.PathLike)) else ""


def contents_of(file: File) -> bytes:
    """With Python's exception where it cannot be opened."""
    if isinstance(file, bytes):
        return file
    if _is_open(file):
        contents = cast(IO[bytes], file).read()
        if not isinstance(contents, bytes):
            raise ArgumentError("the file is open as text; open it with mode 'rb'")
        return contents
    try:
        with open(name_of(file), "rb") as stream:
            return stream.read()
    except OSError as error:
        raise of_a_file(error) from None


def surface_and_doubt(
    file: File,
    pitch: Optional[Pitch],
    unit: Optional[str],
    format: Optional[str],
    otherwise: Optional[Pitch],
    height_range: float,
) -> Tuple[Surface, bool]:
    """The surface, and whether metres are assumed for some of its lengths."""
    spec = given(rc_surface_read_spec(), format=_text(format, "format"), unit=_text(unit, "unit"), height_range=height_range)
    if pitch is not None:
        spec.hx, spec.hy = as_pitch(pitch)
    library, out = formats_library(), rc_surface_file()
    name, contents = name_of(file), contents_of(file)
    status = library.rc_surface_read_memory(contents, len(contents), os.fsencode(name), spec, out)
    try:
        check_formats(status)
    except ArgumentError as error:
        # A file that is refused here is not handed to another package: its readers may follow names in the file.
        text = str(error).replace(name, "") if name else str(error)
        unknown = "unknown format" in text or PACKAGE in text
        if not unknown and (format is None or format in {each.name for each in formats()}):
            raise
        source = io.BytesIO(contents) if _is_open(file) or isinstance(file, bytes) else name
        return _read_by_surface_topography(source, name, pitch, unit, format, otherwise, error)
    try:
        heights = np.ctypeslib.as_array(out.heights, (out.ny, out.nx)).copy()
        assumed, sides = out.assumed.decode(errors="replace"), (out.hx, out.hy)
        periodic, unit_assumed = None if out.periodic < 0 else bool(out.periodic), bool(out.unit_assumed)
    finally:
        library.rc_surface_file_free(out)
    if not min(sides) > 0:
        sides = _pitch_or_error(otherwise, name)
    return Surface(heights, sides, periodic, None, "m", assumed), unit_assumed


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
) -> Tuple[Surface, bool]:
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
    factor, bare = metres_of(str(own or unit or "m")), metres_of(unit or "m")
    if own and unit is not None and factor != bare:
        raise ArgumentError(
            f"{name}: the unit of the lengths is {own} in the file, but the unit given is {unit}, which is that of lengths without a "
            "unit; leave it out, or correct the file"
        )
    if sizes is not None:
        hx, hy = sizes[0] / heights.shape[1] * factor, sizes[1] / heights.shape[0] * factor
        sides = (hx, hy) if pitch is None else tuple(side * bare for side in as_pitch(pitch))
        if not same_pitch((hx, hy), (sides[0], sides[1])):
            raise ArgumentError(f"pitch is {sides} m, but {name} has its own, {(hx, hy)} m; leave the pitch out")
    elif pitch is not None:
        hx, hy = (side * bare for side in as_pitch(pitch))
    else:
        hx, hy = _pitch_or_error(otherwise, name)
    assumed = f"read by the package SurfaceTopography, as {reader.format()}"
    assumed += "" if own else "; lengths without a unit are in " + (unit or "m")
    periodic = getattr(topography, "is_periodic", False) or None  # the package says False where a file says nothing
    return Surface(np.ascontiguousarray(heights * factor), (hx, hy), periodic, None, "m", assumed), not own and unit is None

"""Words and maps as libroughcontact-request reads them."""

from __future__ import annotations

import ctypes
import os
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, Dict, List, Mapping, Optional, Sequence, Tuple

import numpy as np

from . import _constants
from ._answers import Stored
from ._arrays import Doubles, Shape, as_doubles, as_mask, as_text, columns_and_rows, pointer, refuse_one_row, without_masked
from ._c import members_for
from ._calls import check
from ._data_arrays import Described, described
from ._device import device_array, on_host
from ._errors import ArgumentError, ShapeError
from ._files import PACKAGE, contents_of, is_file, name_of, surface_in
from ._height_map import Surface
from ._library import request_library
from ._structs import rc_given, rc_map, rc_problem_view, rc_remark, rc_request_spec, rc_smooth


def message_of_request() -> str:
    """Of the last call of this thread."""
    return str(request_library().rc_request_last_error().decode(errors="replace"))


@dataclass(frozen=True)
class Map:
    """A map as C has it; shape: of the array that was given, None where a file is not yet read; keep: what C reads."""

    struct: rc_map
    shape: Optional[Shape]
    keep: Any


def has_methods_of_a_topography(thing: Any) -> bool:
    return callable(getattr(thing, "heights", None)) and hasattr(thing, "physical_sizes")


def pitch_of_topography(thing: Any, shape: Tuple[int, ...]) -> Tuple[float, float]:
    sizes = tuple(float(size) for size in np.atleast_1d(thing.physical_sizes))
    if len(sizes) != len(shape):
        raise ShapeError(f"physical_sizes has {len(sizes)} values, heights() {len(shape)} axes")
    if len(sizes) == 1:
        raise ArgumentError("the topography is a line: give pitch=(hx, hy), hy being the width of its cells")
    return sizes[1] / shape[1], sizes[0] / shape[0]


def _blank(word: str) -> rc_map:
    struct = rc_map()
    struct.word = word.encode()
    return struct


def _file_map(thing: Any, word: str, mask: Any) -> Map:
    struct, contents = _blank(word), contents_of(thing)
    name = os.fsencode(name_of(thing))
    struct.contents, struct.size, struct.name = (
        ctypes.cast(ctypes.c_char_p(contents), ctypes.c_void_p),
        len(contents),
        name or None,
    )
    points = None if mask is None else as_mask(mask, "mask", np.shape(mask))
    if points is not None:
        struct.mask, (struct.nx, struct.ny) = pointer(points), columns_and_rows(points.shape)
    return Map(struct, None, (contents, name, points))


def _described(thing: Any, mask: Any, pitch: Any) -> Tuple[Any, Any, Described, bool]:
    """(heights, mask, what the map says of itself, whether its pitch is rounded)"""
    if isinstance(thing, Surface):
        return (
            thing.heights,
            thing.mask if mask is None else mask,
            Described(thing.pitch[0], thing.pitch[1], thing.unit, thing.periodic),
            False,
        )
    if has_methods_of_a_topography(thing):
        if getattr(thing, "is_uniform", True) is False:
            raise ArgumentError("the topography is not on a uniform grid; interpolate it onto one")
        heights, unit = thing.heights(), getattr(thing, "unit", None)
        repeats = getattr(thing, "is_periodic", False) or None  # False is what the package says where nobody knows
        silent = thing.physical_sizes is None or (pitch is not None and np.ndim(heights) == 1)
        hx, hy = (None, None) if silent else pitch_of_topography(thing, np.shape(heights))
        return heights, mask, Described(hx, hy, unit, repeats), False
    return thing, mask, described(thing) or Described(None, None, None, None), True


def map_of(thing: Any, word: str, mask: Any = None, pitch: Any = None, leading: int = 0) -> Map:
    """Heights of any kind as C has them. leading: axes that count surfaces"""
    name = "undeformed_gap" if word == "gap" else "heights" if word == "surface" else word
    values, mask, says, rounded = _described(thing, mask, pitch)
    there = device_array(values, name) if word == "gap" else None
    struct, keep, absent = _blank(word), [], None
    array: Any = there
    if there is None and word == "gap":
        array = as_doubles(values, name)
    elif there is None:
        array, absent = without_masked(values, name)
    shape = array.shape
    if not 1 <= len(shape) - leading <= 2:
        raise ShapeError(f"{name} have {len(shape)} axes: {leading + 1} or {leading + 2} are needed")
    none = leading > 0 and shape[0] == 0  # C reads at least one map
    if there is None:
        refuse_one_row(array, name, pitch, leading + 1)
        heights = np.zeros((1, *shape[1:])) if none else array if absent is None else np.where(absent, np.nan, array)
        struct.heights = pointer(heights)
        keep.append(heights)
    mask = on_host(mask)
    shared = mask is not None and np.ndim(mask) < len(shape)
    points = as_mask(mask, "mask", shape[leading:] if shared else shape)
    if points is not None and not none:
        points = np.ascontiguousarray(np.broadcast_to(points, shape))
        struct.mask = pointer(points)
        keep.append(points)
    struct.nx, struct.ny = columns_and_rows(shape[leading:])
    struct.maps = shape[0] if leading else 1
    struct.hx, struct.hy, struct.rounded = says.hx or 0.0, says.hy or 0.0, int(rounded)
    struct.unit = None if says.unit is None else as_text(says.unit, "unit")
    struct.periodic = -1 if says.periodic is None else int(says.periodic)
    return Map(struct, shape, [keep, array, points])


def _as_given(name: str, value: Any) -> Tuple[Any, Any, int]:
    """(text, numbers, n)"""
    if isinstance(value, (list, tuple)) and any(isinstance(each, str) for each in value):
        value = ",".join(map(str, value))
    if isinstance(value, str):
        return as_text(value, name), None, 0
    if isinstance(value, (int, float)):
        return None, (ctypes.c_double * 1)(value), 1
    try:
        numbers = np.ascontiguousarray(value, np.float64).ravel()
    except (TypeError, ValueError):
        raise ArgumentError(f"{name} is {value!r}; numbers or a text are needed") from None
    if numbers.size == 0:
        raise ArgumentError(f"{name} is empty: one value for each step is needed")
    return None, pointer(numbers), numbers.size


@dataclass(frozen=True)
class Smooth(Stored):
    """The contact of the smooth body that the word shape names, at a step's load: Hertz' of a sphere and a cylinder, and of a wedge.

    width: of the contact [length]; of a sphere twice the radius
    approach: [length]; NaN but for a sphere
    max_pressure: [force/length^2]; NaN for a wedge, where it is infinite
    """

    width: float
    approach: float
    max_pressure: float

    @property
    def radius(self) -> float:
        """Half the width [length]."""
        return self.width / 2


class Request:
    """A request of C, with what it means."""

    def __init__(
        self,
        call: int,
        words: Mapping[str, Any],
        maps: Sequence[Map],
        system: Any = None,
        spelling: int = _constants.RC_SPELLING_KEYWORD,
    ) -> None:
        spec, self._handle = rc_request_spec(), None
        given = {name: _as_given(name, value) for name, value in words.items() if value is not None}
        pairs = (rc_given * len(given))()
        for pair, (name, (text, numbers, n)) in zip(pairs, given.items()):
            pair.word, pair.text, pair.numbers, pair.n = name.encode(), text, numbers, n
        structs = (rc_map * len(maps))(*(each.struct for each in maps))
        own = None if system is None else system.struct()
        own_numbers = spelling == _constants.RC_SPELLING_KEYWORD
        spec.call, spec.spelling = call, spelling
        spec.numbers = _constants.RC_NUMBERS_OWN if own_numbers else _constants.RC_NUMBERS_SI
        spec.words, spec.n_words, spec.maps, spec.n_maps = (
            ctypes.addressof(pairs),
            len(given),
            ctypes.addressof(structs),
            len(maps),
        )
        spec.system = None if own is None else ctypes.addressof(own[0])
        self.spec, self._keep = spec, (given, maps, pairs, structs, own)
        handle = ctypes.c_void_p()
        check(request_library().rc_request_create(spec, handle), message_of_request)
        self._handle, self.view = handle, rc_problem_view()
        check(request_library().rc_request_problem(handle, self.view), message_of_request)

    def __del__(self) -> None:
        if self._handle is not None:
            request_library().rc_request_destroy(self._handle)

    @property
    def targets(self) -> Doubles:
        found: Doubles = np.ctypeslib.as_array(self.view.targets, (self.view.n,)).copy()
        return found

    @property
    def times(self) -> Optional[Doubles]:
        if not self.view.n_times:
            return None
        found: Doubles = np.ctypeslib.as_array(self.view.times, (self.view.n_times,)).copy()
        return found

    @cached_property
    def remarks(self) -> List[rc_remark]:
        library, found = request_library(), []
        for index in range(library.rc_request_remark_count(self._handle)):
            found.append(rc_remark())
            check(library.rc_request_remark(self._handle, index, found[-1]), message_of_request)
        return found

    def options(self) -> Dict[str, str]:
        """That the words set."""
        found, key, text = {}, ctypes.c_char_p(), ctypes.c_char_p()
        for index in range(request_library().rc_request_option_count(self._handle)):
            check(request_library().rc_request_option(self._handle, index, key, text), message_of_request)
            found[(key.value or b"").decode()] = (text.value or b"").decode()
        return found

    def _said(self, doubtful: bool) -> Tuple[str, ...]:
        return tuple(
            each.text.decode(errors="replace") for each in self.remarks if (each.severity == _constants.RC_DOUBTFUL) == doubtful
        )

    def assumed(self) -> Tuple[str, ...]:
        return self._said(doubtful=False)

    def note(self, note: str, load: float) -> str:
        """The note of an answer, with words that help, and remarks on doubtful words."""
        text = ctypes.create_string_buffer(2048)
        check(request_library().rc_request_note(self._handle, note.encode(), load, len(text), text), message_of_request)
        return "; ".join(filter(None, [text.value.decode(errors="replace"), *self._said(doubtful=True)]))

    def smooth(self, load: float) -> Optional[Smooth]:
        found = rc_smooth()
        known = request_library().rc_request_smooth(self._handle, load, found) == 0
        return Smooth(**members_for(Smooth, found)) if known else None


def request_of(
    call: int,
    words: Dict[str, Any],
    things: Dict[str, Any],
    mask: Any,
    system: Any,
    leading: int,
    spelling: int,
    others: Sequence[Any] = (),
) -> Tuple[Request, List[Map]]:
    """The request; files of formats that no reader knows come from the package SurfaceTopography."""
    pitch = words.get("pitch")
    own = {word: mask if word in ("surface", "gap") else None for word in things}

    def maps() -> List[Map]:
        return [
            (
                _file_map(thing, word, own[word])
                if word != "gap" and is_file(thing)
                else map_of(thing, word, own[word], pitch, leading if word in ("surface", "gap") else 0)
            )
            for word, thing in things.items()
        ] + [_file_map(each, "maps", None) if is_file(each) else map_of(each, "maps", None, pitch) for each in others]

    found = maps()
    try:
        return Request(call, words, found, system, spelling), found
    except ArgumentError as error:
        files = [word for word, thing in things.items() if is_file(thing)]
        if not files or not ("unknown format" in str(error) or PACKAGE in str(error)):
            raise
        for word in files:
            given = {name: words.pop(name, None) for name in ("pitch", "unit", "format")} if word == "surface" else {}
            things[word] = surface_in(things[word], **given)
        found = maps()
        return Request(call, words, found, system, spelling), found


def unit_of(thing: Any) -> Optional[str]:
    """The unit that heights of any kind but a file say themselves."""
    return None if is_file(thing) else _described(thing, None, None)[2].unit


def as_surface(
    thing: Any,
    pitch: Any = None,
    periodic: Optional[bool] = None,
    mask: Any = None,
    unit: Optional[str] = None,
    otherwise: Any = None,
) -> Surface:
    """A Surface from a Surface, a file, an object with the methods of SurfaceTopography's, or an array and a pitch; in metres, if
    its unit is known.

    unit: of heights and pitch that have none
    otherwise: the pitch of what brings none, where pitch is None
    """
    if is_file(thing):
        thing, pitch, unit = surface_in(thing, pitch, unit, otherwise=otherwise), None, None
    given = map_of(thing, "surface", mask, pitch)
    words = {"pitch": otherwise if pitch is None and not given.struct.hx else pitch, "unit": unit}
    words.update(missing="exclude", boundary="free", modulus=1.0, approach=0.0)  # nothing is pressed
    request = Request(_constants.RC_CALL_HISTORY, words, [given])
    view, shape = request.view, given.shape or ()
    points = None if not view.mask else np.ctypeslib.as_array(view.mask, (int(np.prod(shape)),)).reshape(shape).copy()
    heights = np.ctypeslib.as_array(view.heights, (int(np.prod(shape)),)).reshape(shape).copy()
    repeats = periodic if periodic is not None else None if view.periodic < 0 else bool(view.periodic)
    found = thing if isinstance(thing, Surface) else Surface(heights, (view.system.hx, view.system.hy))
    own: Dict[str, Any] = {"heights": heights, "pitch": (view.system.hx, view.system.hy), "periodic": repeats, "mask": points}
    return replace(found, unit="m" if view.si else None, **own)

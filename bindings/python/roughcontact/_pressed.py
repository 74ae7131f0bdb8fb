"""What presses what."""

from __future__ import annotations

import ctypes
from dataclasses import dataclass
from typing import Any, Mapping, Optional, Sequence

import numpy as np

from . import _constants
from ._arrays import Doubles, Mask, Shape, as_doubles
from ._data_arrays import described
from ._device import DeviceArray, device_array
from ._errors import ArgumentError, ShapeError
from ._height_map import Surface, gap_below
from ._request import Request, request_of
from ._units import AssumedUnit, metres_of, warn
from .context import Options
from .system import REPEATS, AssumedBoundary, HalfSpace, System

CONTROLS = {
    "approach": _constants.RC_CONTROL_APPROACH,
    "load": _constants.RC_CONTROL_LOAD,
    "pressure": _constants.RC_CONTROL_PRESSURE,
    "area": _constants.RC_CONTROL_AREA,
}
WARNINGS = {_constants.RC_REMARK_BOUNDARY: AssumedBoundary, _constants.RC_REMARK_UNIT: AssumedUnit}


def gap_in_metres(gap: Any) -> Any:
    """An undeformed gap as it is if its unit is not known. On a device it stays there."""
    says = described(gap)
    metres = metres_of(says.unit) if says and says.unit else 1.0
    if metres == 1:
        return gap
    return gap * metres if device_array(gap, "undeformed_gap") is not None else as_doubles(gap, "undeformed_gap") * metres


@dataclass(frozen=True)
class Prescribed:
    """What presses: name: "approach", "load", "pressure" or "area", a share; given: its values; control, targets: the same as C has it."""

    name: str
    given: Doubles
    control: int
    targets: Doubles

    def target(self) -> float:
        """The value of a call that solves one step."""
        if self.given.size != 1:
            raise ArgumentError(
                f"{self.name} has {self.given.size} values, and this call solves one step; roughcontact.history and "
                "Contact.history solve one step for each"
            )
        return float(self.targets.item())


def _prescribed(name: str, values: Doubles, system: System) -> Prescribed:
    if name != "area":
        return Prescribed(name, values, CONTROLS[name], values)
    if np.any(values > 1):
        raise ArgumentError(f"area: {float(np.max(values)):g} is more than the whole, give a share as 10% or 0.1")
    return Prescribed(name, values, CONTROLS[name], values * (float(np.prod(system.shape)) * system.pitch[0] * system.pitch[1]))


def prescribed(system: System, **ways: Any) -> Prescribed:
    """The one that is given of approach, load, mean pressure over the whole grid, and area."""
    found = {name: value for name, value in ways.items() if value is not None}
    if len(found) == 1:
        ((name, value),) = found.items()
        if not isinstance(value, (str, list, tuple)):
            return _prescribed(name, np.asarray(value, np.float64), system)
    request = Request(_constants.RC_CALL_HISTORY, found, [], system)
    if request.view.loading is None:
        raise ArgumentError(f"nothing presses: one of {', '.join(ways)} is needed")
    return _prescribed(request.view.loading.decode(), request.targets, system)


@dataclass(frozen=True)
class Pressed:
    """A problem: loading is None where no step is prescribed; mask: of its own for each surface where it has an axis more."""

    system: System
    gap: Any
    mask: Optional[Mask]
    loading: Optional[Prescribed]
    request: Request

    def surface(self) -> Surface:
        """As pressed."""
        view = self.request.view
        heights = np.ctypeslib.as_array(view.heights, (int(np.prod(self.gap.shape)),)).reshape(self.gap.shape).copy()
        repeats = None if view.periodic < 0 else bool(view.periodic)
        said = self.request.assumed()
        return Surface(heights, self.system.pitch, repeats, self.mask, "m" if view.si else None, remarks=said)

    def options(self, given: Options) -> Options:
        """With those that the words set."""
        own = self.request.options()
        twice = sorted(set(own) & set(given or {}))
        if twice:
            raise ArgumentError(f"{twice[0]} is given twice, by the word layer and as an option")
        return {**own, **(given or {})} if own else given

    def needed(self) -> Prescribed:
        if self.loading is None:
            raise ArgumentError("nothing presses: one of approach, load, pressure, area is needed")
        return self.loading

    def remarked(self, result: Any) -> Any:
        """A result with the remarks of its request."""
        asked, load = self.request, result.load
        note = asked.note(result.note, load) if result.contacts else result.note
        return result._with(note=note, assumed=asked.assumed(), smooth=asked.smooth(load))


def _half_space(request: Request, shape: Shape) -> HalfSpace:
    struct, system = request.view.system, HalfSpace.__new__(HalfSpace)
    system.shape, system.pitch, system.modulus = shape, (struct.hx, struct.hy), struct.modulus
    system.boundary = list(REPEATS)[struct.boundary - 1]
    system.periodic, system.hardness = REPEATS[system.boundary], struct.hardness or None
    if struct.creep_terms:
        ratio, time = (
            np.ctypeslib.as_array(ctypes.cast(each.data, ctypes.POINTER(ctypes.c_double)), (struct.creep_terms,))
            for each in (struct.creep_ratio, struct.creep_time)
        )
        terms = list(zip(ratio.tolist(), time.tolist()))
        name = "creep" if struct.creep_by == _constants.RC_CREEP_COMPLIANCES else "relaxation"
        setattr(system, name, terms)
    return system


def pressed(
    call: int,
    heights: Any,
    undeformed_gap: Any,
    mask: Any,
    system: Optional[System],
    words: Mapping[str, Any],
    leading: int = 0,
    spelling: int = _constants.RC_SPELLING_KEYWORD,
    others: Sequence[Any] = (),
) -> Pressed:
    """The problem of a call. Of heights or a gap; leading: axes that count surfaces; others: maps of a budget."""
    if (heights is None) == (undeformed_gap is None):
        raise ArgumentError(
            f"{'both are' if heights is not None else 'neither is'} given: one of heights, undeformed_gap is needed"
        )
    words = dict(words)
    things = {"surface": heights} if heights is not None else {"gap": undeformed_gap}
    for word in ("against", "shape"):
        thing = words.get(word)
        if thing is not None and (word == "against" or not isinstance(thing, str)):
            things[word] = words.pop(word)
    request, maps = request_of(call, words, things, mask, system, leading, spelling, others)
    for remark in request.remarks:
        if remark.code in WARNINGS and spelling == _constants.RC_SPELLING_KEYWORD:
            warn(remark.text.decode(errors="replace"), WARNINGS[remark.code])
    view = request.view
    given_shape = maps[0].shape or (view.system.ny, view.system.nx)
    sides = (view.system.ny, view.system.nx) if len(given_shape) - leading == 2 else (view.system.nx,)
    shape = (*given_shape[:leading], *sides)  # words may have cut the map
    found = _half_space(request, shape[leading:]) if system is None else system
    if shape[leading:] != found.shape:
        raise ShapeError(f"heights have shape {shape[leading:]}, the grid {found.shape}")
    points = None
    if view.mask:
        points = np.ctypeslib.as_array(view.mask, (int(np.prod(shape)),)).reshape(shape).copy()
    if heights is not None:
        as_pressed = np.ctypeslib.as_array(view.heights, (int(np.prod(shape)),)).reshape(shape)
        gap: Any = gap_below(as_pressed, points, leading)
    else:
        there = isinstance(maps[0].keep[1], DeviceArray)
        gap = undeformed_gap if there else maps[0].keep[1]
        gap = gap if view.metres == 1 else gap * view.metres
        if there:  # a step reads it on the device; other calls get a copy
            gap = (device_array if call == _constants.RC_CALL_SOLVE else as_doubles)(gap, "undeformed_gap")
    loading = None
    if view.n > 0:
        name, targets = view.loading.decode(), request.targets
        given = words.get(name)
        if given is not None and not isinstance(given, str) and np.size(given) == targets.size:
            targets = targets.reshape(np.shape(given))
        loading = _prescribed(name, targets, found)
    return Pressed(found, gap, points, loading, request)

"""Height maps: what is accepted for one."""

from dataclasses import replace
from typing import Any, Optional, Tuple, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import Doubles, Mask, Pitch, as_doubles, as_mask, as_pitch, refuse_one_row, without_masked
from ._data_arrays import Described, described
from ._device import device_array
from ._errors import ArgumentError, ShapeError
from ._files import is_file, surface_in
from ._height_map import Surface, refuse_contradiction, same_pitch
from ._units import bare_metres, metres_of


def _own_pitch(own: Tuple[float, float], pitch: Optional[Pitch], unit: Optional[str]) -> Tuple[float, float]:
    """own, if nothing else is given."""
    if pitch is not None and not same_pitch(own, as_pitch(pitch)):
        raise ArgumentError(
            f"pitch is {pitch} {unit or ''}, but the surface has its own, {own}; leave pitch out, or give the heights alone"
        )
    return own


def _pitch_in(unit: Optional[str], pitch: Optional[Pitch]) -> Optional[Pitch]:
    """A pitch without a unit beside lengths in `unit`: metres, if it is known."""
    if pitch is None or unit is None or metres_of(unit) == 1:
        return pitch
    found: Pitch = (np.asarray(pitch, np.float64) / metres_of(unit)).tolist()
    return found


def _refuse_unclear(pitch: Optional[Pitch], unit: Optional[str]) -> None:
    """A pitch beside heights in a unit that bring none may be in that unit or in metres."""
    if pitch is not None and unit is not None and metres_of(unit) != 1:
        raise ArgumentError(
            f"pitch has no unit, but the heights are in {unit!r}: give Surface(heights, pitch, unit={unit!r}) if both are, else "
            "heights in metres"
        )


def _pitch_needed(pitch: Optional[Pitch]) -> Tuple[float, float]:
    if pitch is None:
        raise ArgumentError("pitch is missing: the distance of neighbouring points, one number or (hx, hy)")
    return as_pitch(pitch)


def has_methods_of_a_topography(thing: Any) -> bool:
    return callable(getattr(thing, "heights", None)) and hasattr(thing, "physical_sizes")


def pitch_of_topography(thing: Any, shape: Tuple[int, ...]) -> Tuple[float, float]:
    sizes = tuple(float(size) for size in np.atleast_1d(thing.physical_sizes))
    if len(sizes) != len(shape):
        raise ShapeError(f"physical_sizes has {len(sizes)} values, heights() {len(shape)} axes")
    if len(sizes) == 1:
        raise ArgumentError("the topography is a line: give pitch=(hx, hy), hy being the width of its cells")
    return sizes[1] / shape[1], sizes[0] / shape[0]


def _first(where: NDArray[np.bool_]) -> str:
    """Place of the first point that is true, as the library names it."""
    *before, ix = (int(i) for i in np.argwhere(where)[0])
    return f"ix={ix}, iy={before[0] if before else 0}"


def _without_missing(values: Any, mask: Optional[ArrayLike], exclude: bool) -> Tuple[Doubles, Optional[Mask]]:
    """(heights, mask) where masked values and NaN are missing points."""
    heights, absent = without_masked(values, "heights")
    given = as_mask(mask, "mask", heights.shape)
    unknown = ~np.isfinite(heights)
    if absent is not None:
        unknown |= absent
    if given is not None:
        unknown &= given != 0  # what the caller leaves out may be anything
    if not unknown.any():
        return heights, given
    infinite = unknown & np.isinf(heights)
    if absent is not None:
        infinite &= ~absent
    if infinite.any():
        raise ArgumentError(
            f"heights have {int(infinite.sum())} infinite values, the first at {_first(infinite)}; mask them or make them NaN"
        )
    if not exclude:
        raise ArgumentError(
            f"heights have {int(unknown.sum())} missing points (masked or NaN), the first at {_first(unknown)}; pass "
            "missing='fill' to interpolate them, or missing='exclude': they then carry no pressure"
        )
    present = ~unknown if given is None else ~unknown & (given != 0)
    return heights, present.view(np.uint8)


def gap_in_metres(gap: Any) -> Any:
    """An undeformed gap as it is if its unit is not known. On a device it stays there."""
    says = described(gap)
    metres = bare_metres(None, says.unit if says else None)
    if metres == 1:
        return gap
    return gap * metres if device_array(gap, "undeformed_gap") is not None else as_doubles(gap, "undeformed_gap") * metres


def unit_of(thing: Any) -> Optional[str]:
    """The unit that heights of any kind but a file say themselves."""
    says = described(thing)
    if says is not None:
        return says.unit
    return getattr(thing, "unit", None) if isinstance(thing, Surface) or has_methods_of_a_topography(thing) else None


def _pitch_of_coordinates(says: Described, pitch: Optional[Pitch], otherwise: Optional[Pitch]) -> Tuple[float, float]:
    """The pitch that is given, if it is that of the coordinates; else theirs."""
    own = (says.hx, says.hy)
    if pitch is None and None not in own:
        return cast(Tuple[float, float], own)
    sides = _pitch_needed(otherwise if pitch is None else pitch)
    refuse_contradiction(sides, own)
    return sides


def as_surface(
    thing: Any,
    pitch: Optional[Pitch] = None,
    periodic: Optional[bool] = None,
    mask: Optional[ArrayLike] = None,
    exclude: bool = False,
    unit: Optional[str] = None,
    otherwise: Optional[Pitch] = None,
    in_metres: bool = True,
) -> Surface:
    """A Surface from a Surface, a file, an object with the methods of SurfaceTopography's, or an array and a pitch; in metres, if
    its unit is known.

    exclude: whether points may be missing
    unit: of heights and pitch that have none
    otherwise: the pitch of what brings none, where pitch is None; in metres if the surface is
    in_metres: False: a surface keeps its unit
    """
    if is_file(thing):
        return as_surface(surface_in(thing, pitch, unit, otherwise=otherwise), None, periodic, mask, exclude)
    own = unit_of(thing)
    metres = bare_metres(unit, own)
    if in_metres:
        pitch, otherwise = _pitch_in(own, pitch), _pitch_in(own or unit, otherwise)
    at_hand = otherwise if pitch is None else pitch
    if isinstance(thing, Surface):
        heights, found_mask = _without_missing(thing.heights, thing.mask if mask is None else mask, exclude)
        found = replace(thing, heights=heights, mask=found_mask, pitch=_own_pitch(thing.pitch, pitch, own))
    elif has_methods_of_a_topography(thing):
        if getattr(thing, "is_uniform", True) is False:
            raise ArgumentError("the topography is not on a uniform grid; interpolate it onto one")
        heights, found_mask = _without_missing(thing.heights(), mask, exclude)
        refuse_one_row(heights, "the topography", pitch)
        silent = thing.physical_sizes is None or (pitch is not None and heights.ndim == 1)
        if silent:
            _refuse_unclear(pitch, own)
        sides = _pitch_needed(at_hand) if silent else _own_pitch(pitch_of_topography(thing, heights.shape), pitch, own)
        repeats = getattr(thing, "is_periodic", False) or None  # False is what the package says where nobody knows
        found = Surface(heights, sides, repeats, found_mask, getattr(thing, "unit", None))
    else:
        says = described(thing) or Described(None, None, None, None)
        if None in (says.hx, says.hy):
            _refuse_unclear(pitch, own)
        sides = _pitch_of_coordinates(says, pitch, otherwise)
        heights, found_mask = _without_missing(thing, mask, exclude)
        refuse_one_row(heights, "heights", pitch)
        found = Surface(heights, sides, says.periodic, found_mask, says.unit)
    if periodic is not None:
        found = replace(found, periodic=bool(periodic))
    if own is None and unit is not None:
        found = replace(found, unit=unit)
    return found.in_unit("m") if in_metres and metres != 1 else found

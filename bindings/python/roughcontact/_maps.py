"""Height maps: what a grid of heights is, and what is accepted for one."""

import os
from dataclasses import dataclass, replace
from typing import Any, Optional, Tuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import Doubles, Mask, Pitch, as_doubles, as_mask, as_pitch, pointer
from ._calls import check
from ._errors import ArgumentError, ShapeError
from ._library import contact_library

METRES = {
    "km": 1e3,
    "m": 1.0,
    "mm": 1e-3,
    "um": 1e-6,
    "\u00b5m": 1e-6,
    "\u03bcm": 1e-6,
    "nm": 1e-9,
    "A": 1e-10,
    "\u00c5": 1e-10,
    "pm": 1e-12,
}


@dataclass(frozen=True, eq=False)
class Surface:
    """Heights on a grid.

    heights: [ny, nx] or [nx], towards the other body: the highest point touches first [length]
    pitch: (hx, hy) distance of neighbouring points along the last and along the first axis [length]
    periodic: whether the surface repeats
    mask: [ny, nx] 0 where a point is missing; None: all are there
    unit: of all lengths, where it is known ("um")
    """

    heights: Doubles
    pitch: Tuple[float, float]
    periodic: bool = False
    mask: Optional[Mask] = None
    unit: Optional[str] = None

    @property
    def shape(self) -> Tuple[int, ...]:
        return self.heights.shape

    def in_unit(self, unit: str) -> "Surface":
        """The same surface with its lengths in another unit."""
        if self.unit is None:
            raise ArgumentError(f"the surface does not say its unit, so it cannot be given in {unit!r}; leave unit out")
        for each in (unit, self.unit):
            if each not in METRES:
                raise ArgumentError(f"unit {each!r} is not one of {', '.join(METRES)}")
        factor = METRES[self.unit] / METRES[unit]
        return replace(self, heights=self.heights * factor, pitch=(self.pitch[0] * factor, self.pitch[1] * factor), unit=unit)

    def undeformed_gap(self) -> Doubles:
        """Distance of every point to a plane through the highest one [length]."""
        return gap_below(self.heights, self.mask, 0)


def gap_below(heights: Doubles, mask: Optional[NDArray[Any]], leading: int) -> Doubles:
    """max - heights; the first `leading` axes count surfaces that each have a highest point of their own."""
    given, gap = as_doubles(heights, "heights"), np.empty(heights.shape)
    masks = None if mask is None else np.ascontiguousarray(np.broadcast_to(mask, heights.shape))
    for i in np.ndindex(heights.shape[:leading]):
        there = None if masks is None else pointer(masks[i])
        check(contact_library().rc_gap_from_heights(gap[i].size, pointer(given[i]), there, pointer(gap[i])))
    return gap


def _has_methods_of_a_topography(thing: Any) -> bool:
    return callable(getattr(thing, "heights", None)) and hasattr(thing, "physical_sizes")


def _pitch_of_topography(thing: Any, shape: Tuple[int, ...]) -> Tuple[float, float]:
    sizes = tuple(float(size) for size in np.atleast_1d(thing.physical_sizes))
    if len(sizes) != len(shape):
        raise ShapeError(f"physical_sizes has {len(sizes)} values, heights() {len(shape)} axes")
    if len(sizes) == 1:
        raise ArgumentError("the topography is a line: give pitch=(hx, hy), hy being the width of its cells")
    return sizes[1] / shape[1], sizes[0] / shape[0]


def _without_missing(values: Any, mask: Optional[ArrayLike], missing: str, leading: int = 0) -> Tuple[Doubles, Optional[Mask]]:
    """(heights, mask) where masked values and NaN are missing points."""
    if missing not in ("reject", "exclude"):
        raise ArgumentError(f"missing is {missing!r}: 'reject' or 'exclude'")
    absent = np.ma.getmaskarray(values) if np.ma.isMaskedArray(values) else None
    heights = as_doubles(np.ma.getdata(values) if absent is not None else values, "heights")
    shared = mask is not None and np.ndim(mask) < heights.ndim
    given = as_mask(mask, "mask", heights.shape[leading:] if shared else heights.shape)
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
        first = tuple(int(i) for i in np.argwhere(infinite)[0])
        raise ArgumentError(
            f"heights have {int(infinite.sum())} infinite values, the first at {list(first)}; mask them or make them NaN"
        )
    if missing == "reject":
        first = tuple(int(i) for i in np.argwhere(unknown)[0])
        raise ArgumentError(
            f"heights have {int(unknown.sum())} missing points (masked or NaN), the first at {list(first)}; fill them, "
            "or pass missing='exclude': they then carry no pressure"
        )
    present = ~unknown if given is None else ~unknown & (given != 0)
    return heights, present.view(np.uint8)


def as_surface(
    thing: Any,
    pitch: Optional[Pitch] = None,
    periodic: Optional[bool] = None,
    mask: Optional[ArrayLike] = None,
    missing: str = "reject",
    unit: Optional[str] = None,
    leading: int = 0,
) -> Surface:
    """A Surface from a Surface, an object with the methods of SurfaceTopography's, or an array and a pitch."""
    if isinstance(thing, (str, bytes, os.PathLike)):
        raise ArgumentError("heights is a file name; files are read by the command roughcontact, or pass an array")
    if isinstance(thing, Surface):
        heights, found_mask = _without_missing(thing.heights, thing.mask if mask is None else mask, missing)
        found = Surface(heights, thing.pitch, thing.periodic, found_mask, thing.unit)
    elif _has_methods_of_a_topography(thing):
        if getattr(thing, "is_uniform", True) is False:
            raise ArgumentError("the topography is not on a uniform grid; interpolate it onto one")
        heights, found_mask = _without_missing(thing.heights(), mask, missing)
        sides = as_pitch(pitch) if pitch is not None else _pitch_of_topography(thing, heights.shape)
        found = Surface(heights, sides, bool(getattr(thing, "is_periodic", False)), found_mask, getattr(thing, "unit", None))
    else:
        if pitch is None:
            raise ArgumentError("pitch is missing: the distance of neighbouring points, one number or (hx, hy)")
        heights, found_mask = _without_missing(thing, mask, missing, leading)
        found = Surface(heights, as_pitch(pitch), False, found_mask, unit)
    if found.heights.ndim - leading not in (1, 2):
        raise ShapeError(f"heights have {found.heights.ndim} axes: {leading + 1} or {leading + 2} are needed")
    if pitch is not None:
        found = replace(found, pitch=as_pitch(pitch))
    if periodic is not None:
        found = replace(found, periodic=bool(periodic))
    return found.in_unit(unit) if unit is not None and found.unit != unit else found

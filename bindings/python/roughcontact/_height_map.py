"""Heights on a grid."""

from dataclasses import dataclass, replace
from typing import Any, Optional, Tuple

import numpy as np
from numpy.typing import NDArray

from . import _constants
from ._arrays import Doubles, Mask, as_doubles, columns_and_rows, pointer
from ._calls import check, check_formats
from ._errors import ArgumentError
from ._library import contact_library, formats_library

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

FORMS = {
    "mean": _constants.RC_SURFACE_FORM_MEAN,
    "plane": _constants.RC_SURFACE_FORM_PLANE,
    "quadric": _constants.RC_SURFACE_FORM_QUADRIC,
}


@dataclass(frozen=True, eq=False)
class Surface:
    """Heights on a grid.

    heights: [ny, nx] or [nx], towards the other body: the highest point touches first [length]
    pitch: (hx, hy) distance of neighbouring points along the last and along the first axis [length]
    periodic: whether the surface repeats
    mask: [ny, nx] 0 where a point is missing; None: all are there
    unit: of all lengths, where it is known ("um")
    assumed: what a file leaves open and how it was taken; "" for surfaces that were not read
    """

    heights: Doubles
    pitch: Tuple[float, float]
    periodic: bool = False
    mask: Optional[Mask] = None
    unit: Optional[str] = None
    assumed: str = ""

    @property
    def shape(self) -> Tuple[int, ...]:
        return self.heights.shape

    @property
    def missing(self) -> NDArray[np.bool_]:
        """True where the height of a point is not known."""
        unknown: NDArray[np.bool_] = np.isnan(self.heights)
        return unknown if self.mask is None else unknown | (self.mask == 0)

    def filled(self) -> "Surface":
        """The same surface with every missing height the mean of its neighbours, as a soap film spans a hole. What was in the hole
        is unknown: contact there is a guess."""
        nx, ny = columns_and_rows(self.shape)
        heights = np.where(self.missing, np.nan, self.heights)
        check_formats(formats_library().rc_surface_fill(nx, ny, *self.pitch, pointer(heights)))
        return replace(self, heights=heights, mask=None)

    def without(self, form: str) -> "Surface":
        """The same surface less the least-squares fit of a form, "mean", "plane" or "quadric", over the points that are there."""
        if form not in FORMS:
            raise ArgumentError(f"form is {form!r}: {', '.join(FORMS)}")
        nx, ny = columns_and_rows(self.shape)
        heights = np.where(self.missing, np.nan, self.heights)
        check_formats(formats_library().rc_surface_remove_form(nx, ny, FORMS[form], pointer(heights)))
        return replace(self, heights=heights)

    def in_unit(self, unit: str) -> "Surface":
        """The same surface with its lengths in another unit."""
        if self.unit is None:
            raise ArgumentError(f"the surface does not say its unit, so it cannot be given in {unit!r}; leave unit out")
        for each in (unit, self.unit):
            if each not in METRES:
                raise ArgumentError(f"unit {each!r} is not one of {', '.join(METRES)}")
        factor = METRES[self.unit] / METRES[unit]
        return replace(self, heights=self.heights * factor, pitch=(self.pitch[0] * factor, self.pitch[1] * factor), unit=unit)

    def __repr__(self) -> str:
        missing = int(self.missing.sum())
        more = (", periodic" if self.periodic else "") + (f", {missing} missing" if missing else "")
        size = " x ".join(map(str, self.shape[::-1]))
        return f"Surface({size} points, pitch {self.pitch[0]:g}, {self.pitch[1]:g}{' ' + self.unit if self.unit else ''}{more})"

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

"""Heights on a grid."""

from dataclasses import dataclass, replace
from typing import Any, ClassVar, Optional, Tuple

import numpy as np
from numpy.typing import NDArray

from . import _constants
from ._arrays import Doubles, Mask, as_doubles, as_mask, as_pitch, columns_and_rows, pointer, refuse_one_row, without_masked
from ._calls import check, check_formats
from ._data_arrays import described
from ._errors import ArgumentError, ShapeError
from ._library import contact_library, formats_library
from ._paths import Path
from ._surface_writer import save_surface
from ._units import metres_of

FORMS = {
    "mean": _constants.RC_SURFACE_FORM_MEAN,
    "plane": _constants.RC_SURFACE_FORM_PLANE,
    "quadric": _constants.RC_SURFACE_FORM_QUADRIC,
}


@dataclass(frozen=True, eq=False)
class Surface:
    """Heights on a grid. a + b adds the heights of two surfaces on one grid, as those of two rough bodies.

    heights: [ny, nx] or [nx], towards the other body: the highest point touches first [length]. Arrays of any order and type are
        converted; masked values become missing points
    pitch: (hx, hy) distance of neighbouring points along the last and along the first axis [length]; one number for both
    periodic: True: the surface repeats; False: it ends at its edges; None: not known
    mask: [ny, nx] 0 where a point is missing; None: all are there
    unit: of all lengths, if it is known ("um"); whatever presses or analyses the surface then does so in metres
    assumed: assumptions about what a file leaves open; "" for surfaces that were not read
    """

    heights: Doubles
    pitch: Tuple[float, float]
    periodic: Optional[bool] = None
    mask: Optional[Mask] = None
    unit: Optional[str] = None
    assumed: str = ""
    _leading: ClassVar[int] = 0

    def __post_init__(self) -> None:
        says = described(self.heights)
        heights, absent = without_masked(self.heights, "heights")
        shared = self.mask is not None and np.ndim(self.mask) < heights.ndim
        mask = as_mask(self.mask, "mask", heights.shape[self._leading :] if shared else heights.shape)
        if absent is not None:
            heights = np.where(absent, np.nan, heights)
            mask = (~absent if mask is None else ~absent & (mask != 0)).view(np.uint8)
        if heights.ndim - self._leading not in (1, 2):
            raise ShapeError(f"heights have {heights.ndim} axes: {self._leading + 1} or {self._leading + 2} are needed")
        refuse_one_row(heights, "heights", self.pitch, self._leading + 1)
        sides = as_pitch(self.pitch)
        if says is not None:
            refuse_contradiction(sides, (says.hx, says.hy))
            object.__setattr__(self, "unit", self.unit or says.unit)
            object.__setattr__(self, "periodic", says.periodic if self.periodic is None else self.periodic)
        found = {"heights": heights, "pitch": sides, "mask": mask}
        found["periodic"] = None if self.periodic is None else bool(self.periodic)
        for name, value in found.items():
            object.__setattr__(self, name, value)

    @property
    def shape(self) -> Tuple[int, ...]:
        return self.heights.shape

    @property
    def missing(self) -> NDArray[np.bool_]:
        """True where the height of a point is not known."""
        unknown: NDArray[np.bool_] = np.isnan(self.heights)
        return unknown if self.mask is None else unknown | (self.mask == 0)

    def _known(self) -> Doubles:
        """A copy of the heights, NaN where a point is missing."""
        known: Doubles = np.where(self.missing, np.nan, self.heights)
        return known

    def filled(self) -> "Surface":
        """The same surface with every missing height the mean of its neighbours, as a soap film spans a hole. What was in the hole
        is unknown: contact there is a guess."""
        nx, ny = columns_and_rows(self.shape)
        heights = self._known()
        check_formats(formats_library().rc_surface_fill(nx, ny, *self.pitch, pointer(heights)))
        return replace(self, heights=heights, mask=None)

    def without(self, form: str) -> "Surface":
        """The same surface less the least-squares fit of a form, "mean", "plane" or "quadric", over the points that are there."""
        if form not in FORMS:
            raise ArgumentError(f"form is {form!r}: {', '.join(FORMS)}")
        nx, ny = columns_and_rows(self.shape)
        heights = self._known()
        check_formats(formats_library().rc_surface_remove_form(nx, ny, FORMS[form], pointer(heights)))
        return replace(self, heights=heights)

    def in_unit(self, unit: str) -> "Surface":
        """The same surface with its lengths in another unit."""
        if self.unit is None:
            raise ArgumentError(f"the surface does not say its unit, so it cannot be given in {unit!r}; leave unit out")
        factor = metres_of(self.unit) / metres_of(unit)
        return replace(self, heights=self.heights * factor, pitch=(self.pitch[0] * factor, self.pitch[1] * factor), unit=unit)

    def __add__(self, other: Any) -> "Surface":
        if not isinstance(other, Surface):
            return NotImplemented
        if other.unit != self.unit and other.unit is not None and self.unit is not None:
            other = other.in_unit(self.unit)
        if other.shape != self.shape:
            raise ShapeError(f"surfaces of {self.shape} and {other.shape} points cannot be added; both need the same grid")
        if not same_pitch(other.pitch, self.pitch):
            raise ArgumentError(f"surfaces with pitch {self.pitch} and {other.pitch} cannot be added; both need the same grid")
        if (other.unit is None) != (self.unit is None):
            raise ArgumentError(
                f"one surface is in {self.unit or other.unit!r}, the other says no unit; give it one, Surface(..., unit=)"
            )
        repeat = (self.periodic, other.periodic)
        mask = None if self.mask is None and other.mask is None else (~(self.missing | other.missing)).view(np.uint8)
        return replace(
            self,
            heights=self.heights + other.heights,
            periodic=False if False in repeat else None if None in repeat else True,
            mask=mask,
            assumed="; ".join(dict.fromkeys(each for each in (self.assumed, other.assumed) if each)),
        )

    def save(self, path: Path) -> None:
        """Writes a file that `read` reads, by the suffix: ".nc" with pitch, unit, missing points and whether the surface repeats;
        ".gsf" the same with heights in single precision, with a warning if that changes the roughness; ".npy" only the heights, NaN
        at missing points. The file is written as `rc_file_write` does."""
        save_surface(path, np.atleast_2d(self._known()), self.pitch, self.unit, self.periodic)

    def __repr__(self) -> str:
        missing = int(self.missing.sum())
        more = (", periodic" if self.periodic else "") + (f", {missing} missing" if missing else "")
        size = " x ".join(map(str, self.shape[::-1]))
        return f"Surface({size} points, pitch {self.pitch[0]:g}, {self.pitch[1]:g}{' ' + self.unit if self.unit else ''}{more})"

    def undeformed_gap(self) -> Doubles:
        """Distance of every point to a plane through the highest one [length]."""
        return gap_below(self.heights, self.mask, 0)


class Stack(Surface):
    """Surfaces on one grid; the first axis counts them."""

    _leading: ClassVar[int] = 1


def same_pitch(one: Tuple[float, float], other: Tuple[float, float]) -> bool:
    """Files round them."""
    return np.allclose(one, other, rtol=1e-6, atol=0)


def refuse_contradiction(
    pitch: Tuple[float, float], own: Tuple[Optional[float], Optional[float]], whose: str = "the coordinates of the heights"
) -> None:
    """pitch, which is given, against that of an array's coordinates, which may be rounded."""
    for given, known in zip(pitch, own):
        if known is not None and not np.isclose(given, known, rtol=1e-3, atol=0):
            raise ArgumentError(f"pitch is {pitch}, but {whose} say {own}; the surface has its own: leave pitch out")


def gap_below(heights: Doubles, mask: Optional[NDArray[Any]], leading: int) -> Doubles:
    """max - heights; the first `leading` axes count surfaces that each have a highest point of their own."""
    given, gap = as_doubles(heights, "heights"), np.empty(heights.shape)
    masks = None if mask is None else np.ascontiguousarray(np.broadcast_to(mask, heights.shape))
    for i in np.ndindex(heights.shape[:leading]):
        there = array_in(None if masks is None else masks[i])
        check(contact_library().rc_gap_from_heights(gap[i].size, array_in(given[i]), there, array_out(gap[i])))
    return gap

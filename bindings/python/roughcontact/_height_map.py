"""Heights on a grid."""

import ctypes
from dataclasses import dataclass, replace
from typing import Any, ClassVar, Mapping, Optional, Tuple, Union

import numpy as np
from numpy.typing import NDArray

from . import _constants
from ._arrays import (
    Doubles,
    Mask,
    Pitch,
    array_in,
    array_out,
    as_doubles,
    as_mask,
    as_pitch,
    columns_and_rows,
    given,
    pointer,
    refuse_one_row,
    without_masked,
)
from ._calls import check, check_formats
from ._data_arrays import described
from ._errors import ArgumentError, ShapeError
from ._library import contact_library, formats_library
from ._paths import Path
from ._structs import rc_surface_resampling
from ._surface_writer import save_surface
from ._units import metres_of

FORMS = {
    "mean": _constants.RC_SURFACE_FORM_MEAN,
    "plane": _constants.RC_SURFACE_FORM_PLANE,
    "quadric": _constants.RC_SURFACE_FORM_QUADRIC,
}
METHODS = {"linear": _constants.RC_SURFACE_LINEAR, "cubic": _constants.RC_SURFACE_CUBIC}
AXES = {
    "x": _constants.RC_SURFACE_MIRROR_X,
    "y": _constants.RC_SURFACE_MIRROR_Y,
    "xy": _constants.RC_SURFACE_MIRROR_X | _constants.RC_SURFACE_MIRROR_Y,
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
    remarks: how many points the methods below have changed, one sentence for each call
    """

    heights: Doubles
    pitch: Tuple[float, float]
    periodic: Optional[bool] = None
    mask: Optional[Mask] = None
    unit: Optional[str] = None
    assumed: str = ""
    remarks: Tuple[str, ...] = ()
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
        return replace(self, heights=heights, mask=None, remarks=(*self.remarks, f"{_points(self.missing.sum())} filled"))

    def without(self, form: str) -> "Surface":
        """The same surface less the least-squares fit of a form, "mean", "plane" or "quadric", over the points that are there."""
        nx, ny = columns_and_rows(self.shape)
        heights = self._known()
        check_formats(formats_library().rc_surface_remove_form(nx, ny, _named("form", form, FORMS), pointer(heights)))
        return replace(self, heights=heights)

    def despiked(self, factor: float = 10.0) -> "Surface":
        """The same surface without its spikes, which are missing points then: `filled` gives them heights. A spike differs from the
        median of the 5 x 5 points around it by more than factor times the median of that difference."""
        nx, ny = columns_and_rows(self.shape)
        heights, count, largest = self._known(), ctypes.c_int64(), ctypes.c_double()
        check_formats(formats_library().rc_surface_despike(nx, ny, float(factor), pointer(heights), count, largest))
        found = f"{_points(count.value)} removed as spikes" + (f", the largest of {largest.value:.3g}" if count.value else "")
        return replace(self, heights=heights, mask=None, remarks=(*self.remarks, found))

    def cropped(
        self, x: Optional[Tuple[float, float]] = None, y: Optional[Tuple[float, float]] = None, *, margin: float = 0.0
    ) -> "Surface":
        """The points whose cells have their middles in x and y, lengths from the outer edge of the first cell; None: from one edge
        to the other, less the margin. A part does not repeat."""
        nx, ny = columns_and_rows(self.shape)
        heights, n = self._known(), (ctypes.c_int64(nx), ctypes.c_int64(ny))
        ends = [
            (margin, count * pitch - margin) if asked is None else asked
            for asked, count, pitch in ((x, nx, self.pitch[0]), (y, ny, self.pitch[1]))
        ]
        if len(self.shape) == 1:
            ends[1] = (0.0, self.pitch[1])
        check_formats(formats_library().rc_surface_crop(*n, *self.pitch, *ends[0], *ends[1], pointer(heights)))
        left = n[0].value * n[1].value
        shape = (n[0].value,) if len(self.shape) == 1 else (n[1].value, n[0].value)
        kept = heights.ravel()[:left].reshape(shape)
        repeats = self.periodic if left == nx * ny else False
        remarks = (*self.remarks, f"{_points(nx * ny)} cut to {left}")
        return replace(self, heights=kept, mask=None, periodic=repeats, remarks=remarks)

    def mirrored(self, axes: str) -> "Surface":
        """The same surface with its points in the reverse order along "x", "y" or both, "xy", as a body that is turned over shows
        them; no height changes."""
        nx, ny = columns_and_rows(self.shape)
        heights = self._known()
        check_formats(formats_library().rc_surface_mirror(nx, ny, _named("axes", axes, AXES), pointer(heights)))
        return replace(self, heights=heights, mask=None, remarks=(*self.remarks, f"mirrored along {axes}"))

    def shifted(self, dx: float, dy: float = 0.0, *, method: str = "cubic") -> "Surface":
        """The same surface moved by dx, dy on its grid: cyclically if it repeats, else points without a height are missing. Between
        points heights are interpolated by method, "linear" or "cubic"."""
        nx, ny = columns_and_rows(self.shape)
        heights, missing = self._known(), ctypes.c_int64()
        how = (int(self.periodic is True), _named("method", method, METHODS))
        check_formats(
            formats_library().rc_surface_shift(nx, ny, *self.pitch, float(dx), float(dy), *how, pointer(heights), missing)
        )
        remarks = (*self.remarks, f"shifted by {dx:g}, {dy:g}: {_points(missing.value)} missing")
        return replace(self, heights=heights, mask=None, remarks=remarks)

    def resampled(self, grid: Union["Surface", Pitch], *, method: str = "cubic") -> "Surface":
        """Its heights on another grid, with the outer edges of the first cells at one place.

        grid: a surface with this grid, or the pitch of one over the same area; at most 1.5 times as coarse as this one's
        method: "linear", or "cubic" (Keys 1981, a = -1/2), exact at common points; points outside of the surface are missing
        """
        nx, ny = columns_and_rows(self.shape)
        if isinstance(grid, Surface):
            if (grid.unit is None) != (self.unit is None):
                raise ArgumentError(f"one surface is in {self.unit or grid.unit!r}, the other says no unit; give it one")
            factor = 1.0 if self.unit is None else metres_of(str(grid.unit)) / metres_of(self.unit)
            sides, shape = (grid.pitch[0] * factor, grid.pitch[1] * factor), grid.shape
            if len(shape) != len(self.shape):
                raise ShapeError(f"a surface of {self.shape} points cannot be resampled on a grid of {shape}")
        else:
            sides = as_pitch(grid)
            counts = [max(1, int(n * own / new + 1e-6)) for n, own, new in zip((nx, ny), self.pitch, sides)]
            shape = (counts[0],) if len(self.shape) == 1 else (counts[1], counts[0])
        if len(self.shape) == 1:
            sides = (sides[0], self.pitch[1])
        heights, to = self._known(), np.empty(shape)
        to_nx, to_ny = columns_and_rows(shape)
        struct = given(rc_surface_resampling(), nx=nx, ny=ny, hx=self.pitch[0], hy=self.pitch[1], heights=heights)
        given(struct, periodic=int(self.periodic is True), interpolation=_named("method", method, METHODS))
        given(struct, to_nx=to_nx, to_ny=to_ny, to_hx=sides[0], to_hy=sides[1], to=to)
        given(struct, x0=0.5 * (sides[0] - self.pitch[0]), y0=0.5 * (sides[1] - self.pitch[1]))
        check_formats(formats_library().rc_surface_resample(struct))
        whole = np.allclose((to_nx * sides[0], to_ny * sides[1]), (nx * self.pitch[0], ny * self.pitch[1]), rtol=1e-6, atol=0)
        said = f"pitch {self.pitch[0]:g}, {self.pitch[1]:g} resampled to {sides[0]:g}, {sides[1]:g}"
        remarks = (*self.remarks, f"{said}: {_points(struct.missing)} missing")
        return replace(self, heights=to, pitch=sides, mask=None, periodic=self.periodic if whole else False, remarks=remarks)

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
            remarks=(*self.remarks, *other.remarks),
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


def _points(count: int) -> str:
    return f"{count} point" if count == 1 else f"{count} points"


def _named(what: str, name: str, numbers: Mapping[str, int]) -> int:
    if name not in numbers:
        raise ArgumentError(f"{what} is {name!r}: {', '.join(numbers)}")
    return numbers[name]


class Stack(Surface):
    """Surfaces on one grid; the first axis counts them."""

    _leading: ClassVar[int] = 1


def same_pitch(one: Tuple[float, float], other: Tuple[float, float]) -> bool:
    """Files round them."""
    return np.allclose(one, other, rtol=1e-6, atol=0)


def refuse_contradiction(pitch: Tuple[float, float], own: Tuple[Optional[float], Optional[float]]) -> None:
    """pitch, which is given, against that of an array's coordinates, which may be rounded."""
    for side, known in zip(pitch, own):
        if known is not None and not np.isclose(side, known, rtol=1e-3, atol=0):
            raise ArgumentError(
                f"pitch is {pitch}, but the coordinates of the heights say {own}; the surface has its own: leave pitch out"
            )


def gap_below(heights: Doubles, mask: Optional[NDArray[Any]], leading: int) -> Doubles:
    """max - heights; the first `leading` axes count surfaces that each have a highest point of their own."""
    given, gap = as_doubles(heights, "heights"), np.empty(heights.shape)
    masks = None if mask is None else np.ascontiguousarray(np.broadcast_to(mask, heights.shape))
    for i in np.ndindex(heights.shape[:leading]) if leading else [...]:
        there = array_in(None if masks is None else masks[i])
        check(contact_library().rc_gap_from_heights(gap[i].size, array_in(given[i]), there, array_out(gap[i])))
    return gap

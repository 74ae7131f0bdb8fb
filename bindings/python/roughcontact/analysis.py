"""Analysis of a contact: area, patches, distribution of pressure, percolation. Functions of pressures, yours or a `Result`'s,
which has them as methods.

A point is in contact where its pressure is positive. periodic joins opposite sides of the grid: True: all, "x" or
"y": those of this axis.
"""

from __future__ import annotations

import ctypes
from dataclasses import dataclass, field
from typing import Any, Dict, Optional, Sequence, Tuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _constants
from ._arrays import (
    Doubles,
    Mask,
    Pitch,
    array_in,
    array_out,
    as_doubles,
    as_int,
    as_mask,
    as_pitch,
    given,
    pointer,
    refuse_one_row,
)
from ._c import members_for
from ._calls import check, conclude, interruptible
from ._errors import ArgumentError, ShapeError
from ._library import contact_library
from ._brief import brief
from ._status import Status
from ._structs import rc_area, rc_histogram, rc_patches, rc_result
from .context import Context, Options, OptionSet
from .system import Repeats, System, axes_of, grid_struct

__all__ = [
    *("area", "patches", "histogram", "crossing", "conductance", "punch_stiffness"),
    *("Area", "Patches", "Histogram", "Crossing", "Conductance", "PunchStiffness"),
]


def __dir__() -> Sequence[str]:
    return __all__


@dataclass(frozen=True)
class Area:
    """contacts: points; area; corrected_area: corrected for partly covered cells [length^2]; perimeter [length]"""

    contacts: int
    area: float
    perimeter: float
    corrected_area: float


@dataclass(frozen=True, eq=False, repr=False)
class Patches:
    """Connected parts of a contact, numbered by their lowest point.

    label: of the grid's shape, number of the patch, -1 without contact
    cells: points of each patch; area [length^2], perimeter [length], load [force], mean_pressure, max_pressure [force/length^2]
    peak: flat index of the point with max_pressure
    """

    label: NDArray[np.int64]
    cells: NDArray[np.int64]
    area: Doubles
    perimeter: Doubles
    load: Doubles
    mean_pressure: Doubles
    max_pressure: Doubles
    peak: NDArray[np.int64]

    def __len__(self) -> int:
        return len(self.cells)

    def __repr__(self) -> str:
        largest = f", the largest of {self.cells.max()} points" if len(self) else ""
        return f"Patches({len(self)}{largest})"


@dataclass(frozen=True, eq=False, repr=False)
class Histogram:
    """Distribution of pressure over the points in contact.

    edges: of the bins [force/length^2]; counts: points; density: share of the contact per pressure [length^2/force]
    contacts: points; above: of these beyond the last edge; mean_pressure, max_pressure [force/length^2]
    """

    edges: Doubles
    counts: NDArray[np.int64]
    density: Doubles
    contacts: int
    above: int
    mean_pressure: float
    max_pressure: float

    __repr__ = brief


@dataclass(frozen=True)
class Crossing:
    """Axes along which the contact, and the open gap, connects opposite sides: "none", "x", "y" or "xy".

    repeats: along which axes the grid repeats: a part that crosses along x may go around along y if this has "y", and the reverse
    """

    contact: str
    gap: str
    repeats: str = field(default="none", compare=False)

    def __str__(self) -> str:
        return f"the contact crosses {self._along(self.contact)}, the gap {self._along(self.gap)}"

    def _along(self, axes: str) -> str:
        across = {"x": "y", "y": "x"}
        periodic = {axis: f" (with {across[axis]} periodic)" if across[axis] in self.repeats else "" for axis in across}
        return " and ".join(f"along {axis}{periodic[axis]}" for axis in across if axis in axes) or "along no axis"


@dataclass(frozen=True)
class Conductance:
    """Conductance of a contact; the exact one lies between lower and upper, NaN unless option stiffness is 2."""

    value: float
    lower: float
    upper: float


@dataclass(frozen=True)
class PunchStiffness:
    """[force/length]; the exact one lies between lower and upper, NaN where no bound of the operator's eigenvalues is known."""

    value: float
    lower: float
    upper: float


def _grid(pressure: ArrayLike, pitch: Pitch, periodic: Repeats, mask: Optional[ArrayLike]) -> Tuple[Any, Doubles, Optional[Mask]]:
    array = as_doubles(pressure, "pressure")
    if array.ndim not in (1, 2):
        raise ShapeError(f"pressure has {array.ndim} axes: [ny, nx] is needed")
    refuse_one_row(array, "pressure", pitch)
    return grid_struct(array.shape, as_pitch(pitch), periodic), array, as_mask(mask, "mask", array.shape)


def area(pressure: ArrayLike, *, pitch: Pitch, periodic: Repeats = False, mask: Optional[ArrayLike] = None) -> Area:
    """Area, perimeter, and the area corrected for partly covered cells.

    pressure: [ny, nx] >= 0 [force/length^2]; pitch: one number or (hx, hy) [length]; mask: 0: not in contact, whatever its
        pressure
    """
    system, p, m = _grid(pressure, pitch, periodic, mask)
    out = rc_area()
    check(contact_library().rc_area_measure(system, array_in(p), array_in(m), out))
    return Area(**members_for(Area, out))


def patches(
    pressure: ArrayLike, *, pitch: Pitch, periodic: Repeats = False, mask: Optional[ArrayLike] = None, corners: bool = False
) -> Patches:
    """Connected parts of the contact; corners: across corners of cells as well as edges. Arguments as in `area`."""
    system, p, m = _grid(pressure, pitch, periodic, mask)
    library = contact_library()
    label = np.empty(p.shape, np.int64)
    struct = given(rc_patches(), label=label, neighbours=8 if corners else None)
    check(library.rc_patches_find(system, array_in(p), array_in(m), struct))
    whole: Dict[str, Any] = {name: np.empty(struct.count, np.int64) for name in ("cells", "peak")}
    real: Dict[str, Any] = {
        name: np.empty(struct.count) for name in ("area", "perimeter", "load", "mean_pressure", "max_pressure")
    }
    struct.room, struct.label = struct.count, array_out(None)
    given(struct, **whole, **real)
    check(library.rc_patches_find(system, array_in(p), array_in(m), struct))
    return Patches(label=label, **whole, **real)


def histogram(
    pressure: ArrayLike,
    bins: int,
    upper: Optional[float] = None,
    *,
    pitch: Pitch,
    periodic: Repeats = False,
    mask: Optional[ArrayLike] = None,
) -> Histogram:
    """Histogram of the pressures; upper: end of the last bin [force/length^2], None: the largest pressure. Others as in `area`."""
    system, p, m = _grid(pressure, pitch, periodic, mask)
    bins = as_int(bins, "bins")
    counts, density = np.zeros(max(bins, 0), np.int64), np.zeros(max(bins, 0))
    struct = given(rc_histogram(), bins=bins, upper=upper, counts=counts, density=density)
    check(contact_library().rc_histogram_fill(system, array_in(p), array_in(m), struct))
    own = {"edges": struct.width * np.arange(bins + 1), "counts": counts, "density": density}
    return Histogram(**{**members_for(Histogram, struct), **own})


def crossing(pressure: ArrayLike, *, pitch: Pitch = 1.0, periodic: Repeats = False, mask: Optional[ArrayLike] = None) -> Crossing:
    """Percolation of contact and gap: whether a connected part of them joins the sides at the ends of x, or of y.

    These two sides are never joined, as the inlet and outlet of a seal; the grid repeats across the axis if periodic says so. Points
    are connected across edges, and a masked one belongs to neither. pitch does not matter. Others as in `area`.
    """
    system, p, m = _grid(pressure, pitch, periodic, mask)
    contact, gap = np.zeros(1, np.int32), np.zeros(1, np.int32)
    check(contact_library().rc_crossing_find(system, array_in(p), array_in(m), pointer(contact), pointer(gap)))
    axes = {
        _constants.RC_CROSSES_NONE: "none",
        _constants.RC_CROSSES_X: "x",
        _constants.RC_CROSSES_Y: "y",
        _constants.RC_CROSSES_X + _constants.RC_CROSSES_Y: "xy",
    }
    return Crossing(axes[int(contact[0])], axes[int(gap[0])], axes_of(periodic))


def conductance(result: Any, rho1: float, rho2: float) -> Conductance:
    """Electrical or thermal conductance of a contact of half-spaces, 2 / (E* (rho1 + rho2)) dW/dd (Barber 2003).

    result: a `Result` with option stiffness 1 or 2, of a homogeneous half-space (`Result.homogeneous`)
    rho1, rho2: resistivities of the bodies, or reciprocals of their thermal conductivities
    """
    if result.grid.modulus is None:
        raise ArgumentError("the result is not of a HalfSpace: no conductance follows from the stiffness of your own matrix or product")
    system = grid_struct(result.grid.shape, result.grid.pitch, result.grid.periodic)
    system.op, system.modulus = _constants.RC_OPERATOR_HALFSPACE, result.grid.modulus
    names = ("stiffness", "stiffness_lower", "stiffness_upper")
    struct = given(rc_result(), **{name: getattr(result, name) for name in (*names, "homogeneous")})
    struct.kernel = result.kernel.encode()
    found = [ctypes.c_double() for _ in names]
    check(contact_library().rc_conductance(system, struct, float(rho1), float(rho2), *found))
    return Conductance(*(each.value for each in found))


def punch_stiffness(
    system: System, mask: Optional[ArrayLike] = None, *, options: Options = None, context: Optional[Context] = None
) -> PunchStiffness:
    """dW/dd of a rigid flat punch that touches exactly the points where the mask is not 0; None: all. A contact on these points
    has this `Result.stiffness`. Infinite for all points of a periodic system."""
    touching = as_mask(mask, "mask", system.shape)
    struct, product = system.struct()
    found = [ctypes.c_double() for _ in range(3)]

    def call() -> int:
        with OptionSet(options, context) as handle:
            return int(contact_library().rc_punch_stiffness(struct, array_in(touching), handle, *found))

    status, message, interrupt = interruptible(call, keep=(system, product, touching))
    conclude(status, message, interrupt, None, status == Status.STOP_CANCELLED, product)
    return PunchStiffness(*(each.value for each in found))

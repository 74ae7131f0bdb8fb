"""Answers."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any, Dict, Optional, Tuple, Union

import numpy as np
from numpy.typing import NDArray

from . import analysis
from ._answers import Answer, Stored
from ._arrays import Doubles, Mask, Reals, Shape, doubles_at
from ._brief import brief
from ._c import members_for
from ._device import on_host
from ._errors import as_status
from ._flow import Leak, leak_of
from ._measures import STEP_COLUMNS, UNKNOWN, Measures, measures_of
from ._pictures import pressure_image
from ._remarks import elastic_limit
from ._request import Smooth as Smooth
from ._status import Status
from ._structs import rc_array, rc_level, rc_result
from .context import Context, Options
from .system import System


@dataclass(frozen=True, repr=False)
class Grid(Stored):
    """Where an answer lives: shape, (hx, hy) [length], whether it repeats (True, False, or along "x" or "y" only), the points
    left out, the half-space's E*, and the hardness (None: none)."""

    shape: Shape
    pitch: Tuple[float, float]
    periodic: Union[bool, str] = False
    mask: Optional[Mask] = None
    modulus: Optional[float] = None
    hardness: Optional[float] = None

    @property
    def area(self) -> float:
        """Nominal area: that of all cells [length^2]."""
        return float(np.prod(self.shape)) * self.pitch[0] * self.pitch[1]

    __repr__ = brief


@dataclass(frozen=True)
class Accuracy(Stored):
    """The grid of an answer, and its estimated errors.

    model_nx, model_ny: points of the grid that was solved
    error_estimate: with option accuracy: estimated relative error of the load or area that accuracy.of names
    area_estimate: the same for the area, which a goal of the load does not bound
    left_out: roughness that the solved grid leaves out, rms over the points in contact [length]
    """

    model_nx: int
    model_ny: int
    error_estimate: float
    area_estimate: float
    left_out: float


@dataclass(frozen=True, eq=False, repr=False)
class Result(Answer):
    """Answer of one step. All numbers are those of rc_result in <roughcontact/roughcontact.h>, and those that the command
    computes from the pressures: corrected_area, patches, largest_patch, contact_crosses, gap_crosses.

    pressure: of the grid's shape [force/length^2]; None if not wanted
    gap: deformed gap, of the grid's shape [length]; None if not wanted. Where the undeformed gap was on a device, both are arrays
        there, of the same package
    status, message: how it ended; the message is empty for Status.OK
    """

    status: Status
    message: str
    pressure: Optional[Any]
    gap: Optional[Any]
    grid: Grid
    #: of the solver, all rounds together
    iterations: int
    #: products with H, the certificate's and the stiffness' included
    products: int
    points: int
    #: points that can carry pressure at this approach
    candidates: int
    #: unknowns or transform points of the operator used
    modelled: int
    #: points with pressure
    contacts: int
    #: [force]
    load: float
    #: of the bodies from first touch of the undeformed gap's zero [length]
    approach: float
    #: load over the area of the grid [force/length^2]
    mean_pressure: float
    #: [length^2]
    contact_area: float
    #: the functional that is minimised [force length]
    energy: float
    #: dW/dd [force/length]; NaN where option stiffness is 0, or its solve lowers no residual
    stiffness: float
    kkt_primal: float
    kkt_dual: float
    kkt_complementarity: float
    kkt_control: float
    #: solving and certifying
    seconds: float
    #: influence coefficients, plans and factors built in this call
    setup_seconds: float
    solver: str
    backend: str
    kernel: str
    #: operations that were substituted, remarks of the solver
    note: str
    #: the energy is above the least one by this at most [force length]; NaN where no proof is known
    duality_gap: float
    #: the exact deformed gap of every point differs from `gap` by at most this [length]
    gap_error: float
    #: the exact load at this approach lies between [force]
    load_lower: float
    load_upper: float
    #: the exact contact area lies between [length^2]
    area_lower: float
    area_upper: float
    #: points proven to be in contact, out of contact, and the others; -1 where no proof is known
    proven_contacts: int
    proven_open: int
    undecided: int
    #: coarse solutions kept, see `Contact.levels`
    levels: int
    #: limit of the residuals
    tolerance: float
    #: the exact dW/dd at this approach lies between [force/length]; NaN unless option stiffness is 2
    stiffness_lower: float
    stiffness_upper: float
    #: dW/dd of a rigid flat punch as large as the map, which bounds that of a map with free edges [force/length]; NaN where stiffness
    #: is, and with periodic boundaries
    punch_stiffness: float
    #: 1: the kernel is that of a homogeneous half-space, so that a conductance follows from the stiffness
    homogeneous: int
    #: points that carry the system's hardness; 0 without one
    capped: int
    #: of the overlap of these points in this step [length^3]
    plastic_volume: float
    #: points proven to carry the hardness; -1 where no proof is known
    proven_capped: int
    #: contacts / points
    area_fraction: float
    #: [force/length^2]
    max_pressure: float
    #: of the points that are not masked [length]; NaN in sparse contact unless want_gap=True
    mean_gap: float
    #: what was computed from the pressures; None: it is computed when asked for
    measures: Optional[Measures]
    #: which grid it is of, and estimated errors
    accuracy: Accuracy
    #: what was taken where neither words nor maps say it, and what was done to the surface, a sentence each
    assumed: Tuple[str, ...] = ()
    #: of the smooth body; None without the word shape
    smooth: Optional[Smooth] = None

    @property
    def certified(self) -> bool:
        """Whether every residual is within the tolerance."""
        return self.status == Status.OK

    @property
    def residual(self) -> float:
        """The largest kkt_* residual."""
        return max(self.kkt_primal, self.kkt_dual, self.kkt_complementarity, self.kkt_control)

    @property
    def remarks(self) -> str:
        """The note; and where the largest pressure is beyond every body's hardness or linear elasticity, with pressures in Pa,
        as the command says it."""
        modulus, known = self.grid.modulus, [self.note] if self.note else []
        doubt = elastic_limit(self.max_pressure, modulus, "hardness=") if modulus and not self.capped else ""
        return "; ".join(known + ([f"largest pressure {self.max_pressure:.3g}: {doubt}"] if doubt else []))

    @property
    def corrected_area(self) -> float:
        """Contact area, corrected for partly covered cells [length^2]."""
        return self._measured.corrected_area

    @property
    def patches(self) -> int:
        """Number of connected parts of the contact, across edges; `find_patches` finds them."""
        return self._measured.patches

    @property
    def largest_patch(self) -> float:
        """Its area [length^2]."""
        return self._measured.largest_patch

    @property
    def contact_crosses(self) -> str:
        """Axes along which the contact connects opposite sides: "none", "x", "y" or "xy"; see `gap_crosses`."""
        return self._measured.contact_crosses

    @property
    def gap_crosses(self) -> str:
        """Axes along which the open gap connects the side where a fluid enters with the opposite one: "none", "x", "y" or "xy". The
        map repeats across the axis if its boundary does, never along it. With "none" nothing leaks."""
        return self._measured.gap_crosses

    @cached_property
    def _measured(self) -> Measures:
        return self.measures or measures_of(self._needed(), self.grid)

    def measure_area(self) -> analysis.Area:
        """Contact area corrected for the grid, and perimeter."""
        return analysis.area(self._needed(), **self._grid())

    def find_patches(self, corners: bool = False) -> analysis.Patches:
        """Connected parts of the contact; corners: across corners of cells as well as edges."""
        return analysis.patches(self._needed(), **self._grid(), corners=corners)

    def histogram(self, bins: int, upper: Optional[float] = None) -> analysis.Histogram:
        """Distribution of the pressures."""
        return analysis.histogram(self._needed(), bins, upper, **self._grid())

    def conductance(self, rho1: float, rho2: float) -> analysis.Conductance:
        """Electrical or thermal conductance of the contact; needs option stiffness 1 or 2, and `homogeneous`.

        rho1, rho2: resistivities of the bodies, or reciprocals of their thermal conductivities
        """
        return analysis.conductance(self, rho1, rho2)

    def leak(
        self,
        *,
        viscosity: float,
        pressure_drop: float,
        along: str = "x",
        sides: Optional[str] = None,
        load: Optional[float] = None,
        width: Optional[float] = None,
        memory: Optional[float] = None,
        want_potential: bool = False,
        system: Optional[System] = None,
        options: Options = None,
        context: Optional[Context] = None,
    ) -> Leak:
        """How much fluid flows through the gap, with an interval that follows from `gap_error`; needs want_gap=True.

        load: that the step prescribed: the interval then holds at this load; None: at the returned approach
        sides: as in `roughcontact.flow`; None: as the boundary repeats
        system: of a result that is not of a `HalfSpace`; options, context: the contact's, with load for a kernel with options of its own
        Others as in `roughcontact.flow`.
        """
        wanted = {"viscosity": viscosity, "pressure_drop": pressure_drop, "load": load, "width": width, "memory": memory}
        return leak_of(self, want_potential, system, options, context, along=along, sides=sides, **wanted)

    def _grid(self) -> Dict[str, Any]:
        return {"pitch": self.grid.pitch, "periodic": self.grid.periodic, "mask": self.grid.mask}

    def _needed(self) -> Any:
        if self.pressure is None:
            raise ValueError("the result has no pressures; solve with want_pressure=True")
        return self.pressure

    def _columns(self) -> Dict[str, Any]:
        known = self.measures is not None or self.pressure is not None and np.prod(self.grid.shape) == self.points
        own = {**super()._columns(), **vars(self._measured if known else UNKNOWN)}
        own.update(vars(self.accuracy))
        if self.smooth:
            own.update({f"smooth_{name}": value for name, value in vars(self.smooth).items()})
        return {name: own.pop(name) for name in STEP_COLUMNS} | own

    def _rows(self) -> Dict[str, str]:
        return {
            "status": self.status.name,
            "load": f"{self.load:.6g} ({self.load_lower:.6g} to {self.load_upper:.6g})",
            "approach": f"{self.approach:.6g}",
            "contact": f"{self.contacts} of {self.points} points, {self.contacts / self.points:.2%}",
            "largest pressure": f"{self.max_pressure:.6g}" + (f" at {self.capped} points" if self.capped > 1 else ""),
            "mean pressure": f"{self.mean_pressure:.6g}",
            "by": f"{self.solver} on {self.backend}, residual {self.residual:.1e}",
            **({"smooth": f"contact {self.smooth.width:.6g} wide, approach {self.smooth.approach:.6g}"} if self.smooth else {}),
            **({"note": self.remarks} if self.remarks else {}),
            **({"assumed": "; ".join(self.assumed)} if self.assumed else {}),
        }

    def _picture(self) -> Optional[str]:
        return None if self.pressure is None else pressure_image(on_host(self.pressure))

    def __repr__(self) -> str:
        return (
            f"Result({self.status.name}, load={self.load:.6g}, approach={self.approach:.6g}, "
            f"contacts={self.contacts} of {self.points}, residual={self.residual:.1e}, {self.solver} on {self.backend}"
            + (f"; note: {self.remarks})" if self.remarks else ")")
        )


def result_from(struct: rc_result, message: str, grid: Grid, pressure: Optional[Reals], gap: Optional[Reals]) -> Result:
    answer, accuracy = object.__new__(Result), object.__new__(Accuracy)  # __init__ would set their 60 members one by one
    vars(accuracy).update(members_for(Accuracy, struct))
    own = {"message": message, "pressure": pressure, "gap": gap, "grid": grid, "measures": None, "accuracy": accuracy}
    vars(answer).update(members_for(Result, struct), status=as_status(struct.status), assumed=(), smooth=None, **own)
    return answer


def result_with_copies(struct: rc_result, grid: Grid) -> Result:
    """From inside a callback, whose arrays last only until it returns."""

    def copy(array: rc_array) -> Optional[Doubles]:
        return doubles_at(array, grid.shape).copy() if array.data else None

    return result_from(struct, "", grid, copy(struct.p), copy(struct.gap))


@dataclass(frozen=True, eq=False, repr=False)
class Level:
    """A solution on a coarser grid that a multilevel solver left behind. pressure: [ny, nx] [force/length^2]; pitch
    [length]."""

    pressure: Doubles
    status: Status
    pitch: Tuple[float, float]
    approach: float
    load: float
    candidates: int
    contacts: int

    __repr__ = brief


def level_from(struct: rc_level, pressure: Doubles) -> Level:
    own = {"status": as_status(struct.status), "pressure": pressure, "pitch": (struct.hx, struct.hy)}
    return Level(**{**members_for(Level, struct), **own})


@dataclass(frozen=True, eq=False, repr=False)
class BatchResult(Answer):
    """Answers of many contacts. Arrays are [contacts, steps]; NaN and -1 stand for steps that failed or were not reached.

    statuses: of every step, see `Status`
    load [force], approach [length], contact_area [length^2], certificate: largest residual, iterations, products
    stiffness: dW/dd [force/length]; None unless asked for, as mean_gap [length], energy [force length], and intervals that are proven
        to hold the exact load, contact area and stiffness
    pressure: [contacts, ny, nx] of each contact's last step, 0 where it has none [force/length^2]; None unless asked for
    certified: contacts of which every step is certified
    first: the contact whose status is given; -1: none
    assumed: as of a `Result`
    """

    status: Status
    message: str
    statuses: NDArray[np.int32]
    load: Doubles
    approach: Doubles
    contact_area: Doubles
    certificate: Doubles
    iterations: NDArray[np.int64]
    products: NDArray[np.int64]
    stiffness: Optional[Doubles]
    mean_gap: Optional[Doubles]
    energy: Optional[Doubles]
    load_lower: Optional[Doubles]
    load_upper: Optional[Doubles]
    area_lower: Optional[Doubles]
    area_upper: Optional[Doubles]
    stiffness_lower: Optional[Doubles]
    stiffness_upper: Optional[Doubles]
    pressure: Optional[Doubles]
    certified: int
    first: int
    grid: Grid
    assumed: Tuple[str, ...] = ()

    @property
    def mean_pressure(self) -> Doubles:
        """load over the area of the grid [force/length^2]"""
        return self.load / self.grid.area

    @property
    def area_fraction(self) -> Doubles:
        """contact_area over the area of the grid"""
        return self.contact_area / self.grid.area

    steps = ("contact", "step")

    def _columns(self) -> Dict[str, Any]:
        return {**super()._columns(), "mean_pressure": self.mean_pressure, "area_fraction": self.area_fraction}

    def _counts(self) -> Tuple[int, ...]:
        return self.load.shape

    def _rows(self) -> Dict[str, str]:
        return {"status": self.status.name, "contacts": f"{self.certified} of {len(self.load)} certified"}

    def _picture(self) -> Optional[str]:
        return None

    def __repr__(self) -> str:
        return f"BatchResult({self.status.name}, {self.certified} of {len(self.load)} contacts certified)"

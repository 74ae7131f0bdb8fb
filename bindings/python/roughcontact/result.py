"""Answers."""

from dataclasses import dataclass
from typing import Any, Dict, Optional, Tuple

import numpy as np
from numpy.typing import NDArray

from . import analysis
from ._answers import Answer, Stored
from ._arrays import Doubles, Mask, Reals, Shape
from ._c import members_for
from ._device import on_host
from ._errors import as_status
from ._library import contact_library
from ._pictures import curve, pressure_image
from ._status import Status
from ._steps import Steps
from ._structs import rc_accuracy, rc_level, rc_result


@dataclass(frozen=True)
class Grid(Stored):
    """Where an answer lives: shape, (hx, hy) [length], whether it repeats, the points left out, and the half-space's E*."""

    shape: Shape
    pitch: Tuple[float, float]
    periodic: bool = False
    mask: Optional[Mask] = None
    modulus: Optional[float] = None


@dataclass(frozen=True)
class Accuracy(Stored):
    """Which grid an answer is of, and how far off it may be.

    model_nx, model_ny: points of the grid that was solved
    error_estimate: with option accuracy: estimated relative error of what it is of, load or area
    area_estimate: likewise of the area, which a goal of the load does not hold
    left_out: roughness that the solved grid does not see, rms over the points in contact [length]
    """

    model_nx: int
    model_ny: int
    error_estimate: float
    area_estimate: float
    left_out: float


@dataclass(frozen=True, eq=False)
class Result(Answer):
    """Answer of one step. All numbers are those of rc_result in <roughcontact/roughcontact.h>.

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
    #: dW/dd [force/length]; NaN where option stiffness is 0
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
    #: what the residuals were held to
    tolerance: float
    #: the exact dW/dd at this approach lies between [force/length]; NaN unless option stiffness is 2
    stiffness_lower: float
    stiffness_upper: float
    #: points that carry the system's hardness; 0 without one
    capped: int
    #: of the overlap of these points in this step [length^3]
    plastic_volume: float
    #: points proven to carry the hardness; -1 where no proof is known
    proven_capped: int
    #: which grid it is of, and estimated errors; None in `batch`
    accuracy: Optional[Accuracy]

    @property
    def certified(self) -> bool:
        """Whether every residual is within the tolerance."""
        return self.status == Status.OK

    @property
    def residual(self) -> float:
        """The largest kkt_* residual."""
        return max(self.kkt_primal, self.kkt_dual, self.kkt_complementarity, self.kkt_control)

    def area(self) -> analysis.Area:
        """Contact area corrected for the grid, and perimeter."""
        return analysis.area(self._needed(), **self._grid())

    def patches(self, corners: bool = False) -> analysis.Patches:
        """Connected parts of the contact."""
        return analysis.patches(self._needed(), **self._grid(), corners=corners)

    def histogram(self, bins: int, upper: Optional[float] = None) -> analysis.Histogram:
        """Distribution of the pressures."""
        return analysis.histogram(self._needed(), bins, upper, **self._grid())

    def conductance(self, rho1: float, rho2: float) -> analysis.Conductance:
        """Electrical or thermal conductance of the contact; needs option stiffness 1 or 2.

        rho1, rho2: resistivities of the bodies, or reciprocals of their thermal conductivities
        """
        return analysis.conductance(self, rho1, rho2)

    def _grid(self) -> Dict[str, Any]:
        return {"pitch": self.grid.pitch, "periodic": self.grid.periodic, "mask": self.grid.mask}

    def _needed(self) -> Any:
        if self.pressure is None:
            raise ValueError("the result has no pressures; solve with want_pressure=True")
        return self.pressure

    def _rows(self) -> Dict[str, str]:
        return {
            "status": self.status.name,
            "load": f"{self.load:.6g} ({self.load_lower:.6g} to {self.load_upper:.6g})",
            "approach": f"{self.approach:.6g}",
            "contact": f"{self.contacts} of {self.points} points, {self.contacts / self.points:.2%}",
            "largest pressure": "" if self.pressure is None else f"{np.max(on_host(self.pressure), initial=0):.6g}",
            "mean pressure": f"{self.mean_pressure:.6g}",
            "by": f"{self.solver} on {self.backend}, residual {self.residual:.1e}",
            **({"note": self.note} if self.note else {}),
        }

    def _picture(self) -> Optional[str]:
        return None if self.pressure is None else pressure_image(on_host(self.pressure))

    def __repr__(self) -> str:
        return (
            f"Result({self.status.name}, load={self.load:.6g}, approach={self.approach:.6g}, "
            f"contacts={self.contacts} of {self.points}, residual={self.residual:.1e}, {self.solver} on {self.backend})"
        )


def result_from(
    struct: rc_result, message: str, grid: Grid, pressure: Optional[Reals], gap: Optional[Reals], contact: Any = None
) -> Result:
    """contact: the C object that the accuracy is asked of, or None."""
    own = {"status": as_status(struct.status), "message": message, "pressure": pressure, "gap": gap, "grid": grid}
    accuracy = rc_accuracy()
    known = contact is not None and contact_library().rc_contact_accuracy(contact, accuracy) == Status.OK
    own["accuracy"] = Accuracy(**members_for(Accuracy, accuracy)) if known else None
    return Result(**{**members_for(Result, struct), **own})


def result_with_copies(struct: rc_result, grid: Grid, contact: Any = None) -> Result:
    """From inside a callback, whose arrays last only until it returns."""
    n = int(np.prod(grid.shape))

    def copy(values: Any) -> Optional[Doubles]:
        return np.ctypeslib.as_array(values, (n,)).reshape(grid.shape).copy() if values else None

    return result_from(struct, "", grid, copy(struct.p), copy(struct.gap), contact)


@dataclass(frozen=True, eq=False)
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


def level_from(struct: rc_level, pressure: Doubles) -> Level:
    own = {"status": as_status(struct.status), "pressure": pressure, "pitch": (struct.hx, struct.hy)}
    return Level(**{**members_for(Level, struct), **own})


@dataclass(frozen=True, eq=False)
class HistoryResult(Steps, Answer):
    """Answers of a loading history. Arrays have one value for each completed step.

    load [force], approach [length], contact_area [length^2], certificate: largest residual, products: products with H
    stiffness: dW/dd [force/length]; None unless asked for
    pressure: [steps, ny, nx] [force/length^2]; None unless asked for
    targets: as given, those of steps that were not completed as well
    """

    status: Status
    message: str
    targets: Doubles
    load: Doubles
    approach: Doubles
    contact_area: Doubles
    certificate: Doubles
    products: NDArray[np.int64]
    stiffness: Optional[Doubles]
    pressure: Optional[Doubles]
    grid: Grid

    @property
    def completed(self) -> int:
        """Steps that were completed."""
        return len(self.load)

    steps = ("step",)

    def _counts(self) -> Tuple[int, ...]:
        return (self.completed,)

    def _rows(self) -> Dict[str, str]:
        ends = {"load": self.load, "approach": self.approach, "contact area": self.contact_area}
        return {
            "status": self.status.name,
            "steps": f"{self.completed} of {len(self.targets)}",
            **{name: f"{values.min():.6g} to {values.max():.6g}" for name, values in ends.items() if len(values)},
        }

    def _picture(self) -> Optional[str]:
        return curve(self.approach, self.load)

    def __repr__(self) -> str:
        return f"HistoryResult({self.status.name}, {self.completed} of {len(self.targets)} steps)"


@dataclass(frozen=True, eq=False)
class BatchResult(Answer):
    """Answers of many contacts. Arrays are [contacts, steps]; NaN and -1 stand for steps that failed or were not reached.

    statuses: of every step, see `Status`
    load [force], approach [length], contact_area [length^2], certificate: largest residual, iterations, products
    stiffness: dW/dd [force/length]; None unless asked for
    pressure: [contacts, ny, nx] of each contact's last step, 0 where it has none [force/length^2]; None unless asked for
    certified: contacts of which every step is certified
    first: the contact whose status is given; -1: none
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
    pressure: Optional[Doubles]
    certified: int
    first: int
    grid: Grid

    steps = ("contact", "step")

    def _counts(self) -> Tuple[int, ...]:
        return self.load.shape

    def _rows(self) -> Dict[str, str]:
        return {"status": self.status.name, "contacts": f"{self.certified} of {len(self.load)} certified"}

    def _picture(self) -> Optional[str]:
        return None

    def __repr__(self) -> str:
        return f"BatchResult({self.status.name}, {self.certified} of {len(self.load)} contacts certified)"

"""What stays fixed over a loading sequence: a half-space grid, your own matrix, or your own product."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Any, Callable, Dict, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _constants
from ._arrays import Doubles, Pitch, Shape, as_doubles, as_pitch, as_shape, as_text, columns_and_rows, pointer
from ._calls import Callbacks, check, last_message
from ._creep import Terms, give_creep
from ._elastic import Constant, needed_modulus
from ._errors import ArgumentError, ShapeError
from ._library import contact_library
from ._request import as_surface
from ._status import Status
from ._structs import rc_apply_fn, rc_system
from ._units import warn
from .context import Context, Options, OptionSet, context_handle

Repeats = Union[bool, str]  # True, False, or the one axis along which a grid repeats, "x" or "y"

REPEATS: Dict[str, Repeats] = {"free": False, "periodic": True, "periodic-x": "x", "periodic-y": "y"}
BOUNDARIES: Dict[Repeats, int] = {
    False: _constants.RC_BOUNDARY_FREE,
    True: _constants.RC_BOUNDARY_PERIODIC,
    "x": _constants.RC_BOUNDARY_PERIODIC_X,
    "y": _constants.RC_BOUNDARY_PERIODIC_Y,
}


class AssumedBoundary(UserWarning):
    """Neither the caller nor the surface gives a boundary: the map is treated as a periodic sample of a larger surface."""


def boundary_of(given: Optional[str], periodic: Optional[bool]) -> str:
    """What is given, else what the surface says (periodic), else "periodic", with a warning that the caller sees at its own line."""
    if given is None and periodic is None:
        warn(
            "boundary is taken as 'periodic', the map as a sample of a larger surface; pass boundary='free' if the body ends at the "
            "map's edges, as a ball or a punch does, else boundary='periodic'",
            AssumedBoundary,
        )
        return "periodic"
    boundary = given if given is not None else "periodic" if periodic else "free"
    if boundary not in REPEATS:
        raise ArgumentError(f"boundary is {boundary!r}: 'free', 'periodic', 'periodic-x' or 'periodic-y'")
    return boundary


class System(ABC):
    """`HalfSpace`, `Matrix` or `Product`.

    shape: of gaps and pressures
    pitch: (hx, hy), hx along the last axis [length]
    hardness: the largest pressure [force/length^2]; None: elastic
    creep: pairs (ratio, time) of the compliance, (1 + sum of ratio (1 - exp(-t/time))) times that at once; or relaxation: of the
        modulus, (1 - sum of ratio (1 - exp(-t/time))) times that at once. Every step then needs its time. None: no creep
    """

    shape: Shape
    pitch: Tuple[float, float]
    periodic: Repeats = False
    hardness: Optional[float] = None
    creep: Optional[Terms] = None
    relaxation: Optional[Terms] = None
    modulus: Optional[float] = None  # of a `HalfSpace`

    @abstractmethod
    def fill(self, system: rc_system) -> Callbacks:
        """Completes the C struct; what it returns knows what a callback raised. Arrays live as long as this object."""

    def __repr__(self) -> str:
        modulus = "" if self.modulus is None else f", modulus {self.modulus:.6g}, {name_of(self.periodic)}"
        hard = "" if self.hardness is None else f", hardness {self.hardness:.6g}"
        creeps = "" if self.creep is None and self.relaxation is None else ", creeps"
        points = " x ".join(map(str, self.shape[::-1]))
        return f"{type(self).__name__}({points} points, pitch {self.pitch[0]:g}, {self.pitch[1]:g}{modulus}{hard}{creeps})"

    def struct(self) -> Tuple[rc_system, Callbacks]:
        system = grid_struct(self.shape, self.pitch, self.periodic)
        system.hardness = 0 if self.hardness is None else self.hardness
        give_creep(system, self.creep, self.relaxation)
        return system, self.fill(system)


def name_of(periodic: Repeats) -> str:
    """The boundary of a grid that repeats like this."""
    return next(name for name, repeats in REPEATS.items() if repeats == periodic)


def axes_of(periodic: Repeats) -> str:
    """The axes along which such a grid repeats: "none", "x", "y" or "xy"."""
    return periodic if isinstance(periodic, str) else "xy" if periodic else "none"


def grid_struct(shape: Shape, pitch: Tuple[float, float], periodic: Repeats) -> rc_system:
    system = rc_system()
    system.nx, system.ny = columns_and_rows(shape)
    system.hx, system.hy = pitch
    if periodic not in BOUNDARIES:
        raise ArgumentError(f"periodic is {periodic!r}: True, False, 'x' or 'y'")
    system.boundary = BOUNDARIES[periodic]
    return system


def as_hardness(hardness: Optional[float]) -> Optional[float]:
    return None if hardness is None else float(hardness)


class HalfSpace(System):
    """An elastic half-space.

    shape: (ny, nx) or nx points
    pitch: cell size, one number or (hx, hy) with hx along the last axis [length]
    modulus: contact modulus E* = 1/((1-nu1^2)/E1 + (1-nu2^2)/E2) [force/length^2]; or E and nu, as in `solve`
    boundary: "periodic": the grid is a sample of a larger surface; "free": the body ends at the grid's edges; "periodic-x",
        "periodic-y": it repeats along this axis only; None: periodic, with an `AssumedBoundary` warning
    hardness: the largest pressure [force/length^2]; None: none. Where it acts the bodies may overlap, and the overlap is a
        plastic indentation that remains in later steps, see `Contact.indentation`
    creep, relaxation: as in `System`; modulus is that at once
    """

    def __init__(
        self,
        shape: Union[int, Sequence[int]],
        *,
        pitch: Pitch,
        modulus: Optional[float] = None,
        E: Optional[Constant] = None,
        nu: Optional[Constant] = None,
        boundary: Optional[str] = None,
        hardness: Optional[float] = None,
        creep: Optional[Terms] = None,
        relaxation: Optional[Terms] = None,
    ) -> None:
        boundary = boundary_of(boundary, None)
        self.creep, self.relaxation = creep, relaxation
        self.shape, self.pitch, self.modulus = as_shape(shape), as_pitch(pitch), float(needed_modulus(modulus, E, nu))
        self.boundary, self.periodic, self.hardness = boundary, REPEATS[boundary], as_hardness(hardness)

    @classmethod
    def under(
        cls,
        surface: Any,
        *,
        modulus: Optional[float] = None,
        E: Optional[Constant] = None,
        nu: Optional[Constant] = None,
        pitch: Optional[Pitch] = None,
        boundary: Optional[str] = None,
        hardness: Optional[float] = None,
        creep: Optional[Terms] = None,
        relaxation: Optional[Terms] = None,
    ) -> HalfSpace:
        """The grid of a surface: a `Surface`, a topography of SurfaceTopography, or an array with a pitch."""
        found = as_surface(surface, pitch)
        boundary = boundary_of(boundary, found.periodic)
        how: Dict[str, Any] = {"boundary": boundary, "hardness": hardness, "creep": creep, "relaxation": relaxation}
        return cls(found.shape, pitch=found.pitch, modulus=modulus, E=E, nu=nu, **how)

    def fill(self, system: rc_system) -> Callbacks:
        system.op, system.modulus = _constants.RC_OPERATOR_HALFSPACE, self.modulus
        return Callbacks()


class Matrix(System):
    """The caller's own influence matrix H, symmetric and positive definite [length per (force/length^2)].

    H: [n, n]; an array of doubles with contiguous rows or columns is not copied, and must not change
    shape: of gaps and pressures, n points altogether; None: (n,)
    pitch: one number or (hx, hy): hx hy is the area of a cell
    hardness, creep, relaxation: as in `HalfSpace`; H is that at once
    """

    def __init__(
        self,
        H: ArrayLike,
        *,
        pitch: Pitch,
        shape: Optional[Union[int, Sequence[int]]] = None,
        hardness: Optional[float] = None,
        creep: Optional[Terms] = None,
        relaxation: Optional[Terms] = None,
    ) -> None:
        self.H, self.hardness, self.creep, self.relaxation = square(H), as_hardness(hardness), creep, relaxation
        n = self.H.shape[0]
        self.shape, self.pitch = (n,) if shape is None else as_shape(shape), as_pitch(pitch)
        if int(np.prod(self.shape)) != n:
            raise ShapeError(f"H is {n} x {n}, but shape {self.shape} has {int(np.prod(self.shape))} points")

    def fill(self, system: rc_system) -> Callbacks:
        system.op, system.dense, system.dense_ld = _constants.RC_OPERATOR_DENSE, pointer(self.H), row_stride(self.H)
        return Callbacks()


def square(H: ArrayLike) -> Doubles:
    """H with contiguous rows. Being symmetric, its transpose does as well."""
    if isinstance(H, np.ndarray) and H.dtype == np.float64 and H.ndim == 2 and H.dtype.isnative and H.flags.aligned:
        for each in (H, H.T):
            if each.strides[1] == 8 and each.strides[0] % 8 == 0 and each.strides[0] >= 8 * each.shape[1]:
                array = each
                break
        else:
            array = np.require(H, np.float64, ["C", "A"])
    else:
        array = as_doubles(H, "H")
    if array.ndim != 2 or array.shape[0] != array.shape[1]:
        raise ShapeError(f"H has shape {array.shape}; it must be square")
    return array


def row_stride(H: Doubles) -> int:
    return max(int(H.strides[0]) // 8, int(H.shape[1]))


class Product(System):
    """The caller's own product y = H x with a symmetric positive definite H.

    apply: called with an array of `shape` that is to be read only [force/length^2], returns one of that shape [length]. It is
        called on the thread that solves, which is not the main one; by `batch` on several threads at the same time. An
        exception ends the solve and is raised by it.
    shape, pitch, hardness, creep, relaxation: as in `Matrix`
    """

    def __init__(
        self,
        apply: Callable[[Doubles], ArrayLike],
        shape: Union[int, Sequence[int]],
        *,
        pitch: Pitch,
        hardness: Optional[float] = None,
        creep: Optional[Terms] = None,
        relaxation: Optional[Terms] = None,
    ) -> None:
        self.hardness, self.creep, self.relaxation = as_hardness(hardness), creep, relaxation
        self.apply, self.shape, self.pitch = apply, as_shape(shape), as_pitch(pitch)

    def _call(self, x: Any, y: Any, n: int, _: Any) -> int:
        given = np.ctypeslib.as_array(x, (n,)).reshape(self.shape).copy()  # apply may keep it
        given.flags.writeable = False
        np.ctypeslib.as_array(y, (n,)).reshape(self.shape)[...] = as_doubles(self.apply(given), "the product", self.shape)
        return 0

    def fill(self, system: rc_system) -> Callbacks:
        callbacks = Callbacks()
        callbacks.kept = rc_apply_fn(callbacks.guarded(self._call))
        system.op, system.apply = _constants.RC_OPERATOR_CALLBACK, callbacks.kept
        return callbacks


def supported(
    solver: str, backend: str, system: System, *, load: bool = False, options: Options = None, context: Optional[Context] = None
) -> Tuple[Status, str]:
    """(Status.OK, "") if the solver can run on the backend for this system, else the status that solving would give and the
    reason.

    load: whether the load is prescribed instead of the approach
    """
    library = contact_library()
    struct, callbacks = system.struct()
    control = _constants.RC_CONTROL_LOAD if load else _constants.RC_CONTROL_APPROACH
    with OptionSet(options, context) as handle:
        names = as_text(solver, "solver"), as_text(backend, "backend")
        status = library.rc_pair_supported(context_handle(context), *names, struct, control, handle)
        reason = last_message() if status else ""
    callbacks.raise_first()
    if status == Status.ERR_ARGUMENT:
        check(status)
    return Status(status), reason

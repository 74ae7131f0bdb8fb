"""Flow through gaps, with intervals that are proven. These functions load libroughcontact-flow, which links CHOLMOD (GPL)."""

from __future__ import annotations

import ctypes
from dataclasses import dataclass
from typing import Any, Callable, Optional, Tuple

import numpy as np
from numpy.typing import ArrayLike

from . import _constants
from ._answers import Stored
from ._arrays import Doubles, Pitch, as_doubles, as_pitch, columns_and_rows, given, refuse_one_row, refuse_text
from ._brief import brief
from ._c import S, members_for
from ._calls import check, conclude, flow_calls, interruptible
from ._device import on_host
from ._errors import ArgumentError, as_status
from ._keywords import split_words
from ._library import flow_library
from ._pressed import pressed
from ._status import Status
from ._structs import rc_flow_closing, rc_flow_factors, rc_flow_result, rc_flow_spec, rc_result, rc_step
from .context import Context, Options, OptionSet
from .system import System, grid_struct

ALONG = {"x": _constants.RC_FLOW_X, "y": _constants.RC_FLOW_Y}
SIDES = {"closed": _constants.RC_FLOW_CLOSED, "periodic": _constants.RC_FLOW_PERIODIC}


@dataclass(frozen=True, eq=False, repr=False)
class Leak(Stored):
    """How much flows through a gap. All numbers are those of rc_flow_result in <roughcontact/flow.h>.

    status, message: Status.OK, or Status.STOP_STALLED: the interval is wider than wanted
    flow: computed [length^3/time]; lower, upper: the exact one lies between these; both 0: the gap is proven to be closed
    constriction: the lowest gap on the best path [length], and its cell; 0 and -1 if nothing flows
    crosses: whether the computed gap connects inlet and outlet
    gap_error: the largest error of the gap that was counted [length]; dropped: share of the cells that the lower bound closes
    potential: of the grid's shape, the fluid's pressure above the outlet's over the drop, NaN where nothing flows; None if not
        wanted
    """

    status: Status
    message: str
    flow: float
    lower: float
    upper: float
    constriction: float
    constriction_x: int
    constriction_y: int
    crosses: bool
    gap_error: float
    dropped: float
    iterations: int
    seconds: float
    potential: Optional[Doubles]

    __repr__ = brief


@dataclass(frozen=True)
class FlowFactors(Stored):
    """Conductances of a cell that repeats, per pressure gradient [length^3]; the exact ones lie between the others.

    The mean flow is q = -(1/(12 viscosity)) [[xx, xy], [xy, yy]] grad p [length^2/time].
    """

    status: Status
    message: str
    xx: float
    xy: float
    yy: float
    xx_lower: float
    xx_upper: float
    xy_lower: float
    xy_upper: float
    yy_lower: float
    yy_upper: float
    mean_gap: float
    seconds: float

    @property
    def phi(self) -> Doubles:
        """The pressure flow factors of mixed lubrication: [[xx, xy], [xy, yy]] over the cube of the mean gap."""
        return np.array([[self.xx, self.xy], [self.xy, self.yy]]) / self.mean_gap**3


@dataclass(frozen=True)
class ClosingPressure(Stored):
    """Mean pressures: at the lower one the gap is proven to be open, at the upper one to be closed [force/length^2].

    area_fraction: in contact at the upper one; constriction: of the gap at the lower one [length]; steps: of the contact
    """

    status: Status
    message: str
    lower: float
    upper: float
    area_fraction: float
    constriction: float
    steps: int
    seconds: float


def _spec(along: str, sides: Optional[str], **values: Any) -> rc_flow_spec:
    for name, value, known in (("along", along, ALONG), ("sides", sides, SIDES)):
        if value is not None and value not in known:
            raise ArgumentError(f"{name} is {value!r}: {' or '.join(map(repr, known))}")
    for name, value in values.items():
        refuse_text(name, value)
    return given(rc_flow_spec(), along=ALONG[along], sides=None if sides is None else SIDES[sides], **values)


def _called(cls: Any, struct: S, call: Callable[[], int], keep: Any, **own: Any) -> Any:
    """The answer of a call of the library, also where its interval is wider than wanted."""
    status, message, interrupt = interruptible(call, keep=(keep, struct), of=flow_calls)
    known = interrupt is None and status in (Status.OK, Status.STOP_STALLED)
    answer = cls(**{**members_for(cls, struct), "status": as_status(status), "message": message, **own}) if known else None
    conclude(status, message, interrupt, None, not known)
    return answer


def _gap_spec(gap: ArrayLike, gap_error: Optional[ArrayLike], pitch: Pitch, spec: rc_flow_spec) -> Doubles:
    """Completes the spec; returns the gap."""
    array = as_doubles(gap, "gap")
    refuse_one_row(array, "gap", pitch)
    (nx, ny), (hx, hy) = columns_and_rows(array.shape), as_pitch(pitch)
    errors = None if gap_error is None else as_doubles(gap_error, "gap_error", array.shape)
    given(spec, nx=nx, ny=ny, hx=hx, hy=hy, gap=array, gap_error=errors)
    return array


def flow(
    gap: ArrayLike,
    *,
    pitch: Pitch,
    viscosity: float,
    pressure_drop: float,
    along: str = "x",
    sides: str = "closed",
    gap_error: Optional[ArrayLike] = None,
    width: Optional[float] = None,
    memory: Optional[float] = None,
    want_potential: bool = False,
) -> Leak:
    """How much fluid flows through a gap, by Reynolds' equation for a gap that is constant in each cell.

    gap: [ny, nx] >= 0, 0: closed [length]; gap_error: the exact gap differs by this at most; None: it is exact
    pitch: one number or (hx, hy) [length]; viscosity: dynamic [pressure time]; pressure_drop: inlet less outlet [pressure]
    along: "x" or "y": from the grid's first side across this axis to its last; sides: those along the flow, "closed": walls, or
        "periodic": a channel leaves at one and comes back at the other
    width: wanted width of the interval, over its upper end; memory: most bytes for the factor, see `rc_flow_spec`
    want_potential: whether the answer holds the fluid's pressure
    """
    spec = _spec(along, sides, viscosity=viscosity, pressure_drop=pressure_drop, width=width, memory=memory)
    array = _gap_spec(gap, gap_error, pitch, spec)
    potential = np.empty(array.shape) if want_potential else None
    given(spec, potential=potential)
    out = rc_flow_result()
    answer: Leak = _called(Leak, out, lambda: int(flow_library().rc_flow_solve(spec, out)), spec, potential=potential)
    return answer


def leak_values(system: Any, options: Any, result: Any, mask: Any, **fluid: Any) -> Tuple[float, float, float]:
    """(flow, lower, upper) of a result in C's form, on the thread of a callback."""
    spec, out = given(rc_flow_spec(), **fluid), rc_flow_result()
    spec.mask.data = ctypes.cast(mask, ctypes.c_void_p)
    library = flow_library()
    check(library.rc_flow_of_result(system.contents, options, result.contents, spec, out), flow_calls().last_message)
    return out.flow, out.lower, out.upper


def flow_factors(
    gap: ArrayLike,
    *,
    pitch: Pitch,
    gap_error: Optional[ArrayLike] = None,
    width: Optional[float] = None,
    memory: Optional[float] = None,
) -> FlowFactors:
    """The tensor of flow factors of a gap that repeats along both axes. Arguments as in `flow`."""
    spec = _spec("x", None, width=width, memory=memory)
    _gap_spec(gap, gap_error, pitch, spec)
    out = rc_flow_factors()
    answer: FlowFactors = _called(FlowFactors, out, lambda: int(flow_library().rc_flow_factors_find(spec, out)), spec)
    return answer


def leak_of(
    result: Any, want_potential: bool, system: Optional[System], options: Options, context: Optional[Context], **wanted: Any
) -> Leak:
    """See `Result.leak`."""
    grid = result.grid
    if result.gap is None or result.pressure is None:
        raise ArgumentError("a leak needs the pressures and the gap; solve with want_gap=True and want_pressure=True")
    pressure, deformed = on_host(result.pressure), on_host(result.gap)
    if np.float32 in (pressure.dtype, deformed.dtype):
        raise ArgumentError("the result's arrays are float32, whose rounding no proof covers; solve in float64")
    if system is None and grid.modulus is None:
        raise ArgumentError("the result is not of a HalfSpace; pass system=, of which the proof needs the matrix")
    struct, product = (grid_struct(grid.shape, grid.pitch, grid.periodic), None) if system is None else system.struct()
    if system is None:
        struct.op, struct.modulus, struct.hardness = _constants.RC_OPERATOR_HALFSPACE, grid.modulus, grid.hardness or 0
    potential = np.empty(grid.shape) if want_potential else None
    spec = given(_spec(**wanted), mask=grid.mask, potential=potential)
    names = ("status", "load", "approach", "duality_gap", "gap_error", "proven_contacts")
    solved = given(rc_result(), p=as_doubles(pressure, "pressure"), gap=as_doubles(deformed, "gap"))
    given(solved, **{name: getattr(result, name) for name in names})
    out, kernel = rc_flow_result(), {_constants.RC_OPT_KERNEL: result.kernel} if result.kernel else {}

    def call() -> int:
        with OptionSet({**kernel, **dict(options or {})}, context) as handle:
            return int(flow_library().rc_flow_of_result(struct, handle, solved, spec, out))

    answer: Leak = _called(Leak, out, call, (spec, solved, system, product), potential=potential)
    return answer


def closing_pressure(
    heights: Any = None,
    *,
    along: str = "x",
    sides: Optional[str] = None,
    width: Optional[float] = None,
    undeformed_gap: Optional[ArrayLike] = None,
    mask: Optional[ArrayLike] = None,
    system: Optional[System] = None,
    options: Options = None,
    context: Optional[Context] = None,
    **words: Any,
) -> ClosingPressure:
    """The pressure at which no path through the gap is left, between one that is proven to be open and one proven to be closed.

    along, sides: as in `flow`; sides=None: as the boundary repeats
    width: wanted width of the interval, over its upper end; a finer tol allows narrower ones
    Other arguments and words as in `solve`.
    """
    named, options = split_words(closing_pressure, options, words, context)
    spec, out = _spec(along, sides, width=width), rc_flow_closing()
    what = pressed(_constants.RC_CALL_HISTORY, heights, undeformed_gap, mask, system, {**named, "closing-pressure": along})
    struct, product = what.system.struct()
    step, chosen = given(rc_step(), undeformed_gap=what.gap, mask=what.mask), what.options(options)

    def call() -> int:
        with OptionSet(chosen, context) as handle:
            return int(flow_library().rc_flow_closing_pressure(struct, handle, step, spec, out))

    answer: ClosingPressure = _called(ClosingPressure, out, call, (what, product, step, spec))
    return answer

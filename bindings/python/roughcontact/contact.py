"""One system, many steps."""

import ctypes
import weakref
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any, Callable, Dict, Iterator, List, Optional, Tuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _constants
from ._arrays import Doubles, Mask, as_doubles, as_int, as_mask, pointer
from ._calls import Callbacks, check, interruptible
from ._errors import ArgumentError, InfeasibleError, Interrupted, ShapeError, Status, error_for
from ._library import contact_library
from ._maps import as_surface
from ._structs import rc_level, rc_progress_fn, rc_result, rc_state, rc_step
from .context import Context, Options, OptionSet
from .result import Grid, Level, PathResult, Result, level_from, result_from
from .system import System
from ._use import OwnsHandle, Use


@dataclass(frozen=True)
class Progress:
    """How far a step is: iterations of the solver, products with H, its own estimate of the residual, seconds since the step
    began."""

    iteration: int
    applications: int
    kkt: float
    seconds: float


def control_and_target(displacement: Any, load: Any) -> Tuple[int, Any]:
    if (displacement is None) == (load is None):
        raise ArgumentError("exactly one of displacement and load is needed")
    if load is None:
        return _constants.RC_CONTROL_DISPLACEMENT, displacement
    return _constants.RC_CONTROL_LOAD, load


def gap_and_mask(
    shape: Tuple[int, ...], heights: Any, gap: Optional[ArrayLike], mask: Optional[ArrayLike], missing: str
) -> Tuple[Optional[Doubles], Optional[Mask]]:
    """What a step presses: from heights, whose highest point touches first, or from a gap; neither: (None, mask)."""
    if heights is not None and gap is not None:
        raise ArgumentError("heights and gap are both given; give one of them")
    if heights is None:
        return None if gap is None else as_doubles(gap, "gap", shape), as_mask(mask, "mask", shape)
    surface = as_surface(heights, 1.0, mask=mask, missing=missing)  # the pitch is the system's
    if surface.shape != shape:
        raise ShapeError(f"heights have shape {surface.shape}, the grid {shape}")
    return surface.gap(), surface.mask


class Contact(OwnsHandle):
    """A contact kept over a loading sequence: operators, factors and the last pressures stay from step to step.

    system: `HalfSpace`, `Matrix` or `Product`
    options: see `roughcontact.options()`; those that are fixed cannot be changed later
    progress: called with a `Progress` at least every `every` iterations, on the thread that solves, which is not the main one.
        True ends the step with Status.STOP_CANCELLED; an exception ends it and is raised by the call
    context: a registry of its own

    A context manager; `close` frees what it holds. One thread at a time may use it (`BusyError`), `cancel` may be called by
    any.
    """

    def __init__(
        self,
        system: System,
        *,
        options: Options = None,
        progress: Optional[Callable[[Progress], object]] = None,
        every: int = 1,
        context: Optional[Context] = None,
    ) -> None:
        library = contact_library()
        interval = as_int(every, "every")
        self.system = system
        self._context = context
        self._options: Dict[str, Any] = {}
        self._borrowed: List[Any] = []  # arrays that the library may still look at
        self._mask: Optional[Mask] = None
        self._late_cancel = False
        struct, self._product = system.struct()
        self._handle = ctypes.c_void_p()
        with OptionSet(options, context) as handle:
            status = library.rc_contact_create(struct, handle, self._handle)
            if status < 0:
                self._product.raise_first()
            check(status)
        self._close = weakref.finalize(self, library.rc_contact_destroy, self._handle)
        self._close.atexit = False  # another thread might be solving then
        self._use = Use(self._close)
        self._options.update(options or {})
        self._callbacks = Callbacks()
        if progress is not None:
            self._progress = rc_progress_fn(self._callbacks.guarded(_progress_caller(progress)))
            check(library.rc_contact_on_progress(self._handle, self._progress, None, interval))

    def close(self) -> None:
        """Frees what the contact holds; it cannot be used afterwards. Again: nothing happens."""
        if not self._use.closed():
            with self._holding():
                self._use.close()

    def __enter__(self) -> "Contact":
        return self

    def __exit__(self, kind: Any, *_: object) -> None:
        if kind is None:
            self.close()
        else:
            self._use.close()  # a call that a signal handler's exceptions got out of closes it when it ends

    @contextmanager
    def _holding(self) -> Iterator[ctypes.c_void_p]:
        with self._use.by_caller():
            yield self._handle

    def grid(self) -> Grid:
        """Shape, pitch and mask of the surface that was pressed last."""
        return Grid(self.system.shape, self.system.pitch, self.system.periodic, self._mask)

    def solve(
        self,
        heights: Any = None,
        *,
        displacement: Optional[float] = None,
        load: Optional[float] = None,
        gap: Optional[ArrayLike] = None,
        mask: Optional[ArrayLike] = None,
        missing: str = "reject",
        start: Optional[ArrayLike] = None,
        warm_start: bool = True,
        borrow: bool = False,
        want_pressure: bool = True,
        want_gap: bool = False,
        check: bool = True,
    ) -> Result:
        """Solves one step and certifies the answer.

        heights: a `Surface`, a topography, or an array of the system's shape; the highest point touches at displacement 0
            [length]
        gap: the undeformed gap instead [length]. Neither: as in the previous step
        displacement: approach of the bodies [length], or load: normal force [force]
        mask: of the system's shape, 0 where a point carries no pressure; its gap may then be NaN
        missing: what masked or NaN heights are: "reject" or "exclude"
        start: pressures to begin with [force/length^2]
        warm_start: whether to begin with the last certified pressures
        borrow: gap and mask are not copied by the library; the contact keeps them, and they are to stay as they are
        want_pressure, want_gap: which arrays the result is to hold; without a gap, sparse contact on a large grid costs no more
            than the contact
        check: whether a stop before the tolerance raises `NotCertifiedError`, which has the result; otherwise look at its
            status. Status.WITHIN_GOAL never raises
        """
        control, target = control_and_target(displacement, load)
        gap_array, mask_array = gap_and_mask(self.system.shape, heights, gap, mask, missing)
        first = None if start is None else as_doubles(start, "start", self.system.shape)
        step = self._step(control, target, gap_array, mask_array)
        step.p0, step.warm_start, step.borrow = pointer(first), int(bool(warm_start)), int(bool(borrow))
        pressure = np.zeros(self.system.shape) if want_pressure else None
        deformed = np.zeros(self.system.shape) if want_gap else None
        with self._holding():
            if borrow:
                self._borrowed.append((gap_array, mask_array))
            with self._pressing(gap_array, mask_array):
                inputs = (gap_array, mask_array, first)
                answer = self._run_step(contact_library().rc_contact_solve, step, pressure, deformed, check, *inputs)
            if gap_array is not None:
                self._borrowed = self._borrowed[-1:] if borrow else []
            elif borrow:  # the gap stays that of the step which brought one; of masks, the last one is looked at
                self._borrowed = self._borrowed[:1] + self._borrowed[1:][-1:]
        return answer

    def certify(
        self,
        pressure: ArrayLike,
        heights: Any = None,
        *,
        displacement: Optional[float] = None,
        load: Optional[float] = None,
        gap: Optional[ArrayLike] = None,
        mask: Optional[ArrayLike] = None,
        missing: str = "reject",
        want_gap: bool = False,
        check: bool = True,
    ) -> Result:
        """Certifies given pressures [force/length^2] for this step; nothing is solved. Arguments as in `solve`."""
        control, target = control_and_target(displacement, load)
        gap_array, mask_array = gap_and_mask(self.system.shape, heights, gap, mask, missing)
        given = as_doubles(pressure, "pressure", self.system.shape).copy()
        deformed = np.zeros(self.system.shape) if want_gap else None
        with self._holding(), self._pressing(gap_array, mask_array):
            return self._run_step(
                contact_library().rc_contact_certify,
                self._step(control, target, gap_array, mask_array),
                given,
                deformed,
                check,
                gap_array,
                mask_array,
            )

    def _step(self, control: int, target: Any, gap: Optional[Doubles], mask: Optional[Mask]) -> rc_step:
        step = rc_step()
        contact_library().rc_step_init(step, ctypes.sizeof(step))
        step.control, step.target = control, float(target)
        step.gap, step.mask = pointer(gap), pointer(mask)
        return step

    @contextmanager
    def _pressing(self, gap: Optional[Doubles], mask: Optional[Mask]) -> Iterator[None]:
        """Follows which mask the library has: a step that it refuses changes nothing."""
        before = self._mask
        if gap is not None or mask is not None:
            self._mask = mask
        try:
            yield
        except (ArgumentError, ShapeError, InfeasibleError) as error:
            if error.result is None or error.result.completed == 0:
                self._mask = before
            raise

    def _run_step(
        self,
        function: Any,
        step: rc_step,
        pressure: Optional[Doubles],
        deformed: Optional[Doubles],
        must_be_certified: bool,
        *inputs: Any,
    ) -> Result:
        struct = rc_result()
        struct.p, struct.gap = pointer(pressure), pointer(deformed)
        keep, clears = (pressure, deformed, inputs), function is not contact_library().rc_contact_certify
        status, message, interrupt = self._run(lambda: int(function(self._handle, step, struct)), keep, clears)
        answer = result_from(struct, message, self.grid(), pressure, deformed) if status >= 0 else None
        self._conclude(status, message, interrupt, answer, must_be_certified)
        assert answer is not None
        return answer

    def _run(self, call: Callable[[], int], keep: Any, clears: bool = True) -> Tuple[int, str, Optional[BaseException]]:
        """(status, message, interrupt) of a call that this contact's `cancel` ends.

        clears: whether C then forgets that it was asked to.
        """
        asked = []

        def cancel() -> None:
            asked.append(True)
            self.cancel()

        status, message, interrupt = interruptible(call, cancel, self._use, (self, keep))
        if status == Status.STOP_CANCELLED and self._late_cancel and not asked:
            self._late_cancel = False  # it was meant for the call before, which had just ended
            return self._run(call, keep, clears)
        waits = status < 0 or not clears  # what was meant for an earlier call
        self._late_cancel = (bool(asked) or self._late_cancel and waits) and status != Status.STOP_CANCELLED
        return status, message, interrupt

    def _conclude(
        self, status: int, message: str, interrupt: Optional[BaseException], answer: Any, must_be_certified: bool
    ) -> None:
        """Raises what there is to be raised after a call."""
        for each in (self._product, self._callbacks):
            each.raise_first()
        if isinstance(interrupt, KeyboardInterrupt):
            raise Interrupted(answer) from interrupt
        if interrupt is not None:
            raise interrupt
        if status < 0 or must_be_certified and status not in (Status.OK, Status.WITHIN_GOAL):
            raise error_for(status, message, answer)

    def path(
        self,
        heights: Any = None,
        *,
        displacement: Optional[ArrayLike] = None,
        load: Optional[ArrayLike] = None,
        gap: Optional[ArrayLike] = None,
        mask: Optional[ArrayLike] = None,
        missing: str = "reject",
        warm_start: bool = True,
        stiffness: bool = False,
        keep_pressure: bool = False,
        each: Optional[Callable[[int, Result], object]] = None,
        check: bool = True,
    ) -> PathResult:
        """Solves a loading history; see `roughcontact.path`. Without heights and gap, on the surface of the last step."""
        from ._path import path_on

        gap_array, mask_array = gap_and_mask(self.system.shape, heights, gap, mask, missing)
        control, targets = control_and_target(displacement, load)
        return path_on(self, control, targets, gap_array, mask_array, warm_start, stiffness, keep_pressure, each, check)

    def levels(self) -> List[Level]:
        """Coarse solutions of the last step, the coarsest first."""
        library = contact_library()
        found: List[Level] = []
        with self._holding() as handle:
            while True:
                level = rc_level()
                if library.rc_contact_level(handle, len(found), level) < 0:
                    return found
                pressure = np.zeros((level.ny, level.nx))
                level.p = pointer(pressure)
                check(library.rc_contact_level(handle, len(found), level))
                found.append(level_from(level, pressure))

    def points(self) -> Tuple[NDArray[np.int64], Doubles]:
        """(indices, pressures) of the points in contact after the last step that was certified or within its goal, without
        arrays over
        all points: flat indices in ascending order, pressures [force/length^2]."""
        library = contact_library()
        n = ctypes.c_int64()
        with self._holding() as handle:
            check(library.rc_contact_points(handle, 0, None, None, n))
            index, pressure = np.empty(n.value, np.int64), np.empty(n.value)
            check(library.rc_contact_points(handle, n.value, pointer(index), pointer(pressure), n))
        return index, pressure

    def set_options(self, options: Options) -> None:
        """Changes options that are not fixed; the others keep the values they have."""
        together = {**self._options, **(options or {})}
        with self._holding() as handle, OptionSet(together, self._context) as changed:
            check(contact_library().rc_contact_set_options(handle, changed))
        self._options = together

    def reset(self) -> None:
        """Forgets the surface, the last pressures and factors."""
        with self._holding() as handle:
            check(contact_library().rc_contact_reset(handle))
            self._borrowed, self._mask = [], None

    def restore(
        self,
        heights: Any = None,
        *,
        last: Tuple[ArrayLike, float, float],
        before: Optional[Tuple[ArrayLike, float, float]] = None,
        gap: Optional[ArrayLike] = None,
        mask: Optional[ArrayLike] = None,
        missing: str = "reject",
    ) -> None:
        """Goes on after a certified step that this contact or another one of the same system has solved.

        heights, gap, mask, missing: its surface, as in `solve`
        last: its pressures, displacement and load, as its result has them
        before: likewise of the step before it, on the same surface; None: there was none

        With options={"resumable": 1} in both contacts the next steps give the same bits as in the other, without it to
        round-off.
        """
        gap_array, mask_array = gap_and_mask(self.system.shape, heights, gap, mask, missing)
        state = rc_state()
        contact_library().rc_state_init(state, ctypes.sizeof(state))
        state.gap, state.mask = pointer(gap_array), pointer(mask_array)
        pressure = as_doubles(last[0], "last[0]", self.system.shape)
        state.p, state.displacement, state.load = pointer(pressure), float(last[1]), float(last[2])
        earlier = None if before is None else as_doubles(before[0], "before[0]", self.system.shape)
        if before is not None:
            state.p_before, state.displacement_before, state.load_before = pointer(earlier), float(before[1]), float(before[2])
        with self._holding() as handle:
            check(contact_library().rc_contact_restore(handle, state))
            self._borrowed, self._mask = [], mask_array

    def cancel(self) -> None:
        """Stops the running step soon, or the next one if none runs. Any thread."""
        self._use.while_alive(lambda: contact_library().rc_contact_cancel(self._handle))


def _progress_caller(progress: Callable[[Progress], object]) -> Callable[[Any, Any], object]:
    def call(report: Any, _: Any) -> object:
        at = report.contents
        return progress(Progress(at.iteration, at.applications, at.kkt, at.seconds))

    return call

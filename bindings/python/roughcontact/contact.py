"""One system, many steps."""

from __future__ import annotations

import ctypes
from typing import Any, Callable, List, Optional, Tuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _constants
from ._arrays import Doubles, Mask, Reals, array_out, as_doubles, as_mask, as_reals, as_switch, given
from ._calls import check
from ._errors import ArgumentError, ShapeError
from ._creep import time_for
from ._device import DeviceArray, in_kind, device_array, in_shape, package_of
from ._derivatives import Gradient, Tangent, gradient_from, gradient_request, tangent_from, tangent_request
from ._handle import Handle
from ._history import history_on
from ._library import contact_library
from ._pressed import Prescribed, gap_in_metres, pressed, prescribed
from ._status import Status
from ._structs import rc_level, rc_result, rc_state, rc_step
from .context import Options, OptionSet
from ._history_result import HistoryResult
from .result import Level, Result, level_from, result_from
from .system import System


def gap_and_mask(
    system: System,
    heights: Any,
    undeformed_gap: Optional[ArrayLike],
    mask: Optional[ArrayLike],
    missing: str,
    single: bool = False,
    devices: bool = False,
) -> Tuple[Any, Optional[Mask]]:
    """What a step presses: from heights, whose highest point touches first, or from a gap; neither: (None, mask). devices: a gap on
    a device stays there."""
    if heights is not None and undeformed_gap is not None:
        raise ArgumentError("heights and undeformed_gap are both given; give one of them")
    if heights is None:
        undeformed_gap = gap_in_metres(undeformed_gap)
        there = device_array(undeformed_gap, "undeformed_gap") if devices else None
        if there is not None:
            return in_shape(there, "undeformed_gap", system.shape), as_mask(mask, "mask", system.shape)
        array = None if undeformed_gap is None else as_reals(undeformed_gap, "undeformed_gap", system.shape, single)
        return array, as_mask(mask, "mask", system.shape)
    what = pressed(_constants.RC_CALL_HISTORY, heights, None, mask, system, {"missing": missing})
    return what.gap.astype(np.float32) if single else what.gap, what.mask


def _on_device(step: rc_step, gap: DeviceArray, mask: Optional[Mask], first: Optional[Doubles]) -> Tuple[DeviceArray, ...]:
    """Gives the step its arrays; mask and start go to the gap's device. Returns what must be kept."""
    if gap.dtype not in ("float64", "float32"):
        raise TypeError(f"undeformed_gap holds {gap.dtype} on its device; float64 or float32 is needed")
    package_of(gap.like)  # before the step is solved in vain
    names = {"undeformed_gap": gap}
    for name, array in (("mask", mask), ("p0", first)):
        if array is not None:
            there = device_array(in_kind(array, gap.like), name)
            assert there is not None
            names[name] = there
    given(step, **names)
    return tuple(names.values())


def _in_kind(answer: Result, gap: Any) -> Result:
    """Its arrays as those of the gap's package."""
    maps = {name: getattr(answer, name) for name in ("pressure", "gap")}
    return answer._with(**{name: in_kind(array, gap) for name, array in maps.items() if array is not None})


class Contact(Handle):
    """A contact kept over a loading sequence: operators, factors and the last pressures stay from step to step.

    system: `HalfSpace`, `Matrix` or `Product`
    options: see `roughcontact.options()`; those that are fixed cannot be changed later. keywords: as in `solve`
    progress: True: a bar of the package tqdm, over the iterations of a step or the steps of a history. Or a function, called with a
        `Progress` at least every `every` iterations, on the thread that solves, which is not the main one; if it returns
        True, the step ends with Status.STOP_CANCELLED; an exception ends it and is raised by the call
    context: a registry of its own

    A context manager; `close` frees its memory. Only one thread at a time may use it (else `BusyError`); any thread may call
    `cancel`.
    """

    def solve(
        self,
        heights: Any = None,
        *,
        approach: Optional[float] = None,
        load: Optional[float] = None,
        pressure: Optional[float] = None,
        area: Optional[float] = None,
        time: Optional[float] = None,
        undeformed_gap: Optional[ArrayLike] = None,
        mask: Optional[ArrayLike] = None,
        missing: str = "reject",
        start: Optional[ArrayLike] = None,
        warm_start: Optional[bool] = None,
        borrow: bool = False,
        want_pressure: bool = True,
        want_gap: bool = False,
        single: bool = False,
        check: bool = True,
    ) -> Result:
        """Solves one step and certifies the answer.

        heights: a `Surface`, a topography, or an array of the system's shape; the highest point touches at approach 0
            [length]
        undeformed_gap: the undeformed gap instead [length]. Neither: as in the previous step. An array of CuPy, PyTorch or JAX on a
            CUDA device, float64 or float32, is read there, and the result's arrays are of the same kind on that device
        approach: approach of the bodies [length], load: normal force [force], pressure: load over the area of the grid, or area:
            contact area as a share of the grid's
        time: at the end of the step, for bodies that creep, in the unit of their times; pressures change linearly from the step before
        mask: of the system's shape, 0 where a point carries no pressure; its gap may then be NaN
        missing: rule for masked or NaN heights: "reject", "exclude" or "fill"
        start: pressures to begin with [force/length^2]
        warm_start: whether to begin with the last certified pressures; None: as the library
        borrow: gap and mask are not copied by the library; the contact keeps them, and they must not change
        want_pressure, want_gap: arrays that the result holds; the gap is expensive for sparse contact on a large grid
        single: undeformed_gap, of which float32 is not copied, and the result's arrays are float32: half the memory. With borrow
            undeformed_gap may be a numpy.memmap, of a file larger than the memory
        check: whether a stop before the tolerance raises `NotCertifiedError`, which has the result; otherwise look at its
            status. Status.WITHIN_GOAL never raises
        """
        what = prescribed(self.system, approach=approach, load=load, pressure=pressure, area=area)
        gap_array, mask_array = gap_and_mask(self.system, heights, undeformed_gap, mask, missing, single, devices=True)
        how = (start, warm_start, borrow, want_pressure, want_gap, single, check)
        return self._solve_one(what, gap_array, mask_array, *how, time=time)

    def _solve_one(
        self,
        what: Prescribed,
        gap_array: Any,
        mask_array: Optional[Mask],
        start: Optional[ArrayLike] = None,
        warm_start: Optional[bool] = None,
        borrow: bool = False,
        want_pressure: bool = True,
        want_gap: bool = False,
        single: bool = False,
        check: bool = True,
        time: Optional[float] = None,
    ) -> Result:
        """`solve`, of what is prepared."""
        first = None if start is None else as_doubles(start, "start", self.system.shape)
        there = gap_array if isinstance(gap_array, DeviceArray) else None
        single = single if there is None else there.dtype == "float32"
        step = given(rc_step(), control=what.control, target=what.target(), time=time_for(self.system, time))
        given(step, warm_start=as_switch(warm_start), borrow=as_switch(borrow))
        sent: Tuple[Any, ...] = (gap_array, mask_array, first)
        if there is not None:
            sent = _on_device(step, there, mask_array, first)
        else:
            given(step, undeformed_gap=gap_array, mask=mask_array, p0=first)
        width: Any = np.float32 if single else np.float64
        pressures = np.zeros(self.system.shape, width) if want_pressure else None
        deformed = np.zeros(self.system.shape, width) if want_gap else None
        with self._holding(), self._bar("iterations"):
            if borrow:
                self._borrowed.append(sent)
            with self._pressing(gap_array, mask_array):
                answer = self._run_step(contact_library().rc_contact_solve, step, pressures, deformed, check, *sent)
            if gap_array is not None:
                self._borrowed = self._borrowed[-1:] if borrow else []
            elif borrow:  # the gap stays that of the step which brought one; of masks, the last one is looked at
                self._borrowed = self._borrowed[:1] + self._borrowed[1:][-1:]
        return answer if there is None else _in_kind(answer, there.like)

    def certify(
        self,
        pressure: ArrayLike,
        heights: Any = None,
        *,
        approach: Optional[float] = None,
        load: Optional[float] = None,
        time: Optional[float] = None,
        undeformed_gap: Optional[ArrayLike] = None,
        mask: Optional[ArrayLike] = None,
        missing: str = "reject",
        want_gap: bool = False,
        check: bool = True,
    ) -> Result:
        """Certifies given pressures [force/length^2] for this step; nothing is solved. Arguments as in `solve`."""
        what = prescribed(self.system, approach=approach, load=load)
        gap_array, mask_array = gap_and_mask(self.system, heights, undeformed_gap, mask, missing)
        judged = as_doubles(pressure, "pressure", self.system.shape).copy()
        step = given(rc_step(), control=what.control, target=what.target(), time=time_for(self.system, time))
        given(step, undeformed_gap=gap_array, mask=mask_array)
        deformed = np.zeros(self.system.shape) if want_gap else None
        with self._holding(), self._pressing(gap_array, mask_array):
            inputs = (gap_array, mask_array)
            return self._run_step(contact_library().rc_contact_certify, step, judged, deformed, check, *inputs)

    def _run_step(
        self,
        function: Any,
        step: rc_step,
        pressure: Optional[Reals],
        deformed: Optional[Reals],
        must_be_certified: bool,
        *inputs: Any,
    ) -> Result:
        struct = given(rc_result(), p=pressure, gap=deformed)
        keep = (pressure, deformed, inputs)
        status, message, interrupt = self._run(lambda: int(function(self._handle, step, struct)), keep)
        answer = result_from(struct, message, self.grid(), pressure, deformed) if status >= 0 else None
        self._conclude(status, message, interrupt, answer, must_be_certified)
        assert answer is not None
        return answer

    def gradient(
        self, pressure: Optional[ArrayLike] = None, gap: Optional[ArrayLike] = None, *, load: float = 0.0, approach: float = 0.0
    ) -> Gradient:
        """Derivatives of a number J by all data of the last step, which must be certified. Give the derivatives of J by the answer:

        pressure, gap: dJ/dp and dJ/dg for pressures and deformed gap, of the system's shape; None: 0
        load, approach: dJ/dload and dJ/dapproach

        Without them, J is the load if the approach was given, and the approach if the load was given.
        """
        struct, out, inputs = gradient_request(self.system.shape, pressure, gap, load, approach)
        self._differentiate(contact_library().rc_contact_gradient, struct, out, inputs)
        return gradient_from(struct, out)

    def tangent(self, undeformed_gap: Optional[ArrayLike] = None, *, target: float = 0.0, modulus: float = 0.0) -> Tangent:
        """Change of the answer of the last step, which must be certified, for given changes of its data.

        undeformed_gap: change of the undeformed gap, of the system's shape [length]; None: 0
        target: change of approach [length] or load [force]; modulus: of E* [force/length^2]
        """
        struct, out, inputs = tangent_request(self.system.shape, undeformed_gap, target, modulus)
        self._differentiate(contact_library().rc_contact_tangent, struct, out, inputs)
        return tangent_from(struct, out)

    def _differentiate(self, function: Any, struct: Any, *keep: Any) -> None:
        """A stop raises, but for round-off that keeps a larger residual: the answer's `error` tells of it."""
        with self._holding():
            status, message, interrupt = self._run(lambda: int(function(self._handle, struct)), (struct, keep))
            self._conclude(status, message, interrupt, None, status != Status.STOP_STALLED)

    def history(
        self,
        heights: Any = None,
        *,
        approach: Optional[ArrayLike] = None,
        load: Optional[ArrayLike] = None,
        pressure: Optional[ArrayLike] = None,
        area: Optional[ArrayLike] = None,
        time: Optional[ArrayLike] = None,
        undeformed_gap: Optional[ArrayLike] = None,
        mask: Optional[ArrayLike] = None,
        missing: str = "reject",
        warm_start: Optional[bool] = None,
        virgin: Optional[bool] = None,
        stiffness: bool = False,
        keep_pressure: bool = False,
        want_gap: bool = False,
        each: Optional[Callable[[int, Result], object]] = None,
        check: bool = True,
    ) -> HistoryResult:
        """Solves a loading history; see `roughcontact.history`. Without either, on the surface of the last step."""
        gap_array, mask_array = gap_and_mask(self.system, heights, undeformed_gap, mask, missing)
        what = prescribed(self.system, approach=approach, load=load, pressure=pressure, area=area)
        return history_on(
            self, what, gap_array, mask_array, warm_start, virgin, stiffness, keep_pressure, want_gap, each, check, time
        )

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
                given(level, p=pressure)
                check(library.rc_contact_level(handle, len(found), level))
                found.append(level_from(level, pressure))

    def points(self) -> Tuple[NDArray[np.int64], Doubles]:
        """(indices, pressures) of the points in contact after the last step that was certified or within its goal, without arrays
        over all points: flat indices in ascending order, pressures [force/length^2]. Inside `history(each=)`: of its step."""
        library = contact_library()
        n = ctypes.c_int64()
        with self._holding_or_inside() as handle:
            check(library.rc_contact_points(handle, 0, array_out(None), array_out(None), n))
            index, pressure = np.empty(n.value, np.int64), np.empty(n.value)
            check(library.rc_contact_points(handle, n.value, array_out(index), array_out(pressure), n))
        return index, pressure

    def indentation(self) -> Doubles:
        """The plastic indentation of all steps so far, at points whose pressure was the system's hardness [length].

        The next step adds it to its undeformed gap, also to one that is given anew; `reset` forgets it.
        """
        left = np.zeros(self.system.shape)
        with self._holding() as handle:
            check(contact_library().rc_contact_indentation(handle, array_out(left)))
        return left

    def creep(self) -> Tuple[Doubles, Optional[float]]:
        """(deflections, time) that certified steps have left in bodies that creep: [terms + 1, *shape], first the elastic one of the
        last step, then of each term the delayed one, without its ratio [length]; and that step's time, None before the first.
        """
        terms = self.system.creep if self.system.relaxation is None else self.system.relaxation
        left, time = np.zeros((1 + len(terms or ()), *self.system.shape)), ctypes.c_double()
        with self._holding() as handle:
            check(contact_library().rc_contact_creep(handle, array_out(left), time))
        return left, None if np.isnan(time.value) else time.value

    def explain(self) -> str:
        """The reasons for the choice of "auto" in the last step on the given grid: a line for each solver and backend."""
        text = ctypes.c_char_p()
        with self._holding() as handle:
            check(contact_library().rc_contact_explain(handle, text))
            return (text.value or b"").decode()

    def set_options(self, options: Options) -> None:
        """Changes options that are not fixed; the others keep the values they have."""
        together = {**self._options, **(options or {})}
        with self._holding() as handle, OptionSet(together, self._context) as changed:
            check(contact_library().rc_contact_set_options(handle, changed))
        self._options = together

    def reset(self) -> None:
        """Forgets the surface, its plastic indentation, creep, the last pressures and factors."""
        with self._holding() as handle:
            check(contact_library().rc_contact_reset(handle))
            self._borrowed, self._mask = [], None

    def restore(
        self,
        heights: Any = None,
        *,
        last: Tuple[ArrayLike, float, float],
        before: Optional[Tuple[ArrayLike, float, float]] = None,
        indentation: Optional[ArrayLike] = None,
        creep: Optional[Tuple[ArrayLike, Optional[float]]] = None,
        undeformed_gap: Optional[ArrayLike] = None,
        mask: Optional[ArrayLike] = None,
        missing: str = "reject",
    ) -> None:
        """Continues after a certified step that this contact or another one of the same system has solved.

        heights, undeformed_gap, mask, missing: its surface, as in `solve`
        last: its pressures, approach and load, as its result has them
        before: the same of the step before it, on the same surface; None: there was none
        indentation: the result of `indentation` after its last step [length]; None: none
        creep: the result of `creep` after its last step, needed for bodies that creep

        With options={"resumable": 1} in both contacts the next steps give the same bits as in the other contact, otherwise they
        agree to round-off.
        """
        gap_array, mask_array = gap_and_mask(self.system, heights, undeformed_gap, mask, missing)
        pressure = as_doubles(last[0], "last[0]", self.system.shape)
        state = given(rc_state(), p=pressure, approach=float(last[1]), load=float(last[2]))
        given(state, undeformed_gap=gap_array, mask=mask_array)
        if before is not None:
            earlier = as_doubles(before[0], "before[0]", self.system.shape)
            given(state, p_before=earlier, approach_before=float(before[1]), load_before=float(before[2]))
        if indentation is not None:
            given(state, indentation=as_doubles(indentation, "indentation", self.system.shape))
        if creep is not None:
            terms = self.system.creep if self.system.relaxation is None else self.system.relaxation
            shape = (1 + len(terms or ()), *self.system.shape)
            left, time = as_doubles(creep[0], "creep[0]"), creep[1]
            if left.shape != shape:
                raise ShapeError(f"creep[0] has shape {left.shape}; {shape} is needed")
            given(state, creep=left, time=np.nan if time is None else float(time))
        with self._holding() as handle:
            check(contact_library().rc_contact_restore(handle, state))
            self._borrowed, self._mask = [], mask_array

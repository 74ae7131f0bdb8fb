"""Loading histories of a contact that exists."""

from __future__ import annotations

from typing import Any, Callable, List, Optional

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import Doubles, Mask, as_switch, doubles_at, given
from ._calls import Callbacks
from ._creep import times_for
from ._errors import ArgumentError, as_status
from ._handle import Handle
from ._pressed import Prescribed
from ._library import contact_library
from ._structs import rc_history, rc_history_fn
from ._measures import measures_of
from ._history_result import HistoryResult
from .result import Result, result_from, result_with_copies


def history_on(
    contact: Handle,
    what: Prescribed,
    undeformed_gap: Optional[Doubles],
    mask: Optional[Mask],
    warm_start: Optional[bool],
    virgin: Optional[bool],
    stiffness: bool,
    keep_pressure: bool,
    want_gap: bool,
    each: Optional[Callable[[int, Result], object]],
    check: bool,
    time: Optional[ArrayLike] = None,
) -> HistoryResult:
    """`history` on a contact that exists."""
    values = np.atleast_1d(what.given)
    if values.ndim != 1:
        raise ArgumentError(f"{what.name} has {values.ndim} axes: one value for each step is needed")
    n = len(values)
    if n == 0:
        raise ArgumentError(f"{what.name} is empty: one value for each step is needed")
    times = times_for(contact.system, time, (n,))
    targets, tangents = np.atleast_1d(what.targets), np.empty(n) if stiffness else None
    pressures = np.zeros((n, *contact.system.shape)) if keep_pressure else None
    results: List[Result] = []

    struct = given(rc_history(), control=what.control, warm_start=as_switch(warm_start), n=n, targets=targets, times=times)
    given(struct, undeformed_gap=undeformed_gap, mask=mask, virgin=as_switch(virgin))
    given(struct.columns, stiffness=tangents)
    given(struct, want_gap=int(want_gap or each is not None))

    def after(step: int, answer: Any, _: Any) -> object:
        found, grid = answer.contents, contact.grid()
        pressure = doubles_at(found.p, grid.shape)
        if pressures is not None:
            pressures[step] = pressure
        alone = result_from(found, "", grid, None, None)
        results.append(alone._with(measures=measures_of(pressure, grid)))
        if each is None:
            return False
        with contact._use.answering():
            return each(step, result_with_copies(found, grid))

    callbacks = Callbacks()
    struct.fn = rc_history_fn(callbacks.guarded(after))
    keep = (targets, times, undeformed_gap, mask, tangents, callbacks)
    bar = contact._bar("steps", n, lambda: int(struct.completed))
    with contact._holding() as handle, contact._pressing(undeformed_gap, mask), bar:
        status, message, interrupt = contact._run(lambda: int(contact_library().rc_contact_solve_history(handle, struct)), keep)
        done = struct.completed
        answer = HistoryResult(
            status=as_status(status),
            message=message,
            prescribed=what.name,
            targets=values,
            results=tuple(results[:done]),
            pressure=None if pressures is None else pressures[:done],
            grid=contact.grid(),
            time=None if times is None else times[:done],
        )
        callbacks.raise_first()
        contact._conclude(status, message, interrupt, answer, check)
        return answer

"""Loading histories of a contact that exists."""

from typing import Any, Callable, Optional

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import Doubles, Mask, as_doubles, as_switch, given
from ._calls import Callbacks
from ._errors import ArgumentError, as_status
from ._handle import Handle
from ._library import contact_library
from ._structs import rc_history, rc_history_fn
from .result import HistoryResult, Result, result_with_copies


def history_on(
    contact: Handle,
    control: int,
    values: ArrayLike,
    undeformed_gap: Optional[Doubles],
    mask: Optional[Mask],
    warm_start: Optional[bool],
    stiffness: bool,
    keep_pressure: bool,
    each: Optional[Callable[[int, Result], object]],
    check: bool,
) -> HistoryResult:
    """`history` on a contact that exists."""
    targets = np.atleast_1d(as_doubles(values, "the history"))
    if targets.ndim != 1:
        raise ArgumentError(f"the history has {targets.ndim} axes: one value for each step is needed")
    n = len(targets)
    out = {name: np.full(n, np.nan) for name in ("load", "approach", "contact_area", "certificate")}
    products, tangents = np.full(n, -1), np.full(n, np.nan) if stiffness else None
    pressures = np.zeros((n, *contact.system.shape)) if keep_pressure else None

    struct = given(rc_history(), control=control, warm_start=as_switch(warm_start), n=n, targets=targets, **out)
    given(struct, undeformed_gap=undeformed_gap, mask=mask, products=products, stiffness=tangents)

    def after(step: int, answer: Any, _: Any) -> object:
        found = result_with_copies(answer.contents, contact.grid(), contact._handle)
        if pressures is not None:
            pressures[step] = found.pressure
        return each is not None and each(step, found)

    callbacks = Callbacks()
    if pressures is not None or each is not None:
        struct.fn = rc_history_fn(callbacks.guarded(after))
    keep = (targets, undeformed_gap, mask, out, products, tangents, callbacks)
    bar = contact._bar("steps", n, lambda: int(struct.completed))
    with contact._holding() as handle, contact._pressing(undeformed_gap, mask), bar:
        status, message, interrupt = contact._run(
            lambda: int(contact_library().rc_contact_solve_history(handle, struct)), keep, n > 0
        )
        done = struct.completed
        answer = HistoryResult(
            status=as_status(status),
            message=message,
            targets=targets,
            products=products[:done],
            stiffness=None if tangents is None else tangents[:done],
            pressure=None if pressures is None else pressures[:done],
            grid=contact.grid(),
            **{name: array[:done] for name, array in out.items()},
        )
        callbacks.raise_first()
        contact._conclude(status, message, interrupt, answer, check)
        return answer

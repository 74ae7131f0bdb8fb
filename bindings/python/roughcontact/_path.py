"""Loading histories."""

import ctypes
from typing import Any, Callable, Optional

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import Doubles, Mask, Pitch, as_doubles, pointer
from ._calls import Callbacks
from ._errors import ArgumentError, as_status
from ._library import contact_library
from ._structs import rc_path, rc_path_fn
from .contact import Contact, Progress, control_and_target
from .context import Context, Options
from .result import PathResult, Result, result_with_copies
from ._solve import system_for
from .system import System


def path(
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
    system: Optional[System] = None,
    pitch: Optional[Pitch] = None,
    modulus: Optional[float] = None,
    boundary: Optional[str] = None,
    unit: Optional[str] = None,
    options: Options = None,
    progress: Optional[Callable[[Progress], object]] = None,
    every: int = 1,
    context: Optional[Context] = None,
) -> PathResult:
    """Solves the steps of a loading history in order, each from the pressures of the one before.

    displacement or load: one value for each step, in any order [length] or [force]
    stiffness: whether to compute dW/dd
    keep_pressure: whether to keep the pressures of all steps
    each: called with (step, `Result`) after every step, on the thread that solves. True ends the path with
        Status.STOP_CANCELLED; an exception ends it and is raised
    check: whether a step that is not certified raises `NotCertifiedError`. That, every other `RoughContactError` and
        `Interrupted` (Ctrl-C) have the steps that were completed as their `result`
    the others: as in `solve`
    """
    system, gap, mask = system_for(heights, gap, mask, missing, system, pitch, modulus, boundary, unit)
    with Contact(system, options=options, progress=progress, every=every, context=context) as contact:
        control, targets = control_and_target(displacement, load)
        return path_on(contact, control, targets, gap, mask, warm_start, stiffness, keep_pressure, each, check)


def path_on(
    contact: Contact,
    control: int,
    values: ArrayLike,
    gap: Optional[Doubles],
    mask: Optional[Mask],
    warm_start: bool,
    stiffness: bool,
    keep_pressure: bool,
    each: Optional[Callable[[int, Result], object]],
    check: bool,
) -> PathResult:
    """`path` on a contact that exists."""
    targets = np.atleast_1d(as_doubles(values, "the history"))
    if targets.ndim != 1:
        raise ArgumentError(f"the history has {targets.ndim} axes: one value for each step is needed")
    n = len(targets)
    out = {name: np.full(n, np.nan) for name in ("load", "displacement", "contact_area", "certificate")}
    applications, tangents = np.full(n, -1), np.full(n, np.nan) if stiffness else None
    pressures = np.zeros((n, *contact.system.shape)) if keep_pressure else None

    struct = rc_path()
    contact_library().rc_path_init(struct, ctypes.sizeof(struct))
    struct.control, struct.warm_start, struct.n, struct.targets = control, int(bool(warm_start)), n, pointer(targets)
    struct.gap, struct.mask = pointer(gap), pointer(mask)
    for name, array in out.items():
        setattr(struct, name, pointer(array))
    struct.applications, struct.stiffness = pointer(applications), pointer(tangents)

    def after(step: int, answer: Any, _: Any) -> object:
        found = result_with_copies(answer.contents, contact.grid())
        if pressures is not None:
            pressures[step] = found.pressure
        return each is not None and each(step, found)

    callbacks = Callbacks()
    if pressures is not None or each is not None:
        struct.fn = rc_path_fn(callbacks.guarded(after))
    keep = (targets, gap, mask, out, applications, tangents, callbacks)
    with contact._holding() as handle, contact._pressing(gap, mask):
        status, message, interrupt = contact._run(
            lambda: int(contact_library().rc_contact_solve_path(handle, struct)), keep, n > 0
        )
        done = struct.completed
        answer = PathResult(
            as_status(status),
            message,
            targets,
            out["load"][:done],
            out["displacement"][:done],
            out["contact_area"][:done],
            out["certificate"][:done],
            applications[:done],
            None if tangents is None else tangents[:done],
            None if pressures is None else pressures[:done],
            contact.grid(),
        )
        callbacks.raise_first()
        contact._conclude(status, message, interrupt, answer, check)
        return answer

"""A loading history in one call."""

from typing import Any, Callable, Optional

from numpy.typing import ArrayLike

from ._arrays import Pitch
from ._handle import Progress
from ._history import path_on
from ._solve import system_for
from .contact import Contact, control_and_target
from .context import Context, Options
from .result import PathResult, Result
from .system import System


def path(
    heights: Any = None,
    *,
    displacement: Optional[ArrayLike] = None,
    load: Optional[ArrayLike] = None,
    undeformed_gap: Optional[ArrayLike] = None,
    mask: Optional[ArrayLike] = None,
    missing: str = "reject",
    warm_start: Optional[bool] = None,
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
    system, undeformed_gap, mask = system_for(heights, undeformed_gap, mask, missing, system, pitch, modulus, boundary, unit)
    with Contact(system, options=options, progress=progress, every=every, context=context) as contact:
        control, targets = control_and_target(displacement, load)
        return path_on(contact, control, targets, undeformed_gap, mask, warm_start, stiffness, keep_pressure, each, check)

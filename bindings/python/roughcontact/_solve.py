"""One contact in one call, a step or a history."""

from __future__ import annotations

from typing import Any, Callable, Optional, Union

from numpy.typing import ArrayLike

from . import _constants
from ._calls import short_traceback
from ._creep import Series, series_words
from ._handle import Watch
from ._history import history_on
from ._history_result import HistoryResult
from ._keywords import documented, split_words
from ._pressed import pressed
from .contact import Contact
from .context import Context, Options
from .result import Result
from .system import System


@documented
@short_traceback
def solve(
    heights: Any = None,
    *,
    undeformed_gap: Optional[ArrayLike] = None,
    mask: Optional[ArrayLike] = None,
    start: Optional[ArrayLike] = None,
    want_pressure: bool = True,
    want_gap: bool = False,
    check: bool = True,
    system: Optional[System] = None,
    options: Options = None,
    progress: Watch = None,
    every: int = 1,
    context: Optional[Context] = None,
    **words: Any,
) -> Result:
    """Presses a surface into an elastic half-space.

    heights: a `Surface`, a file (see `read`), a topography of SurfaceTopography, or an array [ny, nx]; the highest point
        touches at approach 0 [length]
    undeformed_gap: the undeformed gap [ny, nx] instead of heights [length]; also an array on a device, see `Contact.solve`
    mask: [ny, nx], 0 at points that carry no pressure and whose heights are ignored. None: all points may carry pressure
    start: pressures [ny, nx] to begin with [force/length^2]; None: the solver's
    want_pressure: whether the result holds the pressures [ny, nx]
    want_gap: whether it holds the deformed gap [ny, nx], which is expensive for sparse contact on a large grid
    check: whether a stop before the tolerance raises `NotCertifiedError`, which has the result; otherwise look at its status.
        Status.WITHIN_GOAL never raises
    system: replaces pitch, modulus, boundary, unit and hardness: a `HalfSpace`, `Matrix` or `Product`
    options: {"tol": 1e-6, "fft.precision": "single"} and the like, see `roughcontact.options()`; the same as keywords, with _ for
        dots and hyphens: tol=1e-6, fft_precision="single"
    progress: True: a bar of the package tqdm. Or a function, called with a `Progress` at least every `every` iterations on the thread
        that solves; if it returns True, the step ends with Status.STOP_CANCELLED
    every: iterations between two calls of progress
    context: a registry of backends, solvers and kernels of its own; None: the default one

    Words, as numbers in any consistent set of units, or as texts with units, which are then those of m, Pa and N: pressure="1MPa",
    pitch="39nm". Without a boundary and a surface that has one, periodic is taken with an `AssumedBoundary` warning; metres that
    are taken for lengths without a unit with an `AssumedUnit` warning. E and nu are numbers or pairs, of both bodies:
    """
    given, options = split_words(solve, options, words, context)
    what = pressed(_constants.RC_CALL_SOLVE, heights, undeformed_gap, mask, system, given)
    with Contact(what.system, options=what.options(options), progress=progress, every=every, context=context) as contact:
        result = contact._solve_one(
            what.needed(),
            what.gap,
            what.mask,
            start=start,
            borrow=True,
            want_pressure=want_pressure,
            want_gap=want_gap,
            check=check,
        )
    answer: Result = what.remarked(result)
    return answer


@short_traceback
def history(
    heights: Any = None,
    *,
    undeformed_gap: Optional[ArrayLike] = None,
    mask: Optional[ArrayLike] = None,
    warm_start: Optional[bool] = None,
    virgin: Optional[bool] = None,
    stiffness: bool = False,
    keep_pressure: bool = False,
    want_gap: bool = False,
    each: Optional[Callable[[int, Result], object]] = None,
    check: bool = True,
    time: Optional[Union[str, ArrayLike]] = None,
    creep: Optional[Series] = None,
    relaxation: Optional[Series] = None,
    steps: Optional[str] = None,
    system: Optional[System] = None,
    options: Options = None,
    progress: Watch = None,
    every: int = 1,
    context: Optional[Context] = None,
    **words: Any,
) -> HistoryResult:
    """Solves the steps of a loading history in order, each from the pressures of the one before.

    approach, load or pressure: one value for each step, in any order; also "1MPa..100MPa:20log", a range of 20 with equal ratios
    virgin: whether every step presses the surface without the plastic indentation and creep of the steps before it
    stiffness: whether to compute dW/dd
    keep_pressure: whether to keep the pressures of all steps
    want_gap: whether each step computes its deformed gap, for the mean gap of sparse contact; with `each` it does
    each: called with (step, `Result`) after every step, on the thread that solves. True ends the history with
        Status.STOP_CANCELLED; an exception ends it and is raised
    check: whether a step that is not certified raises `NotCertifiedError`. That, every other `RoughContactError` and
        `Interrupted` (Ctrl-C) have the steps that were completed as their `result`
    time: of each step, if the bodies creep, in the unit of their times or as a text, "0..1h:20": pressures change linearly from step
        to step, two steps at the same time are a jump, and before the first step the bodies are at rest. A single target is kept
        at all times
    steps: a file of steps instead: a line for each, below the names of its columns, such as time and load
    creep: pairs (ratio, time) of the compliance, (1 + sum of ratio (1 - exp(-t/time))) times that at once, which E or modulus gives
    relaxation: the same bodies by their modulus, (1 - sum of ratio (1 - exp(-t/time))) times that at once. Both also as texts,
        "0.3:1s,0.2:1min"
    the others, and the words: as in `solve`
    """
    given, options = split_words(history, options, words, context)
    given.update(series_words(creep=creep, relaxation=relaxation), steps=steps, time=time)
    what = pressed(_constants.RC_CALL_HISTORY, heights, undeformed_gap, mask, system, given)
    with Contact(what.system, options=what.options(options), progress=progress, every=every, context=context) as contact:
        answer = history_on(
            contact,
            what.needed(),
            what.gap,
            what.mask,
            warm_start,
            virgin,
            stiffness,
            keep_pressure,
            want_gap,
            each,
            check,
            what.request.times,
        )
    return answer._with(results=tuple(what.remarked(result) for result in answer.results))

"""Many contacts in one call."""

from __future__ import annotations

from contextlib import nullcontext
from dataclasses import replace
from typing import Any, Callable, Dict, Optional, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _constants
from ._arrays import as_doubles, as_mask, as_switch, given
from ._calls import Callbacks, conclude, interruptible, short_traceback
from ._creep import Series, series_words, times_for
from ._data_arrays import in_order
from ._errors import ArgumentError, ShapeError, as_status
from ._library import contact_library
from ._files import is_file
from ._height_map import Stack, same_pitch
from ._keywords import split_words
from ._request import as_surface
from ._progress import Bars
from ._pressed import pressed
from ._status import Status
from ._structs import rc_batch, rc_batch_fn, rc_batch_progress_fn
from ._threads import with_threads
from .context import Context, Options, OptionSet
from .result import BatchResult, Grid, Result, result_with_copies
from .system import System


@short_traceback
def batch(
    heights: Any = None,
    *,
    undeformed_gap: Optional[ArrayLike] = None,
    mask: Optional[ArrayLike] = None,
    start: Optional[ArrayLike] = None,
    warm_start: Optional[bool] = None,
    virgin: Optional[bool] = None,
    stiffness: bool = False,
    mean_gap: bool = False,
    energy: bool = False,
    intervals: bool = False,
    keep_pressure: bool = False,
    each: Optional[Callable[[int, int, Result], object]] = None,
    check: bool = True,
    time: Optional[Union[str, ArrayLike]] = None,
    creep: Optional[Series] = None,
    relaxation: Optional[Series] = None,
    steps: Optional[str] = None,
    system: Optional[System] = None,
    options: Options = None,
    progress: bool = False,
    context: Optional[Context] = None,
    **words: Any,
) -> BatchResult:
    """Solves the histories of many contacts on one grid, each as by `history`: the same bits, whatever the number of threads.

    heights or undeformed_gap: [contacts, ny, nx], a sequence of `Surface`, or one [ny, nx] for all of them; of heights
        each surface's highest point touches at approach 0 [length]
    approach, load or pressure: [contacts, steps], or one history [steps] for all of them, or one number
    mask: [contacts, ny, nx] or [ny, nx], 0 where a point carries no pressure
    start: [contacts, ny, nx] pressures to begin with [force/length^2]
    virgin: as in `history`
    stiffness, mean_gap, energy: whether to compute them
    intervals: whether to prove intervals of load, contact area and, with stiffness, of the stiffness
    keep_pressure: whether to keep the pressures of every contact's last step
    each: called with (contact, step, `Result`) after every step; with option threads > 1 by several threads at the same time.
        True ends the batch with Status.STOP_CANCELLED; an exception ends it and is raised
    check: whether a contact that fails or is not certified raises, when all others are done. Every exception of this call that
        comes after its start, `Interrupted` (Ctrl-C, at the end of a running step) included, has all answers as its `result`
    progress: whether a bar of the package tqdm shows how many steps are solved
    options: {"threads": 4} for four contacts at the same time, otherwise as many as there are cores, with `each` one;
        {"time_limit": 60} for seconds of the whole batch
    time: [contacts, steps] or [steps]; creep, relaxation, steps: as in `history`
    the others, and the words: as in `solve`
    """
    given_words, options = split_words(batch, options, words, context)
    given_words.update(series_words(creep=creep, relaxation=relaxation), steps=steps, time=time if isinstance(time, str) else None)
    leading = 0
    if heights is not None:
        if mask is not None and _is_sequence_of_surfaces(heights):
            raise ArgumentError("mask and a sequence of surfaces are both given; surfaces bring their masks")
        heights, leading = _stacked(heights, given_words, system)
    elif undeformed_gap is not None:
        leading = int(np.ndim(undeformed_gap) > (2 if system is None else len(system.shape)))
    axes = 2 if system is None else len(system.shape)
    of_one_surface = leading == 0 and mask is not None and np.ndim(mask) > axes  # each contact has a mask, all the same surface
    problem = pressed(
        _constants.RC_CALL_BATCH, heights, undeformed_gap, None if of_one_surface else mask, system, given_words, leading
    )
    system, gaps, masks, what = problem.system, problem.gap, problem.mask, problem.needed()
    if of_one_surface:
        masks = as_mask(mask, "mask")
    elif leading and masks is not None and mask is not None and np.ndim(mask) == axes and problem.request.view.missing == 0:
        masks = masks[0]
    targets = np.atleast_1d(what.targets)
    if targets.ndim > 2:
        raise ShapeError(f"{what.name} has {targets.ndim} axes: [contacts, steps], [steps] or one number")
    if targets.shape[-1] == 0:
        raise ArgumentError(f"{what.name} is empty: one value for each step is needed")
    times = problem.request.times if time is None or isinstance(time, str) else as_doubles(time, "time")
    if times is not None and times.ndim == 2 and targets.ndim == 1:  # every contact has times of its own
        targets = np.broadcast_to(targets, (len(times), len(targets))).copy()
    times = times_for(system, times, targets.shape)
    axes = len(system.shape)
    starts = None if start is None else as_doubles(start, "start")
    counts = {
        name: len(array)
        for name, array, shared in (
            ("heights or undeformed_gap", gaps, gaps.ndim == axes),
            ("histories", targets, targets.ndim == 1),
            ("mask", masks, masks is None or masks.ndim == axes),
            ("start", starts, starts is None),
        )
        if not shared and array is not None
    }
    if len(set(counts.values())) > 1:
        raise ShapeError(f"numbers of contacts differ: {', '.join(f'{name} {n}' for name, n in counts.items())}")
    n, length = max(counts.values(), default=1), targets.shape[-1]
    if starts is not None and starts.shape != (n, *system.shape):
        raise ShapeError(f"start has shape {starts.shape}; {(n, *system.shape)} is needed")

    asked = {"stiffness": stiffness, "mean_gap": mean_gap, "energy": energy}
    for name in ("load", "area", "stiffness"):
        asked[f"{name}_lower"] = asked[f"{name}_upper"] = intervals and (stiffness or name != "stiffness")
    always = ("load", "approach", "contact_area", "certificate")
    out = {name: np.full((n, length), np.nan) for name in (*always, *(name for name, wanted in asked.items() if wanted))}
    whole = {name: np.full((n, length), -1, np.int64) for name in ("iterations", "products")}
    statuses = np.full((n, length), int(Status.STOP_CANCELLED), np.int32)
    pressures = np.zeros((n, *system.shape)) if keep_pressure else None

    struct = given(
        rc_batch(), control=what.control, warm_start=as_switch(warm_start), virgin=as_switch(virgin), n=n, steps=length
    )
    given(struct, targets=targets, times=times, undeformed_gap=gaps, mask=masks, p0=starts, p=pressures)
    given(struct.columns, status=statuses, **out, **whole)
    for name, array, most in (("target", targets, 2), ("undeformed_gap", gaps, axes + 1), ("mask", masks, axes + 1)):
        setattr(struct, f"{name}_stride", _constants.RC_BATCH_SHARED if array is not None and array.ndim < most else 0)

    shared = masks if masks is not None and masks.ndim == axes else None
    grid = Grid(system.shape, system.pitch, system.periodic, shared, system.modulus, system.hardness)

    bars = Bars()

    def after(contact: int, step: int, answer: Any, _: Any) -> object:
        assert each is not None
        own = grid if masks is None or shared is not None else replace(grid, mask=masks[contact])
        return each(contact, step, result_with_copies(answer.contents, own))

    def so_far(ended: int, _: Any) -> object:
        bars.show(ended)
        return False

    callbacks = Callbacks()
    struct.progress = rc_batch_progress_fn(callbacks.guarded(so_far))
    if each is not None:
        struct.fn = rc_batch_fn(callbacks.guarded(after))
    description, product = system.struct()
    options = problem.options(options)
    chosen = dict(options or {}) if each is not None else with_threads(options, system, n)

    def call() -> int:
        with OptionSet(chosen, context) as handle:
            return int(contact_library().rc_batch_solve(description, handle, struct))

    keep = (system, product, callbacks, targets, times, gaps, masks, starts, out, whole, statuses, pressures)
    with bars.over("steps", n * length) if progress else nullcontext():
        status, message, interrupt = interruptible(call, keep=keep)
    answer = None
    if struct.written == n:
        ends: Dict[str, Any] = {
            "certified": struct.certified,
            "first": struct.first,
            "grid": grid,
            "assumed": problem.request.assumed(),
        }
        arrays: Dict[str, Any] = {**dict.fromkeys(asked), **out, **whole, "pressure": pressures}
        answer = BatchResult(status=as_status(status), message=message, statuses=statuses, **arrays, **ends)
    accepted = answer is not None and n > 0 and not check
    conclude(Status.OK if accepted else status, message, interrupt, answer, check, product, callbacks)
    assert answer is not None
    return answer


def _stacked(heights: Any, words: Dict[str, Any], system: Optional[System]) -> Tuple[Any, int]:
    """(what is pressed, its axes that count surfaces): a sequence of surfaces becomes one stack in metres, or in their unit."""
    if not _is_sequence_of_surfaces(heights):
        alone = not isinstance(heights, (np.ndarray, list, tuple))
        axes = 0 if alone else np.ndim(in_order(heights))
        return heights, 0 if alone or axes == (2 if system is None else len(system.shape)) else 1
    otherwise = words.get("pitch") if system is None else system.pitch
    pitch, unit = (words.pop(name, None) for name in ("pitch", "unit"))
    each = [as_surface(one, pitch, unit=unit, otherwise=otherwise) for one in heights]
    first = each[0]
    if any(one.shape != first.shape or not same_pitch(one.pitch, first.pitch) for one in each):
        raise ShapeError("the surfaces differ in shape or pitch; a batch has one grid")
    if words.get("boundary") is None and system is None and any(one.periodic != first.periodic for one in each):
        raise ArgumentError("the surfaces differ in whether they repeat; give boundary='free' or 'periodic'")
    heights = np.stack([np.where(one.missing, np.nan, one.heights) for one in each])
    return Stack(heights, first.pitch, first.periodic, None, first.unit), 1


def _is_sequence_of_surfaces(thing: Any) -> bool:
    return isinstance(thing, (list, tuple)) and len(thing) > 0 and (hasattr(thing[0], "heights") or is_file(thing[0]))

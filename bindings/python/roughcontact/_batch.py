"""Many contacts in one call."""

from __future__ import annotations

from contextlib import nullcontext
from dataclasses import replace
from typing import Any, Callable, Dict, List, Optional, Tuple

import numpy as np
from numpy.typing import ArrayLike

from . import _constants
from ._arrays import Doubles, Mask, Pitch, as_doubles, as_mask, as_switch, given, refuse_one_row
from ._calls import Callbacks, conclude, interruptible, short_traceback
from ._elastic import Constant, modulus_of, needed_modulus
from ._data_arrays import in_order
from ._errors import ArgumentError, ShapeError, as_status
from ._library import contact_library
from ._files import is_file
from ._height_map import gap_below, same_pitch
from ._keywords import in_metres, options_of, prescribed, refuse_two_sources
from ._maps import as_surface, gap_and_pitch, gap_in_metres
from ._progress import Bars
from ._status import Status
from ._structs import rc_batch, rc_batch_fn, rc_batch_progress_fn
from ._threads import with_threads
from .contact import refuse_another_pitch
from .context import Context, Options, OptionSet
from .result import BatchResult, Grid, Result, result_with_copies
from .system import HalfSpace, System, boundary_of


@short_traceback
def batch(
    heights: Any = None,
    *,
    approach: Optional[ArrayLike] = None,
    load: Optional[ArrayLike] = None,
    pressure: Optional[ArrayLike] = None,
    area: Optional[ArrayLike] = None,
    undeformed_gap: Optional[ArrayLike] = None,
    mask: Optional[ArrayLike] = None,
    missing: str = "reject",
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
    system: Optional[System] = None,
    pitch: Optional[Pitch] = None,
    modulus: Optional[float] = None,
    E: Optional[Constant] = None,
    nu: Optional[Constant] = None,
    boundary: Optional[str] = None,
    unit: Optional[str] = None,
    hardness: Optional[float] = None,
    options: Options = None,
    progress: bool = False,
    context: Optional[Context] = None,
    **keywords: Any,
) -> BatchResult:
    """Solves the histories of many contacts on one grid, each as by `history`: the same bits, whatever the number of threads.

    heights or undeformed_gap: [contacts, ny, nx], a sequence of `Surface`, or one [ny, nx] for all of them; of heights
        each surface's highest point touches at approach 0 [length]
    approach, load, pressure or area: [contacts, steps], or one history [steps] for all of them, or one number
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
    the others: as in `solve`
    """
    modulus, options = modulus_of(modulus, E, nu), options_of(batch, options, keywords, context)
    system, gaps, masks = _surfaces(heights, undeformed_gap, mask, missing, system, pitch, modulus, boundary, unit, hardness)
    what = prescribed(system, approach=in_metres(approach, unit), load=load, pressure=pressure, area=area)
    targets = np.atleast_1d(as_doubles(what.targets, what.name))
    if targets.ndim > 2:
        raise ShapeError(f"{what.name} has {targets.ndim} axes: [contacts, steps], [steps] or one number")
    if targets.shape[-1] == 0:
        raise ArgumentError(f"{what.name} is empty: one value for each step is needed")
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
    n, steps = max(counts.values(), default=1), targets.shape[-1]
    if starts is not None and starts.shape != (n, *system.shape):
        raise ShapeError(f"start has shape {starts.shape}; {(n, *system.shape)} is needed")

    asked = {"stiffness": stiffness, "mean_gap": mean_gap, "energy": energy}
    for name in ("load", "area", "stiffness"):
        asked[f"{name}_lower"] = asked[f"{name}_upper"] = intervals and (stiffness or name != "stiffness")
    always = ("load", "approach", "contact_area", "certificate")
    out = {name: np.full((n, steps), np.nan) for name in (*always, *(name for name, wanted in asked.items() if wanted))}
    whole = {name: np.full((n, steps), -1, np.int64) for name in ("iterations", "products")}
    statuses = np.full((n, steps), int(Status.STOP_CANCELLED), np.int32)
    pressures = np.zeros((n, *system.shape)) if keep_pressure else None

    struct = given(rc_batch(), control=what.control, warm_start=as_switch(warm_start), virgin=as_switch(virgin), n=n, steps=steps)
    given(struct, targets=targets, undeformed_gap=gaps, mask=masks, p0=starts, p=pressures)
    given(struct.columns, status=statuses, **out, **whole)
    for name, array, own in (("target", targets, 2), ("undeformed_gap", gaps, axes + 1), ("mask", masks, axes + 1)):
        setattr(struct, f"{name}_stride", _constants.RC_BATCH_SHARED if array is not None and array.ndim < own else 0)

    shared = masks if masks is not None and masks.ndim == axes else None
    grid = Grid(system.shape, system.pitch, system.periodic, shared, system.modulus)

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
    chosen = dict(options or {}) if each is not None else with_threads(options, system, n)

    def call() -> int:
        with OptionSet(chosen, context) as handle:
            return int(contact_library().rc_batch_solve(description, handle, struct))

    keep = (system, product, callbacks, targets, gaps, masks, starts, out, whole, statuses, pressures)
    with bars.over("steps", n * steps) if progress else nullcontext():
        status, message, interrupt = interruptible(call, keep=keep)
    answer = None
    if struct.written == n:
        ends: Dict[str, Any] = {"certified": struct.certified, "first": struct.first, "grid": grid}
        arrays: Dict[str, Any] = {**dict.fromkeys(asked), **out, **whole, "pressure": pressures}
        answer = BatchResult(status=as_status(status), message=message, statuses=statuses, **arrays, **ends)
    accepted = answer is not None and n > 0 and not check
    conclude(Status.OK if accepted else status, message, interrupt, answer, check, product, callbacks)
    assert answer is not None
    return answer


def _surfaces(
    heights: Any,
    undeformed_gap: Optional[ArrayLike],
    mask: Optional[ArrayLike],
    missing: str,
    system: Optional[System],
    pitch: Optional[Pitch],
    modulus: Optional[float],
    boundary: Optional[str],
    unit: Optional[str],
    hardness: Optional[float],
) -> Tuple[System, Doubles, Optional[Mask]]:
    """(system, gaps, masks), the arrays with an axis for contacts where they are not shared."""
    given: Any = {"pitch": pitch, "modulus": modulus, "boundary": boundary, "unit": unit, "hardness": hardness}
    refuse_two_sources(heights, undeformed_gap, system, **given)
    periodic: Optional[bool] = None
    if heights is not None and _is_sequence_of_surfaces(heights):
        if mask is not None:
            raise ArgumentError("mask and a sequence of surfaces are both given; surfaces bring their masks")
        each = [as_surface(one, pitch, missing=missing, unit=unit) for one in heights]
        if any(one.shape != each[0].shape or not same_pitch(one.pitch, each[0].pitch) for one in each):
            raise ShapeError("the surfaces differ in shape or pitch; a batch has one grid")
        if system is not None:
            refuse_another_pitch(each[0], system)
        if boundary is None and system is None and any(one.periodic != each[0].periodic for one in each):
            raise ArgumentError("the surfaces differ in whether they repeat; give boundary='free' or 'periodic'")
        pitch, periodic = each[0].pitch, each[0].periodic
        gaps = np.stack([one.undeformed_gap() for one in each])
        masks = None
        if any(one.mask is not None for one in each):
            masks = np.stack([np.ones(one.shape, np.uint8) if one.mask is None else one.mask for one in each])
    elif heights is not None:
        alone = not isinstance(heights, (np.ndarray, list, tuple))
        axes = 0 if alone else np.ndim(in_order(heights))
        leading = 0 if alone or axes == (2 if system is None else len(system.shape)) else 1
        otherwise = None if system is None else system.pitch
        surface = as_surface(heights, pitch, mask=mask, missing=missing, unit=unit, leading=leading, otherwise=otherwise)
        gaps, masks = gap_below(surface.heights, surface.mask, leading), surface.mask
        if system is not None:
            refuse_another_pitch(surface, system)
        pitch, periodic = surface.pitch, surface.periodic
    else:
        gaps, masks = as_doubles(gap_in_metres(undeformed_gap, unit), "undeformed_gap"), as_mask(mask, "mask")
        if system is None:
            refuse_one_row(gaps, "undeformed_gap", pitch)
            if pitch is not None:
                _, pitch = gap_and_pitch(undeformed_gap, pitch, unit)
    if system is None:
        modulus = needed_modulus(modulus, None, None, ", or system=")
        if pitch is None:
            raise ArgumentError("pitch is missing: the distance of neighbouring points, one number or (hx, hy); or system=")
        system = HalfSpace(
            gaps.shape[-2:], pitch=pitch, modulus=modulus, boundary=boundary_of(boundary, periodic), hardness=hardness
        )
    axes = len(system.shape)
    for name, array in (("heights or undeformed_gap", gaps), ("mask", masks)):
        if array is not None and (array.shape[-axes:] != system.shape or array.ndim > axes + 1):
            raise ShapeError(f"{name} has shape {array.shape}; {system.shape} or (contacts, *{system.shape}) is needed")
    return system, gaps, masks


def _is_sequence_of_surfaces(thing: Any) -> bool:
    return isinstance(thing, (list, tuple)) and len(thing) > 0 and (hasattr(thing[0], "heights") or is_file(thing[0]))

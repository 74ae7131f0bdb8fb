"""One contact in one call, a step or a history."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, Callable, Optional, Tuple, Union

from numpy.typing import ArrayLike

from ._arrays import Mask, Pitch, as_doubles, as_mask, refuse_one_row
from ._calls import short_traceback
from ._device import device_array
from ._elastic import Constant, modulus_of, needed_modulus
from ._errors import ArgumentError
from ._handle import Watch
from ._height_map import Surface
from ._history import history_on
from ._keywords import in_metres, options_of, prescribed, refuse_two_sources
from ._maps import as_surface, gap_and_pitch
from ._preparation import Body, body_of, own_unit, prepared
from .contact import Contact, gap_and_mask
from .context import Context, Options
from ._history_result import HistoryResult
from .result import Result
from .system import HalfSpace, System, boundary_of


def system_for(
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
    against: Any,
    shape: Union[None, str, Surface],
    remove: Optional[str],
    devices: bool = False,
) -> Tuple[System, Any, Optional[Mask], Optional[Body]]:
    """(system, undeformed_gap, mask, nominal shape) from what one-shot functions are given. devices: a gap on a device stays
    there."""
    body = None
    given: Any = {"pitch": pitch, "modulus": modulus, "boundary": boundary, "unit": unit, "hardness": hardness}
    refuse_two_sources(heights, undeformed_gap, system, **given)
    if against is not None or shape is not None or remove is not None:
        if heights is None:
            raise ArgumentError("against, shape and remove change heights, but undeformed_gap is given")
        otherwise = None if system is None else system.pitch
        changes: Any = {"against": against, "shape": shape, "remove": remove}
        own = own_unit(heights)
        heights = prepared(heights, pitch=pitch, mask=mask, missing=missing, unit=unit, otherwise=otherwise, **changes)
        body = body_of(shape, heights, unit, own) if isinstance(shape, str) else None
        mask, missing, pitch, unit = None, "reject", None, None
    if system is not None:
        found, mask_array = gap_and_mask(system, heights, undeformed_gap, mask, missing, devices=devices)
        assert found is not None
        return system, found, mask_array, body
    modulus = needed_modulus(modulus, None, None, ", or system=")
    if heights is not None:
        surface = as_surface(heights, pitch, mask=mask, missing=missing, unit=unit)
        boundary = boundary_of(boundary, surface.periodic)
        half_space = HalfSpace(surface.shape, pitch=surface.pitch, modulus=modulus, boundary=boundary, hardness=hardness)
        return half_space, surface.undeformed_gap(), surface.mask, body
    undeformed_gap, sides = gap_and_pitch(undeformed_gap, pitch, unit)
    there = device_array(undeformed_gap, "undeformed_gap") if devices else None
    array: Any = as_doubles(undeformed_gap, "undeformed_gap") if there is None else there
    refuse_one_row(array, "undeformed_gap", pitch)
    half_space = HalfSpace(array.shape, pitch=sides, modulus=modulus, boundary=boundary, hardness=hardness)
    return half_space, array, as_mask(mask, "mask", array.shape), None


def _remarked(result: Result, body: Optional[Body]) -> Result:
    """With the remark that a shape's contact does not fit on the map."""
    grid = result.grid
    if body is None or grid.modulus is None or result.contacts == 0:
        return result
    rows, columns = (1, *grid.shape)[-2:]
    remark = body.too_wide(result.load, grid.modulus, (columns * grid.pitch[0], rows * grid.pitch[1]))
    return replace(result, note="; ".join(filter(None, [result.note, remark])))


@short_traceback
def solve(
    heights: Any = None,
    *,
    approach: Optional[float] = None,
    load: Optional[float] = None,
    pressure: Optional[float] = None,
    area: Optional[float] = None,
    undeformed_gap: Optional[ArrayLike] = None,
    mask: Optional[ArrayLike] = None,
    missing: str = "reject",
    start: Optional[ArrayLike] = None,
    want_pressure: bool = True,
    want_gap: bool = False,
    check: bool = True,
    system: Optional[System] = None,
    pitch: Optional[Pitch] = None,
    modulus: Optional[float] = None,
    E: Optional[Constant] = None,
    nu: Optional[Constant] = None,
    boundary: Optional[str] = None,
    unit: Optional[str] = None,
    hardness: Optional[float] = None,
    against: Any = None,
    shape: Union[None, str, Surface] = None,
    remove: Optional[str] = None,
    options: Options = None,
    progress: Watch = None,
    every: int = 1,
    context: Optional[Context] = None,
    **keywords: Any,
) -> Result:
    """Presses a surface into an elastic half-space. One of approach, load, pressure and area is prescribed.

    heights: a `Surface`, a file (see `read`), a topography of SurfaceTopography, or an array [ny, nx]; the highest point
        touches at approach 0 [length]
    approach: approach of the bodies [length]
    load: normal force [force]
    pressure: load over the area of the grid [force/length^2]
    area: contact area as a share of the grid's; the load is searched
    undeformed_gap: the undeformed gap [ny, nx] instead of heights [length]; also an array on a device, see `Contact.solve`
    mask: [ny, nx], 0 at points that carry no pressure and whose heights are ignored. None: all points may carry pressure
    missing: rule for masked or NaN heights: "reject", "exclude" (they carry no pressure) or "fill" (interpolated)
    start: pressures [ny, nx] to begin with [force/length^2]; None: the solver's
    want_pressure: whether the result holds the pressures [ny, nx]
    want_gap: whether it holds the deformed gap [ny, nx], which is expensive for sparse contact on a large grid
    check: whether a stop before the tolerance raises `NotCertifiedError`, which has the result; otherwise look at its status.
        Status.WITHIN_GOAL never raises
    system: replaces pitch, modulus, boundary, unit and hardness: a `HalfSpace`, `Matrix` or `Product`
    pitch: distance of neighbouring points, one number or (hx, hy) with hx along the last axis [length]; a surface has its own
    modulus: contact modulus E* = 1/((1-nu1^2)/E1 + (1-nu2^2)/E2) [force/length^2]
    E, nu: replace modulus: Young's modulus [force/length^2] and Poisson's ratio of the one body that is elastic, or two each
    boundary: "periodic": the map is a sample of a larger surface; "free": the body ends at the map's edges; "periodic-x",
        "periodic-y": it repeats along this axis only; None: as the surface says, else periodic, with an `AssumedBoundary` warning
    unit: of lengths that have none, heights, pitch, approach and R of a shape: "um"; all others are then in m, Pa and N. None: they
        are in any consistent set of units, those of a file in m. A surface that names its unit is pressed in metres
    hardness: the largest pressure [force/length^2], see `HalfSpace`; None: none
    against: heights of the other body on the same grid, which are added: a `Surface`, a file or an array
    shape: nominal shape, added last: "sphere:R=1mm", "cylinder:R=1mm,axis=x" or "wedge:angle=5deg,axis=x", in the middle of the
        grid, or a `Surface`
    remove: form that is subtracted before, fitted to the points that are not missing: "mean", "plane" or "quadric"; None: none
    options: {"tol": 1e-6, "fft.precision": "single"} and the like, see `roughcontact.options()`; the same as keywords, with _ for
        dots and hyphens: tol=1e-6, fft_precision="single"
    progress: True: a bar of the package tqdm. Or a function, called with a `Progress` at least every `every` iterations on the thread
        that solves; if it returns True, the step ends with Status.STOP_CANCELLED
    every: iterations between two calls of progress
    context: a registry of backends, solvers and kernels of its own; None: the default one
    """
    modulus, options = modulus_of(modulus, E, nu), options_of(solve, options, keywords, context)
    system, undeformed_gap, mask, body = system_for(
        heights, undeformed_gap, mask, missing, system, pitch, modulus, boundary, unit, hardness, against, shape, remove, True
    )
    with Contact(system, options=options, progress=progress, every=every, context=context) as contact:
        result = contact.solve(
            approach=in_metres(approach, unit),
            load=load,
            pressure=pressure,
            area=area,
            undeformed_gap=undeformed_gap,
            mask=mask,
            start=start,
            borrow=True,
            want_pressure=want_pressure,
            want_gap=want_gap,
            check=check,
        )
    return _remarked(result, body)


@short_traceback
def history(
    heights: Any = None,
    *,
    approach: Optional[ArrayLike] = None,
    load: Optional[ArrayLike] = None,
    pressure: Optional[ArrayLike] = None,
    area: Optional[ArrayLike] = None,
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
    system: Optional[System] = None,
    pitch: Optional[Pitch] = None,
    modulus: Optional[float] = None,
    E: Optional[Constant] = None,
    nu: Optional[Constant] = None,
    boundary: Optional[str] = None,
    unit: Optional[str] = None,
    hardness: Optional[float] = None,
    against: Any = None,
    shape: Union[None, str, Surface] = None,
    remove: Optional[str] = None,
    options: Options = None,
    progress: Watch = None,
    every: int = 1,
    context: Optional[Context] = None,
    **keywords: Any,
) -> HistoryResult:
    """Solves the steps of a loading history in order, each from the pressures of the one before.

    approach, load, pressure or area: one value for each step, in any order
    virgin: with a hardness: whether every step presses the surface without the plastic indentation of the steps before
            it
    stiffness: whether to compute dW/dd
    keep_pressure: whether to keep the pressures of all steps
    want_gap: whether each step computes its deformed gap, for the mean gap of sparse contact; with `each` it does
    each: called with (step, `Result`) after every step, on the thread that solves. True ends the history with
        Status.STOP_CANCELLED; an exception ends it and is raised
    check: whether a step that is not certified raises `NotCertifiedError`. That, every other `RoughContactError` and
        `Interrupted` (Ctrl-C) have the steps that were completed as their `result`
    the others: as in `solve`
    """
    modulus, options = modulus_of(modulus, E, nu), options_of(history, options, keywords, context)
    system, found_gap, mask, body = system_for(
        heights, undeformed_gap, mask, missing, system, pitch, modulus, boundary, unit, hardness, against, shape, remove
    )
    what = prescribed(system, approach=in_metres(approach, unit), load=load, pressure=pressure, area=area)
    with Contact(system, options=options, progress=progress, every=every, context=context) as contact:
        answer = history_on(contact, what, found_gap, mask, warm_start, virgin, stiffness, keep_pressure, want_gap, each, check)
    return replace(answer, results=tuple(_remarked(result, body) for result in answer.results))

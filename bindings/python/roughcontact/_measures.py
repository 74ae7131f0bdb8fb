"""What the pressures of a step look like, as the command's table of steps has it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Optional

import numpy as np

from . import analysis
from ._answers import Stored
from ._arrays import Doubles, Mask, array_in, as_doubles, given
from ._calls import check
from ._library import contact_library
from ._structs import rc_patches
from .system import grid_struct

#: columns of the command's steps.csv, in its order; those of the last line it has only with a hardness
STEP_COLUMNS = (
    *("status", "approach", "load", "mean_pressure", "area_fraction", "max_pressure", "mean_gap", "corrected_area"),
    *("patches", "largest_patch", "contact_crosses", "gap_crosses", "contacts", "candidates", "stiffness", "punch_stiffness"),
    *("kkt_primal", "kkt_dual", "kkt_complementarity", "kkt_control", "iterations", "products", "seconds", "setup_seconds"),
    *("solver", "backend", "kernel", "points", "modelled", "energy", "duality_gap", "gap_error", "load_lower", "load_upper"),
    *("area_lower", "area_upper", "stiffness_lower", "stiffness_upper", "proven_contacts", "proven_open", "undecided"),
    *("tolerance", "model_nx", "model_ny", "error_estimate", "left_out", "area_estimate", "note", "message"),
    *("capped", "plastic_volume", "proven_capped"),
)


@dataclass(frozen=True)
class Measures(Stored):
    """corrected_area, largest_patch [length^2]; patches: how many; contact_crosses, gap_crosses: "none", "x", "y" or "xy", as in
    `analysis.Crossing`."""

    corrected_area: float
    patches: int
    largest_patch: float
    contact_crosses: str
    gap_crosses: str


UNKNOWN = Measures(np.nan, -1, np.nan, "", "")


def measures_of(pressure: Any, grid: Any) -> Measures:
    where: Any = {"pitch": grid.pitch, "periodic": grid.periodic, "mask": grid.mask}
    p = as_doubles(pressure, "pressure")
    crossing = analysis.crossing(p, **where)
    areas = _patch_areas(p, grid.mask, grid_struct(grid.shape, grid.pitch, grid.periodic))
    return Measures(
        corrected_area=analysis.area(p, **where).corrected_area,
        patches=len(areas),
        largest_patch=float(areas.max(initial=0)),
        contact_crosses=crossing.contact,
        gap_crosses=crossing.gap,
    )


def _patch_areas(p: Doubles, mask: Optional[Mask], system: Any) -> Doubles:
    """Without labels of the points."""
    counted = rc_patches()
    check(contact_library().rc_patches_find(system, array_in(p), array_in(mask), counted))
    areas = np.empty(counted.count)
    check(
        contact_library().rc_patches_find(system, array_in(p), array_in(mask), given(rc_patches(), room=len(areas), area=areas))
    )
    return areas

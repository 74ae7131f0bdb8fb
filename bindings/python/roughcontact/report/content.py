"""What a report tells: the surface is read and pressed, and all that the page shows is gathered. Lengths in m, forces in N."""

import datetime
import math
from dataclasses import dataclass, replace
from typing import Any, Dict, List, Optional, Tuple

import numpy as np

from .. import _constants, surface as surfaces
from .._arrays import Doubles
from .._blocks import largest, means, side_of_blocks
from .._errors import ArgumentError, LibraryNotFoundError
from .._height_map import Surface
from .._law import Law
from .._status import Status
from ..analysis import Histogram, Patches
from ..contact import Contact
from ..context import version
from ..result import Result
from ..surface import PowerLaw, Spectrum, Statistics
from .request import Request, press

MOST_CELLS = 150000  # of a map on the page
BINS = 60


@dataclass(frozen=True, eq=False)
class Maps:
    """Maps of the surface as pressed and of the last step, in blocks of side x side points: the means of heights, gaps and shares
    of contact, the largest pressures."""

    side: int
    pitch: Tuple[float, float]
    heights: Doubles
    pressure: Doubles
    gap: Doubles
    contact: Doubles


@dataclass(frozen=True, eq=False)
class Content:
    """surface: as pressed; missing: points that the file does not have
    assumes_boundary: neither the request nor the file says it
    contact_law: of --law
    statistics, spectrum, law: None where the library for them is absent or points are missing
    steps: their answers, without arrays
    persson: rms slope of Persson's line; None if the surface is not one of his theory, elastic, periodic and nearly Gaussian
    date: of the day on which the surface was pressed, as 2026-11-27
    bearing: (share of the area that is higher, height)
    """

    request: Request
    surface: Surface
    assumed: str
    assumes_boundary: bool
    missing: int
    statistics: Optional[Statistics]
    spectrum: Optional[Spectrum]
    law: Optional[PowerLaw]
    bearing: Tuple[Doubles, Doubles]
    steps: List[Result]
    maps: Maps
    histogram: Optional[Histogram]
    patches: Patches
    contact_law: Optional[Law]
    version: str
    date: str

    @property
    def persson(self) -> Optional[float]:
        s = self.statistics
        gaussian = s is not None and abs(s.skewness) < 1 and 2.3 < s.kurtosis < 5  # 0 and 3 for a Gaussian, 1.5 for a wave
        return s.rms_slope if s and gaussian and self.surface.periodic and not self.request.hardness else None

    @property
    def nominal_area(self) -> float:
        return float(np.prod(self.surface.shape) * self.surface.pitch[0] * self.surface.pitch[1])

    @property
    def certified(self) -> bool:
        return all(step.status in (Status.OK, Status.WITHIN_GOAL) for step in self.steps)

    def corrected(self, step: Result) -> float:
        """The share of the area in contact, less what partly touching cells add."""
        return step.corrected_area / (step.points * self.surface.pitch[0] * self.surface.pitch[1])

    def persson_area(self, load: float) -> float:
        """Persson's share of the area in contact, erf(sqrt(2) p/(E* h')), h' the rms slope (J. Chem. Phys. 115 (2001) 3840)."""
        assert self.persson
        return math.erf(math.sqrt(2) * load / (self.nominal_area * self.request.modulus * self.persson))


def _judged(surface: Surface, periodic: bool) -> Tuple[Optional[Statistics], Optional[Spectrum], Optional[PowerLaw]]:
    if surface.mask is not None or np.ptp(surface.heights) == 0:
        return None, None, None
    try:
        statistics = surfaces.analyze(surface, periodic=periodic)
    except LibraryNotFoundError:
        return None, None, None
    try:
        return statistics, surfaces.psd(surface, periodic=periodic), surfaces.power_law(surface, periodic=periodic)
    except ArgumentError:  # too few points
        return statistics, None, None


def _maps(surface: Surface, result: Result) -> Maps:
    assert result.pressure is not None and result.gap is not None
    side = side_of_blocks(surface.shape, MOST_CELLS)
    heights = np.where(surface.missing, np.nan, surface.heights)
    return Maps(
        side=side,
        pitch=(surface.pitch[0] * side, surface.pitch[1] * side),
        heights=means(heights - np.nanmean(heights), side),
        pressure=largest(result.pressure, side),
        gap=means(np.maximum(result.gap, 0) if result.capped > 0 else result.gap, side),
        contact=means((result.pressure > 0).astype(float), side),
    )


def _options(request: Request) -> Dict[str, Any]:
    named = {"tol": request.tol, "accuracy": request.accuracy, "threads": request.threads}
    return {"stiffness": 1, **{name: value for name, value in named.items() if value is not None}}


def collect(request: Request) -> Content:
    contact_law = Law.load(request.law) if request.law else None
    press(request)
    problem = request.problem
    view, surface = problem.request.view, problem.surface()
    remarks = problem.request.remarks()
    steps: List[Result] = []
    gap, mask = problem.gap, problem.mask
    with Contact(problem.system, options=_options(request)) as contact:
        for target in request.targets:
            press_with: Any = {request.control: target}
            result = contact.solve(undeformed_gap=gap, mask=mask, want_gap=True, check=False, **press_with)
            gap = mask = None  # as in the step before
            steps.append(problem.remarked(replace(result, pressure=None, gap=None, measures=result._measured)))
    assert result.pressure is not None
    heights = np.sort(surface.heights[~surface.missing])[::-1]
    shares = np.linspace(0, 1, 201)
    statistics, spectrum, law = _judged(surface, request.words.get("boundary") == "periodic" or surface.periodic is True)
    said = [
        each.text.decode(errors="replace")
        for each in remarks
        if each.code in (_constants.RC_REMARK_FILE, _constants.RC_REMARK_UNIT)
    ]
    return Content(
        request=request,
        surface=replace(surface, periodic=problem.system.periodic is True),
        assumed="; ".join(said),
        assumes_boundary=any(each.code == _constants.RC_REMARK_BOUNDARY for each in remarks),
        missing=view.missing,
        statistics=statistics,
        spectrum=spectrum,
        law=law,
        bearing=(shares, heights[np.round(shares * (len(heights) - 1)).astype(int)] - heights.mean()),
        steps=steps,
        maps=_maps(surface, result),
        histogram=result.histogram(BINS) if result.contacts else None,
        patches=result.find_patches(),
        contact_law=contact_law,
        version=".".join(map(str, version())),
        date=datetime.date.today().isoformat(),
    )

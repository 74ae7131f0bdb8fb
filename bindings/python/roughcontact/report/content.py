"""What a report tells: the folder of a run is read, and all that the page shows is gathered. Lengths in m, forces in N."""

import datetime
import json
import math
import pathlib
import shlex
from dataclasses import dataclass
from types import SimpleNamespace
from typing import Any, Dict, List, Optional, Tuple

import numpy as np

from .. import analysis, surface as surfaces
from .._arrays import Doubles
from .._blocks import largest, means, side_of_blocks
from .._errors import ArgumentError, LibraryNotFoundError
from .._flow import flow
from .._height_map import Surface
from .._law import Law
from .._status import Status
from ..analysis import Histogram, Patches
from ..surface import PowerLaw, Spectrum, Statistics
from ..system import REPEATS

MOST_CELLS = 150000  # of a map on the page
BINS = 60


class Step(SimpleNamespace):
    """A step of summary.json: its fields, NaN where they are null."""

    def __init__(self, fields: Dict[str, Any]) -> None:
        known = {name: math.nan if value is None else value for name, value in fields.items()}
        super().__init__(**{"capped": 0, **known, "status": Status[fields["status"].removeprefix("RC_")]})

    @property
    def certified(self) -> bool:
        return bool(self.status == Status.OK)

    @property
    def residual(self) -> float:
        return float(max(self.kkt_primal, self.kkt_dual, self.kkt_complementarity, self.kkt_control))


@dataclass(frozen=True, eq=False)
class Maps:
    """Maps of the surface as pressed and of the last step, in blocks of side x side points: the means of heights, gaps and shares
    of contact, the largest pressures. fluid: the fluid's pressure over the drop; None without a leak"""

    side: int
    pitch: Tuple[float, float]
    heights: Doubles
    pressure: Doubles
    gap: Doubles
    contact: Doubles
    fluid: Optional[Doubles]


@dataclass(frozen=True, eq=False)
class Content:
    """input: as summary.json has it, with the words that were given
    curve: whether only the last target was asked for, and the others lead up to it
    surface: as pressed; its boundary is that of the run
    contact_law: of --law
    statistics, spectrum, law: None where the library for them is absent or points are missing
    persson: rms slope of Persson's line; None if the surface is not one of his theory, elastic, periodic and nearly Gaussian
    budget: as summary.json has it; None if no budget was asked for
    date: of the day on which the surface was pressed, as 2026-11-27
    bearing: (share of the area that is higher, height)
    """

    input: Dict[str, Any]
    curve: bool
    surface: Surface
    statistics: Optional[Statistics]
    spectrum: Optional[Spectrum]
    law: Optional[PowerLaw]
    bearing: Tuple[Doubles, Doubles]
    steps: List[Step]
    maps: Maps
    histogram: Optional[Histogram]
    patches: Patches
    contact_law: Optional[Law]
    budget: Optional[Dict[str, Any]]
    date: str

    @property
    def words(self) -> Dict[str, str]:
        found: Dict[str, str] = self.input["words"]
        return found

    @property
    def modulus(self) -> float:
        return float(self.input["modulus"])

    @property
    def hardness(self) -> Optional[float]:
        return self.input.get("hardness")

    @property
    def times(self) -> Optional[List[float]]:
        """Of the steps, if the bodies creep."""
        return [step.time for step in self.steps] if "times" in self.input else None

    @property
    def version(self) -> str:
        return str(self.input["library_version"])

    @property
    def command(self) -> str:
        """That repeats the run."""
        own = {"stiffness", "resumable", *self.words}
        options = [f"--set={name}={text}" for name, text in self.input["options"].items() if name not in own]
        words = [word for name, text in self.words.items() for word in ("--" + name, text)]
        budget = ["--budget", self.budget["sources"]] if self.budget else []
        return shlex.join(["roughcontact", "solve", self.input["file"], *words, *budget, *options])

    @property
    def persson(self) -> Optional[float]:
        s = self.statistics
        gaussian = s is not None and abs(s.skewness) < 1 and 2.3 < s.kurtosis < 5  # 0 and 3 for a Gaussian, 1.5 for a wave
        smooth = "shape" in self.words or self.hardness or self.times is not None
        return s.rms_slope if s and gaussian and self.surface.periodic and not smooth else None

    @property
    def nominal_area(self) -> float:
        return float(np.prod(self.surface.shape) * self.surface.pitch[0] * self.surface.pitch[1])

    @property
    def certified(self) -> bool:
        return all(step.status in (Status.OK, Status.WITHIN_GOAL) for step in self.steps)

    def corrected(self, step: Step) -> float:
        """The share of the area in contact, less what partly touching cells add."""
        return float(step.corrected_area / (step.points * self.surface.pitch[0] * self.surface.pitch[1]))

    def persson_area(self, load: float) -> float:
        """Persson's share of the area in contact, erf(sqrt(2) p/(E* h')), h' the rms slope (J. Chem. Phys. 115 (2001) 3840)."""
        assert self.persson
        return math.erf(math.sqrt(2) * load / (self.nominal_area * self.modulus * self.persson))


def _judged(surface: Surface, periodic: bool) -> Tuple[Optional[Statistics], Optional[Spectrum], Optional[PowerLaw]]:
    if surface.missing.any() or np.ptp(surface.heights) == 0:
        return None, None, None
    try:
        statistics = surfaces.analyze(surface, periodic=periodic)
    except LibraryNotFoundError:
        return None, None, None
    try:
        return statistics, surfaces.psd(surface, periodic=periodic), surfaces.power_law(surface, periodic=periodic)
    except ArgumentError:  # too few points
        return statistics, None, None


def _fluid(given: Dict[str, Any], gap: Doubles, pitch: Tuple[float, float]) -> Doubles:
    along = given["leak_along"]
    repeats = REPEATS[given["boundary"]]
    sides = "periodic" if repeats is True or repeats not in (False, along) else "closed"
    fluid = {"viscosity": given["viscosity"], "pressure_drop": given["pressure_drop"], "along": along, "sides": sides}
    found = flow(np.nan_to_num(np.maximum(gap, 0)), pitch=pitch, want_potential=True, **fluid).potential
    assert found is not None
    return found


def _maps(surface: Surface, pressure: Doubles, gap: Doubles, yields: bool, given: Dict[str, Any]) -> Maps:
    side = side_of_blocks(surface.shape, MOST_CELLS)
    return Maps(
        side=side,
        pitch=(surface.pitch[0] * side, surface.pitch[1] * side),
        heights=means(surface.heights - np.nanmean(surface.heights), side),
        pressure=largest(pressure, side),
        gap=means(np.maximum(gap, 0) if yields else gap, side),
        contact=means((pressure > 0).astype(float), side),
        fluid=means(_fluid(given, np.where(pressure > 0, 0, gap), surface.pitch), side) if "viscosity" in given else None,
    )


def _array(folder: pathlib.Path, name: str) -> Doubles:
    try:
        found: Doubles = np.load(folder / name)
    except OSError:
        raise ArgumentError(f"{folder} has no {name}, which solve --out writes unless --no-maps is given") from None
    return found


def collect(folder: pathlib.Path, curve: bool = False, law: Optional[str] = None) -> Content:
    """Of the folder that `roughcontact solve --out` has written."""
    contact_law = Law.load(law) if law else None
    try:
        text = (folder / "summary.json").read_text()
    except OSError:
        raise ArgumentError(f"{folder} has no summary.json, which roughcontact solve --out writes") from None
    summary = json.loads(text)
    given, steps = summary["input"], [Step(fields) for fields in summary["steps"]]
    if not steps:
        raise ArgumentError(f"{folder} has no complete step")
    digits = len(str(len(given["targets"])))
    heights, pressure, gap = (
        _array(folder, name)
        for name in ("heights.npy", *(f"{what}-{len(steps):0{digits}}.npy" for what in ("pressure", "gap")))
    )
    repeats = REPEATS[given["boundary"]]
    surface = Surface(heights, (given["hx"], given["hy"]), repeats is True, unit="m")
    known = heights[~surface.missing]
    ordered, shares = np.sort(known)[::-1], np.linspace(0, 1, 201)
    assumed = any(text.startswith("boundary periodic, the map is taken") for text in given["assumed"])
    statistics, spectrum, power_law = _judged(surface, repeats is True and not assumed)
    grid: Dict[str, Any] = {
        "pitch": surface.pitch,
        "periodic": repeats,
        "mask": None if known.size == heights.size else ~surface.missing,
    }
    return Content(
        input=given,
        curve=curve,
        surface=surface,
        statistics=statistics,
        spectrum=spectrum,
        law=power_law,
        bearing=(shares, ordered[np.round(shares * (len(ordered) - 1)).astype(int)] - ordered.mean()),
        steps=steps,
        maps=_maps(surface, pressure, gap, steps[-1].capped > 0, given),
        histogram=analysis.histogram(pressure, BINS, None, **grid) if steps[-1].contacts else None,
        patches=analysis.patches(pressure, **grid),
        contact_law=contact_law,
        budget=summary.get("budget"),
        date=datetime.date.fromtimestamp((folder / "summary.json").stat().st_mtime).isoformat(),
    )

"""Generation and analysis of rough surfaces. All functions but `example` load libroughcontact-surface, which links the GNU
Scientific Library (GPL): pip install roughcontact-gpl.

Generators return a `Surface`; what they are not given has the value of the header's RC_SURFACE_..._INIT macros. Whatever takes a
surface takes a `Surface`, a topography of SurfaceTopography, or heights with a pitch. The PSD is C(qx, qy) = nx ny hx hy |a|^2 with
a = DFT(heights)/(nx ny) [length^4]; wave numbers are 2 pi / wavelength [1/length].
"""

import ctypes
import pathlib
from dataclasses import dataclass
from typing import Any, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _constants
from ._arrays import Doubles, Mask, Pitch, as_doubles, as_int, as_pitch, as_seed, as_shape, as_switch, given, pointer
from ._arrays import columns_and_rows
from ._c import members_for
from ._calls import finish, short_traceback, surface_calls
from ._errors import ArgumentError, ShapeError
from ._library import surface_library
from ._files import read
from ._height_map import Surface
from ._request import as_surface
from ._structs import (
    rc_surface_cmr,
    rc_surface_map,
    rc_surface_power_law,
    rc_surface_rmd_spec,
    rc_surface_shape_spec,
    rc_surface_spectral_spec,
    rc_surface_statistics,
)

Grid = Union[int, Sequence[int]]
__all__ = [
    *("rmd", "spectral", "example", "paraboloid", "sphere", "waves", "pyramids", "noise"),
    *("analyze", "psd", "power_law", "cmr_advice", "downsample"),
    *("Statistics", "Spectrum", "PowerLaw", "CmrAdvice"),
]


def __dir__() -> Sequence[str]:
    return __all__


def _pitch(pitch: Optional[Pitch]) -> Tuple[float, float]:
    """(hx, hy); None: as specifications begin."""
    spec = rc_surface_shape_spec()
    return (spec.hx, spec.hy) if pitch is None else as_pitch(pitch)


def _run(name: str, *arguments: Any, keep: Any = None) -> None:
    """Calls a function of the library; Ctrl-C ends it."""
    function = getattr(surface_library(), f"rc_surface_{name}")
    finish(lambda: int(function(*arguments)), keep=keep, of=surface_calls)


def rmd(
    levels: int,
    *,
    pitch: Optional[Pitch] = None,
    hurst: Optional[float] = None,
    sigma: Optional[float] = None,
    rms_height: Optional[float] = None,
    seed: Optional[int] = None,
    additions: Optional[bool] = None,
    stage: Optional[int] = None,
    crop: bool = True,
) -> Surface:
    """Random midpoint displacement (Peitgen & Saupe 1988): the same numbers on every machine.

    levels: 1 .. 14, the finest stage has 2^levels + 1 points a side; stage: 0 .. levels, None: the finest
    hurst: 0 < H <= 1; sigma: standard deviation of the corners [length]
    rms_height: > 0: all stages are scaled so that the finest has it [length]
    additions: random additions to all earlier points at every stage
    crop: leave the last row and column out, 2^stage points a side remain
    pitch: of the stage [length]
    """
    spec = given(rc_surface_rmd_spec(), levels=as_int(levels, "levels", 32), seed=as_seed(seed), additions=as_switch(additions))
    given(spec, hurst=hurst, sigma=sigma, rms_height=rms_height)
    at = spec.levels if stage is None else as_int(stage, "stage", 32)
    side = 2**at + (0 if crop else 1) if 0 <= at <= spec.levels <= 14 else 1  # what is refused is not written to
    heights = np.empty((side, side))
    _run("rmd", spec, at, int(bool(crop)), pointer(heights))
    return Surface(heights, _pitch(pitch))


def spectral(
    shape: Grid,
    *,
    pitch: Optional[Pitch] = None,
    hurst: Optional[float] = None,
    q_low: Optional[float] = None,
    q_rolloff: Optional[float] = None,
    q_high: Optional[float] = None,
    rms_height: Optional[float] = None,
    rms_slope: Optional[float] = None,
    fixed_amplitudes: Optional[bool] = None,
    seed: Optional[int] = None,
) -> Surface:
    """Periodic self-affine surface: C(q) = 0 below q_low, constant up to q_rolloff, ~ q^(-2 - 2H) up to q_high, 0 above.

    shape: (ny, nx) or nx points; pitch: one number or (hx, hy) [length]; hurst: 0 .. 1
    q_low, q_rolloff, q_high: wave numbers [1/length]; 0: none, q_high pi / max(hx, hy)
    rms_height [length] or rms_slope: one of them
    fixed_amplitudes: only the phases are random
    """
    sides, (hx, hy) = as_shape(shape), _pitch(pitch)
    spec = given(rc_surface_spectral_spec(), seed=as_seed(seed), hx=hx, hy=hy, hurst=hurst, q_low=q_low, q_rolloff=q_rolloff)
    spec.nx, spec.ny = columns_and_rows(sides)
    if rms_slope is not None:
        spec.rms_height = 0.0
    given(spec, q_high=q_high, rms_height=rms_height, rms_slope=rms_slope, fixed_amplitudes=as_switch(fixed_amplitudes))
    heights = np.empty(_not_negative(sides))
    _refuse_wavelengths(spec, q_low=q_low, q_rolloff=q_rolloff)
    _run("spectral", spec, pointer(heights))
    return Surface(heights, (hx, hy), periodic=True)


def _refuse_wavelengths(spec: rc_surface_spectral_spec, **given: Optional[float]) -> None:
    """Wave numbers below that of the longest wave on the grid, or above q_high, would change nothing; as a rule they are
    wavelengths."""
    longest = max(spec.nx * spec.hx, spec.ny * spec.hy)
    if not (np.isfinite(longest) and longest > 0):
        return  # the library says what is wrong with the grid
    highest = spec.q_high or np.pi / max(spec.hx, spec.hy)
    for name, q in given.items():
        if q is not None and q > highest * (1 + 1e-9):
            raise ArgumentError(
                f"{name} = {q:g} is above q_high, {highest:g}, and would change nothing; wave numbers are 2 pi / wavelength"
            )
        if q is not None and 0 < q < 2 * np.pi / longest * (1 - 1e-9):
            raise ArgumentError(
                f"{name} = {q:g} is below {2 * np.pi / longest:g}, the wave number of the longest wave on this grid, and would "
                "change nothing; wave numbers are 2 pi / wavelength"
            )


def _not_negative(sides: Tuple[int, ...]) -> Tuple[int, ...]:
    return sides if min(sides) >= 0 else (0,)


def _shape(
    kind: int,
    shape: Grid,
    pitch: Optional[Pitch],
    periodic: bool = False,
    period: Tuple[Optional[float], Optional[float]] = (None, None),
    **values: Any,
) -> Surface:
    sides, (hx, hy) = as_shape(shape), _pitch(pitch)
    nx, ny = columns_and_rows(sides)
    spec = given(rc_surface_shape_spec(), shape=kind, nx=nx, ny=ny, hx=hx, hy=hy, **values)
    given(spec, period_x=period[0], period_y=period[1])
    heights = np.empty(_not_negative(sides))
    _run("shape", spec, pointer(heights))
    return Surface(heights, (hx, hy), periodic)


def example() -> Surface:
    """A rough surface to try things with, as of polished steel: 256 x 256 points on 10.24 um, periodic, lengths in m; 30 nm high
    (rms), self-affine with Hurst exponent 0.8 below wavelengths of 2.5 um. Its file is example.gsf in this package."""
    return read(pathlib.Path(__file__).with_name("example.gsf"))


def paraboloid(shape: Grid, *, pitch: Optional[Pitch] = None, radius: float) -> Surface:
    """-r^2 / (2 radius) about the grid's centre [length]."""
    return _shape(_constants.RC_SURFACE_PARABOLOID, shape, pitch, radius=radius)


def sphere(shape: Grid, *, pitch: Optional[Pitch] = None, radius: float) -> Surface:
    """sqrt(radius^2 - r^2) - radius about the grid's centre, -radius beyond the radius [length]."""
    return _shape(_constants.RC_SURFACE_SPHERE, shape, pitch, radius=radius)


def waves(shape: Grid, *, pitch: Optional[Pitch] = None, amplitude: float, period: Tuple[float, float]) -> Surface:
    """amplitude cos(2 pi x / period[0]) cos(2 pi y / period[1]); a period of 0: no waves along it [length]."""
    return _shape(_constants.RC_SURFACE_WAVES, shape, pitch, True, height=amplitude, period=period)


def pyramids(shape: Grid, *, pitch: Optional[Pitch] = None, height: float, period: Tuple[float, float]) -> Surface:
    """Square pyramids of this height, base to tip, one a period; a period of 0: ridges [length]."""
    return _shape(_constants.RC_SURFACE_PYRAMIDS, shape, pitch, True, height=height, period=period)


def noise(
    shape: Grid, *, pitch: Optional[Pitch] = None, rms_height: Optional[float] = None, seed: Optional[int] = None
) -> Surface:
    """Independent Gaussian heights, the same numbers on every machine [length]."""
    return _shape(_constants.RC_SURFACE_NOISE, shape, pitch, True, height=rms_height, seed=as_seed(seed))


@dataclass(frozen=True)
class Statistics:
    """Moments of the heights less their trend; NaN where a number has no meaning.

    rms_height, highest, lowest [length]; rms_slope and along x and y; rms_curvature: of the mean curvature [1/length]
    skewness, kurtosis: 0 and 3 for a Gaussian; m0, m2, m4: spectral moments of profiles; nayak: m0 m4 / m2^2
    """

    rms_height: float
    skewness: float
    kurtosis: float
    highest: float
    lowest: float
    rms_slope: float
    rms_slope_x: float
    rms_slope_y: float
    rms_curvature: float
    m0: float
    m2: float
    m4: float
    nayak: float


@dataclass(frozen=True, eq=False)
class Spectrum:
    """Radial average of the PSD: mean wave number q [1/length], mean PSD [length^4] and number of modes of every ring."""

    q: Doubles
    psd: Doubles
    modes: NDArray[np.int64]


@dataclass(frozen=True, eq=False)
class PowerLaw:
    """Features of the spectrum; NaN for those that were not found.

    hurst: exponent of the longest power-law range, hurst_error: half of its 95 % interval
    C = prefactor q^slope for q_min <= q <= q_max; q_rolloff: below it the PSD is flat; q_cutoff: above it the PSD falls faster
    [1/length]
    peak_q: [peaks, 2] wave vectors (qx, qy) of periodic textures, the strongest first [1/length]; peak_share: of the variance
    """

    hurst: float
    hurst_error: float
    slope: float
    prefactor: float
    q_min: float
    q_max: float
    q_rolloff: float
    q_cutoff: float
    peak_q: Doubles
    peak_share: Doubles


@dataclass(frozen=True)
class CmrAdvice:
    """Whether cascade multi-resolution without a check of omitted points can be trusted on a surface.

    trustworthy: whether unresolved <= limit; reason: the advice in words
    levels: halvings of the grid, as asked; safe_levels: the largest number for which it is trustworthy
    unresolved: share of the roughness within reach that the coarsest grid does not resolve; unresolved_overall: over the whole
        surface
    peak_loss: by how much sub-sampling lowers the highest point, over the approach; approach, coarsest_pitch [length]
    """

    trustworthy: bool
    levels: int
    safe_levels: int
    unresolved: float
    limit: float
    unresolved_overall: float
    peak_loss: float
    approach: float
    coarsest_pitch: float
    reason: str


TRENDS = {
    "auto": _constants.RC_SURFACE_TREND_AUTO,
    "mean": _constants.RC_SURFACE_TREND_MEAN,
    "plane": _constants.RC_SURFACE_TREND_PLANE,
}
FILTERS = {"subsample": _constants.RC_SURFACE_SUBSAMPLE, "mean": _constants.RC_SURFACE_MEAN, "max": _constants.RC_SURFACE_MAX}


def _map(
    surface: Any, pitch: Optional[Pitch], periodic: Optional[bool], trend: Optional[str]
) -> Tuple[rc_surface_map, Surface]:
    if trend is not None and trend not in TRENDS:
        raise ArgumentError(f"trend is {trend!r}: {', '.join(TRENDS)}")
    found = as_surface(surface, pitch, periodic)
    if found.missing.any():
        raise ArgumentError("the surface has missing points; fill them first")
    (nx, ny), (hx, hy) = columns_and_rows(found.shape), found.pitch
    struct = given(rc_surface_map(), nx=nx, ny=ny, hx=hx, hy=hy, heights=found.heights, periodic=int(bool(found.periodic)))
    return given(struct, trend=TRENDS.get(trend or "")), found  # the heights live as long as the surface


@short_traceback
def analyze(
    surface: Any, *, pitch: Optional[Pitch] = None, periodic: Optional[bool] = None, trend: Optional[str] = None
) -> Statistics:
    """Moments of the heights.

    surface: see the module; periodic: differences across the edges; None: as the surface says, else not
    trend: removed first: "mean", "plane", or "auto": the mean of periodic surfaces, else the plane
    """
    struct, kept = _map(surface, pitch, periodic, trend)
    out = rc_surface_statistics()
    _run("analyze", struct, out, keep=kept)
    return Statistics(**members_for(Statistics, out))


@short_traceback
def psd(
    surface: Any, *, pitch: Optional[Pitch] = None, periodic: Optional[bool] = None, trend: Optional[str] = None
) -> Spectrum:
    """Radial average of the PSD; surfaces that are not periodic get a Hann window. Arguments as in `analyze`."""
    struct, kept = _map(surface, pitch, periodic, trend)
    count = ctypes.c_int64()
    _run("psd", struct, None, None, None, count, keep=kept)
    q, power, modes = np.empty(count.value), np.empty(count.value), np.empty(count.value, np.int64)
    _run("psd", struct, pointer(q), pointer(power), pointer(modes), count, keep=kept)
    return Spectrum(q, power, modes)


@short_traceback
def power_law(
    surface: Any, *, pitch: Optional[Pitch] = None, periodic: Optional[bool] = None, trend: Optional[str] = None
) -> PowerLaw:
    """Hurst exponent, roll-off, cut-off and periodic textures. Arguments as in `analyze`."""
    struct, kept = _map(surface, pitch, periodic, trend)
    out = rc_surface_power_law()
    _run("fit", struct, out, keep=kept)
    peaks = np.array([out.peak_qx[: out.peaks], out.peak_qy[: out.peaks]]).T.reshape(out.peaks, 2)
    own = {"peak_q": peaks, "peak_share": np.array(out.peak_share[: out.peaks])}
    return PowerLaw(**{**members_for(PowerLaw, out), **own})


@short_traceback
def cmr_advice(
    surface: Any,
    levels: int,
    approach: float = 0.0,
    *,
    pitch: Optional[Pitch] = None,
    periodic: Optional[bool] = None,
    trend: Optional[str] = None,
) -> CmrAdvice:
    """Whether cascade multi-resolution with `levels` halvings of the grid can be trusted.

    approach: of the other body from the highest point [length], 0: (highest - mean)/2. Others as in `analyze`
    """
    struct, kept = _map(surface, pitch, periodic, trend)
    out = rc_surface_cmr()
    _run("cmr_advice", struct, as_int(levels, "levels", 32), approach, out, keep=kept)
    return CmrAdvice(**{**members_for(CmrAdvice, out), "trustworthy": bool(out.trustworthy)})


@short_traceback
def downsample(surface: Any, filter: str, *, pitch: Optional[Pitch] = None, mask: Optional[ArrayLike] = None) -> Surface:
    """Halves a grid: blocks of 2 x 2 points become one, the point at even indices ("subsample"), the mean, or the highest
    ("max").

    mask: 0 where a point is missing; a block that has none is missing in the outcome, with NaN for its height
    """
    if filter not in FILTERS:
        raise ArgumentError(f"filter is {filter!r}: {', '.join(FILTERS)}")
    fine = as_surface(surface, pitch, mask=mask)
    heights = as_doubles(fine.heights, "heights")
    nx, ny = columns_and_rows(fine.shape)
    coarse = tuple((n + 1) // 2 for n in fine.shape)
    if heights.size == 0:
        raise ShapeError(f"heights have shape {fine.shape}; at least one point is needed")
    out = np.empty(coarse)
    out_mask: Optional[Mask] = None if fine.mask is None else np.empty(coarse, np.uint8)
    _run("downsample", nx, ny, pointer(heights), pointer(fine.mask), FILTERS[filter], pointer(out), pointer(out_mask))
    pitches = (2 * fine.pitch[0], 2 * fine.pitch[1] if len(coarse) == 2 else fine.pitch[1])
    return Surface(out, pitches, fine.periodic, out_mask, fine.unit)

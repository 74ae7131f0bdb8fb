"""The structs of <roughcontact/surface.h>, member by member, with the values of the RC_..._INIT macros.

Written by scripts/bindings.py.
"""

from ctypes import c_char, c_double
from typing import Annotated, Any

from ._c import *  # noqa: F403
from ._constants import *  # noqa: F403


@struct
class rc_surface_rmd_spec(Sized):
    struct_size: size_t
    seed: uint64_t = 1
    levels: int32_t = 8
    additions: int32_t
    hurst: double = 0.7
    sigma: double = 1.0
    rms_height: double


@struct
class rc_surface_spectral_spec(Sized):
    struct_size: size_t
    seed: uint64_t = 1
    nx: int64_t = 256
    ny: int64_t = 256
    hx: double = 1.0
    hy: double = 1.0
    hurst: double = 0.8
    q_low: double
    q_rolloff: double
    q_high: double
    rms_height: double = 1.0
    rms_slope: double
    fixed_amplitudes: int32_t
    reserved: int32_t


@struct
class rc_surface_shape_spec(Sized):
    struct_size: size_t
    shape: int32_t = RC_SURFACE_PARABOLOID
    reserved: int32_t
    seed: uint64_t = 1
    nx: int64_t = 256
    ny: int64_t = 256
    hx: double = 1.0
    hy: double = 1.0
    radius: double = 1.0
    height: double = 1.0
    period_x: double
    period_y: double


@struct
class rc_surface_map(Sized):
    struct_size: size_t
    nx: int64_t = 1
    ny: int64_t = 1
    hx: double = 1.0
    hy: double = 1.0
    heights: doubles
    periodic: int32_t
    trend: int32_t = RC_SURFACE_TREND_AUTO


@struct
class rc_surface_statistics(Sized):
    struct_size: size_t
    rms_height: double
    skewness: double
    kurtosis: double
    highest: double
    lowest: double
    rms_slope: double
    rms_slope_x: double
    rms_slope_y: double
    rms_curvature: double
    m0: double
    m2: double
    m4: double
    nayak: double


@struct
class rc_surface_power_law(Sized):
    struct_size: size_t
    hurst: double
    hurst_error: double
    slope: double
    prefactor: double
    q_min: double
    q_max: double
    q_rolloff: double
    q_cutoff: double
    peaks: int64_t
    peak_qx: Annotated[Any, c_double * 4]
    peak_qy: Annotated[Any, c_double * 4]
    peak_share: Annotated[Any, c_double * 4]


@struct
class rc_surface_cmr(Sized):
    struct_size: size_t
    trustworthy: int32_t
    levels: int32_t
    safe_levels: int32_t
    reserved: int32_t
    unresolved: double
    limit: double
    unresolved_overall: double
    peak_loss: double
    approach: double
    coarsest_pitch: double
    reason: Annotated[bytes, c_char * 400]

"""The structs of <roughcontact/surface.h>, member by member, with the values of the RC_..._INIT macros.

Written by scripts/bindings.py.
"""

from ._c import *  # noqa: F403
from ._constants import *  # noqa: F403


@struct
class rc_surface_rmd_spec(Sized):
    members = """
    size_t struct_size; uint64_t seed=1; int32_t levels=8 additions; double hurst=0.7 sigma=1.0 rms_height
    """


@struct
class rc_surface_spectral_spec(Sized):
    members = """
    size_t struct_size; uint64_t seed=1; int64_t nx=256 ny=256;
    double hx=1.0 hy=1.0 hurst=0.8 q_low q_rolloff q_high rms_height=1.0 rms_slope; int32_t fixed_amplitudes reserved
    """


@struct
class rc_surface_shape_spec(Sized):
    members = """
    size_t struct_size; int32_t shape=RC_SURFACE_PARABOLOID reserved; uint64_t seed=1; int64_t nx=256 ny=256;
    double hx=1.0 hy=1.0 radius=1.0 height=1.0 period_x period_y
    """


@struct
class rc_surface_map(Sized):
    members = """
    size_t struct_size; int64_t nx=1 ny=1; double hx=1.0 hy=1.0; doubles heights; int32_t periodic trend=RC_SURFACE_TREND_AUTO
    """


@struct
class rc_surface_statistics(Sized):
    members = """
    size_t struct_size;
    double rms_height skewness kurtosis highest lowest rms_slope rms_slope_x rms_slope_y rms_curvature m0 m2 m4; double nayak
    """


@struct
class rc_surface_power_law(Sized):
    members = """
    size_t struct_size; double hurst hurst_error slope prefactor q_min q_max q_rolloff q_cutoff; int64_t peaks;
    double*4 peak_qx peak_qy peak_share
    """


@struct
class rc_surface_cmr(Sized):
    members = """
    size_t struct_size; int32_t trustworthy levels safe_levels reserved;
    double unresolved limit unresolved_overall peak_loss approach coarsest_pitch; char*400 reason
    """

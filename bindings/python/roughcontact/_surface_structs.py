"""The structs of <roughcontact/surface.h> for ctypes, member by member. Shapes and units: see the header."""

from ctypes import c_char, c_double, c_int32, c_int64, c_size_t, c_uint64

from ._constants import RC_SURFACE_PEAKS
from ._structs import Sized, doubles


class rc_surface_rmd_spec(Sized):
    _fields_ = [
        ("struct_size", c_size_t),
        ("seed", c_uint64),
        ("levels", c_int32),
        ("additions", c_int32),
        ("hurst", c_double),
        ("sigma", c_double),
        ("rms_height", c_double),
    ]


class rc_surface_spectral_spec(Sized):
    _fields_ = [
        ("struct_size", c_size_t),
        ("seed", c_uint64),
        ("nx", c_int64),
        ("ny", c_int64),
        ("hx", c_double),
        ("hy", c_double),
        ("hurst", c_double),
        ("q_low", c_double),
        ("q_rolloff", c_double),
        ("q_high", c_double),
        ("rms_height", c_double),
        ("rms_slope", c_double),
        ("fixed_amplitudes", c_int32),
        ("reserved", c_int32),
    ]


class rc_surface_shape_spec(Sized):
    _fields_ = [
        ("struct_size", c_size_t),
        ("shape", c_int32),
        ("reserved", c_int32),
        ("seed", c_uint64),
        ("nx", c_int64),
        ("ny", c_int64),
        ("hx", c_double),
        ("hy", c_double),
        ("radius", c_double),
        ("height", c_double),
        ("period_x", c_double),
        ("period_y", c_double),
    ]


class rc_surface_map(Sized):
    _fields_ = [
        ("struct_size", c_size_t),
        ("nx", c_int64),
        ("ny", c_int64),
        ("hx", c_double),
        ("hy", c_double),
        ("heights", doubles),
        ("periodic", c_int32),
        ("trend", c_int32),
    ]


class rc_surface_statistics(Sized):
    _fields_ = [
        ("struct_size", c_size_t),
        ("rms_height", c_double),
        ("skewness", c_double),
        ("kurtosis", c_double),
        ("highest", c_double),
        ("lowest", c_double),
        ("rms_slope", c_double),
        ("rms_slope_x", c_double),
        ("rms_slope_y", c_double),
        ("rms_curvature", c_double),
        ("m0", c_double),
        ("m2", c_double),
        ("m4", c_double),
        ("nayak", c_double),
    ]


class rc_surface_power_law(Sized):
    _fields_ = [
        ("struct_size", c_size_t),
        ("hurst", c_double),
        ("hurst_error", c_double),
        ("slope", c_double),
        ("prefactor", c_double),
        ("q_min", c_double),
        ("q_max", c_double),
        ("q_rolloff", c_double),
        ("q_cutoff", c_double),
        ("peaks", c_int64),
        ("peak_qx", c_double * RC_SURFACE_PEAKS),
        ("peak_qy", c_double * RC_SURFACE_PEAKS),
        ("peak_share", c_double * RC_SURFACE_PEAKS),
    ]


class rc_surface_cmr(Sized):
    _fields_ = [
        ("struct_size", c_size_t),
        ("trustworthy", c_int32),
        ("levels", c_int32),
        ("safe_levels", c_int32),
        ("reserved", c_int32),
        ("unresolved", c_double),
        ("limit", c_double),
        ("unresolved_overall", c_double),
        ("peak_loss", c_double),
        ("approach", c_double),
        ("coarsest_pitch", c_double),
        ("reason", c_char * 400),
    ]


SURFACE_STRUCTS = [
    rc_surface_rmd_spec,
    rc_surface_spectral_spec,
    rc_surface_shape_spec,
    rc_surface_map,
    rc_surface_statistics,
    rc_surface_power_law,
    rc_surface_cmr,
]

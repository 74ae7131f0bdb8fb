"""The structs of <roughcontact/roughcontact.h> for ctypes, member by member. Shapes and units: see the header."""

import ctypes
from ctypes import (
    CFUNCTYPE,
    POINTER,
    Structure,
    c_char,
    c_char_p,
    c_double,
    c_int32,
    c_int64,
    c_size_t,
    c_uint8,
    c_uint32,
    c_void_p,
)

doubles = POINTER(c_double)
integers = POINTER(c_int64)
bytes_ = POINTER(c_uint8)
statuses = POINTER(c_int32)


class Sized(Structure):
    """A struct whose first member is its size, set when it is made; the other members are zero."""

    struct_size: int

    def __init__(self) -> None:
        super().__init__()
        self.struct_size = ctypes.sizeof(self)


rc_apply_fn = CFUNCTYPE(c_int32, doubles, doubles, c_int64, c_void_p)


class rc_system(Sized):
    _fields_ = [
        ("struct_size", c_size_t),
        ("op", c_int32),
        ("boundary", c_int32),
        ("nx", c_int64),
        ("ny", c_int64),
        ("hx", c_double),
        ("hy", c_double),
        ("modulus", c_double),
        ("dense", doubles),
        ("dense_ld", c_int64),
        ("apply", rc_apply_fn),
        ("user", c_void_p),
    ]


class rc_step(Sized):
    _fields_ = [
        ("struct_size", c_size_t),
        ("control", c_int32),
        ("warm_start", c_int32),
        ("target", c_double),
        ("gap", doubles),
        ("p0", doubles),
        ("mask", bytes_),
        ("borrow", c_int32),
        ("reserved", c_int32),
    ]


class rc_result(Sized):
    _fields_ = [
        ("struct_size", c_size_t),
        ("p", doubles),
        ("gap", doubles),
        ("status", c_int32),
        ("reserved", c_int32),
        ("iterations", c_int64),
        ("applications", c_int64),
        ("points", c_int64),
        ("candidates", c_int64),
        ("modelled", c_int64),
        ("contacts", c_int64),
        ("load", c_double),
        ("displacement", c_double),
        ("mean_pressure", c_double),
        ("contact_area", c_double),
        ("energy", c_double),
        ("stiffness", c_double),
        ("kkt_primal", c_double),
        ("kkt_dual", c_double),
        ("kkt_complementarity", c_double),
        ("kkt_control", c_double),
        ("seconds", c_double),
        ("setup_seconds", c_double),
        ("solver", c_char * 32),
        ("backend", c_char * 32),
        ("kernel", c_char * 32),
        ("note", c_char * 160),
        ("duality_gap", c_double),
        ("load_lower", c_double),
        ("load_upper", c_double),
        ("area_lower", c_double),
        ("area_upper", c_double),
        ("proven_contacts", c_int64),
        ("proven_open", c_int64),
        ("undecided", c_int64),
        ("levels", c_int64),
        ("tolerance", c_double),
        ("model_nx", c_int64),
        ("model_ny", c_int64),
        ("error_estimate", c_double),
        ("left_out", c_double),
        ("area_estimate", c_double),
    ]


class rc_level(Sized):
    _fields_ = [
        ("struct_size", c_size_t),
        ("p", doubles),
        ("status", c_int32),
        ("reserved", c_int32),
        ("nx", c_int64),
        ("ny", c_int64),
        ("hx", c_double),
        ("hy", c_double),
        ("displacement", c_double),
        ("load", c_double),
        ("candidates", c_int64),
        ("contacts", c_int64),
    ]


rc_path_fn = CFUNCTYPE(c_int32, c_int64, POINTER(rc_result), c_void_p)


class rc_state(Sized):
    _fields_ = [
        ("struct_size", c_size_t),
        ("gap", doubles),
        ("mask", bytes_),
        ("p", doubles),
        ("displacement", c_double),
        ("load", c_double),
        ("p_before", doubles),
        ("displacement_before", c_double),
        ("load_before", c_double),
    ]


class rc_path(Sized):
    _fields_ = [
        ("struct_size", c_size_t),
        ("control", c_int32),
        ("warm_start", c_int32),
        ("n", c_int64),
        ("targets", doubles),
        ("gap", doubles),
        ("mask", bytes_),
        ("load", doubles),
        ("displacement", doubles),
        ("contact_area", doubles),
        ("stiffness", doubles),
        ("certificate", doubles),
        ("applications", integers),
        ("fn", rc_path_fn),
        ("user", c_void_p),
        ("completed", c_int64),
    ]


rc_batch_fn = CFUNCTYPE(c_int32, c_int64, c_int64, POINTER(rc_result), c_void_p)


class rc_batch(Sized):
    _fields_ = [
        ("struct_size", c_size_t),
        ("control", c_int32),
        ("warm_start", c_int32),
        ("n", c_int64),
        ("steps", c_int64),
        ("targets", doubles),
        ("target_stride", c_int64),
        ("gap", doubles),
        ("gap_stride", c_int64),
        ("mask", bytes_),
        ("mask_stride", c_int64),
        ("p0", doubles),
        ("p", doubles),
        ("load", doubles),
        ("displacement", doubles),
        ("contact_area", doubles),
        ("stiffness", doubles),
        ("certificate", doubles),
        ("status", statuses),
        ("iterations", integers),
        ("applications", integers),
        ("fn", rc_batch_fn),
        ("user", c_void_p),
        ("written", c_int64),
        ("certified", c_int64),
        ("first", c_int64),
    ]


class rc_direct(Sized):
    _fields_ = [
        ("struct_size", c_size_t),
        ("status", c_int32),
        ("reserved", c_int32),
        ("iterations", c_int64),
        ("applications", c_int64),
        ("contacts", c_int64),
        ("load", c_double),
        ("energy", c_double),
        ("kkt", c_double),
        ("duality_gap", c_double),
        ("load_lower", c_double),
        ("load_upper", c_double),
        ("note", c_char * 160),
    ]


class rc_area(Sized):
    _fields_ = [
        ("struct_size", c_size_t),
        ("contacts", c_int64),
        ("area", c_double),
        ("perimeter", c_double),
        ("corrected_area", c_double),
    ]


class rc_patches(Sized):
    _fields_ = [
        ("struct_size", c_size_t),
        ("neighbours", c_int32),
        ("reserved", c_int32),
        ("room", c_int64),
        ("label", integers),
        ("cells", integers),
        ("area", doubles),
        ("perimeter", doubles),
        ("load", doubles),
        ("mean_pressure", doubles),
        ("max_pressure", doubles),
        ("peak", integers),
        ("count", c_int64),
    ]


class rc_histogram(Sized):
    _fields_ = [
        ("struct_size", c_size_t),
        ("bins", c_int64),
        ("upper", c_double),
        ("counts", integers),
        ("density", doubles),
        ("width", c_double),
        ("contacts", c_int64),
        ("above", c_int64),
        ("mean_pressure", c_double),
        ("max_pressure", c_double),
    ]


class rc_progress(Sized):
    _fields_ = [
        ("struct_size", c_size_t),
        ("iteration", c_int64),
        ("applications", c_int64),
        ("kkt", c_double),
        ("seconds", c_double),
    ]


rc_progress_fn = CFUNCTYPE(c_int32, POINTER(rc_progress), c_void_p)
rc_log_fn = CFUNCTYPE(None, c_int32, c_char_p, c_void_p)


class rc_context_config(Sized):
    _fields_ = [
        ("struct_size", c_size_t),
        ("flags", c_uint32),
        ("reserved", c_uint32),
        ("plugin_path", c_char_p),
        ("log", rc_log_fn),
        ("log_user", c_void_p),
    ]


class rc_component(Sized):
    _fields_ = [
        ("struct_size", c_size_t),
        ("name", c_char_p),
        ("summary", c_char_p),
        ("license", c_char_p),
        ("origin", c_char_p),
    ]


class rc_option_spec(Sized):
    _fields_ = [
        ("struct_size", c_size_t),
        ("key", c_char_p),
        ("default_value", c_char_p),
        ("choices", c_char_p),
        ("help", c_char_p),
        ("type", c_int32),
        ("fixed", c_int32),
        ("minimum", c_double),
        ("maximum", c_double),
    ]


STRUCTS = [
    rc_system,
    rc_step,
    rc_result,
    rc_level,
    rc_state,
    rc_path,
    rc_batch,
    rc_direct,
    rc_area,
    rc_patches,
    rc_histogram,
    rc_progress,
    rc_context_config,
    rc_component,
    rc_option_spec,
]
CALLBACKS = [rc_path_fn, rc_batch_fn, rc_progress_fn, rc_log_fn]

"""The structs of the headers but surface.h and plugin.h, member by member, with the values of the RC_..._INIT macros.

Written by scripts/bindings.py.
"""

from ctypes import c_char
from typing import Annotated, Any

from ._c import *  # noqa: F403
from ._constants import *  # noqa: F403

rc_apply_fn = callback(int32_t, doubles, doubles, int64_t, handle)


@struct
class rc_system(Sized):
    struct_size: size_t
    op: int32_t = RC_OPERATOR_HALFSPACE
    boundary: int32_t = RC_BOUNDARY_FREE
    nx: int64_t
    ny: int64_t
    hx: double
    hy: double
    modulus: double
    dense: doubles
    dense_ld: int64_t
    apply: Annotated[Any, rc_apply_fn]
    user: handle


@struct
class rc_step(Sized):
    struct_size: size_t
    control: int32_t
    warm_start: int32_t = 1
    target: double
    undeformed_gap: doubles
    p0: doubles
    mask: bytes_
    borrow: int32_t
    reserved: int32_t


@struct
class rc_result(Sized):
    struct_size: size_t
    p: doubles
    gap: doubles
    status: rc_status = RC_ERR_ARGUMENT
    reserved: int32_t
    iterations: int64_t
    applications: int64_t
    points: int64_t
    candidates: int64_t
    modelled: int64_t
    contacts: int64_t
    load: double
    approach: double
    mean_pressure: double
    contact_area: double
    energy: double
    stiffness: double
    kkt_primal: double
    kkt_dual: double
    kkt_complementarity: double
    kkt_control: double
    seconds: double
    setup_seconds: double
    solver: Annotated[bytes, c_char * 32]
    backend: Annotated[bytes, c_char * 32]
    kernel: Annotated[bytes, c_char * 32]
    note: Annotated[bytes, c_char * 160]
    duality_gap: double
    load_lower: double
    load_upper: double
    area_lower: double
    area_upper: double
    proven_contacts: int64_t
    proven_open: int64_t
    undecided: int64_t
    levels: int64_t
    tolerance: double


@struct
class rc_accuracy(Sized):
    struct_size: size_t
    model_nx: int64_t
    model_ny: int64_t
    error_estimate: double
    area_estimate: double
    left_out: double


@struct
class rc_progress(Sized):
    struct_size: size_t
    iteration: int64_t
    applications: int64_t
    kkt: double
    seconds: double


rc_progress_fn = callback(int32_t, rc_progress, handle)


rc_path_fn = callback(int32_t, int64_t, rc_result, handle)


@struct
class rc_path(Sized):
    struct_size: size_t
    control: int32_t
    warm_start: int32_t = 1
    n: int64_t
    targets: doubles
    undeformed_gap: doubles
    mask: bytes_
    load: doubles
    approach: doubles
    contact_area: doubles
    stiffness: doubles
    certificate: doubles
    applications: integers
    fn: Annotated[Any, rc_path_fn]
    user: handle
    completed: int64_t


@struct
class rc_state(Sized):
    struct_size: size_t
    undeformed_gap: doubles
    mask: bytes_
    p: doubles
    approach: double
    load: double
    p_before: doubles
    approach_before: double
    load_before: double


rc_batch_fn = callback(int32_t, int64_t, int64_t, rc_result, handle)


@struct
class rc_batch(Sized):
    struct_size: size_t
    control: int32_t
    warm_start: int32_t = 1
    n: int64_t
    steps: int64_t
    targets: doubles
    target_stride: int64_t
    undeformed_gap: doubles
    undeformed_gap_stride: int64_t
    mask: bytes_
    mask_stride: int64_t
    p0: doubles
    p: doubles
    load: doubles
    approach: doubles
    contact_area: doubles
    stiffness: doubles
    certificate: doubles
    status: statuses
    iterations: integers
    applications: integers
    fn: Annotated[Any, rc_batch_fn]
    user: handle
    written: int64_t
    certified: int64_t
    first: int64_t = -1


@struct
class rc_level(Sized):
    struct_size: size_t
    p: doubles
    status: rc_status = RC_ERR_ARGUMENT
    reserved: int32_t
    nx: int64_t
    ny: int64_t
    hx: double
    hy: double
    approach: double
    load: double
    candidates: int64_t
    contacts: int64_t


@struct
class rc_direct(Sized):
    struct_size: size_t
    status: rc_status = RC_ERR_ARGUMENT
    reserved: int32_t
    iterations: int64_t
    applications: int64_t
    contacts: int64_t
    load: double
    energy: double
    kkt: double
    duality_gap: double
    load_lower: double
    load_upper: double
    note: Annotated[bytes, c_char * 160]


@struct
class rc_area(Sized):
    struct_size: size_t
    contacts: int64_t
    area: double
    perimeter: double
    corrected_area: double


@struct
class rc_patches(Sized):
    struct_size: size_t
    neighbours: int32_t = 4
    reserved: int32_t
    room: int64_t
    label: integers
    cells: integers
    area: doubles
    perimeter: doubles
    load: doubles
    mean_pressure: doubles
    max_pressure: doubles
    peak: integers
    count: int64_t


@struct
class rc_histogram(Sized):
    struct_size: size_t
    bins: int64_t
    upper: double
    counts: integers
    density: doubles
    width: double
    contacts: int64_t
    above: int64_t
    mean_pressure: double
    max_pressure: double


rc_log_fn = callback(None, int32_t, text, handle)


@struct
class rc_context_config(Sized):
    struct_size: size_t
    flags: uint32_t
    reserved: uint32_t
    plugin_path: text
    log: Annotated[Any, rc_log_fn]
    log_user: handle


@struct
class rc_component(Sized):
    struct_size: size_t
    name: text
    summary: text
    license: text
    origin: text


@struct
class rc_option_spec(Sized):
    struct_size: size_t
    key: text
    default_value: text
    choices: text
    help: text
    type: int32_t
    fixed: int32_t
    minimum: double
    maximum: double

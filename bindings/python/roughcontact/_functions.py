"""The functions of the headers.

Written by scripts/bindings.py.
"""

from typing import Annotated, Any, Callable, Protocol

from ._c import *  # noqa: F403
from ._structs import *  # noqa: F403

array_in = Annotated[Any, rc_const_array]
array_out = Annotated[Any, rc_array]
rc_greedy_like = Callable[[int64_t, doubles, int64_t, doubles, doubles, doubles, double, int64_t, rc_direct], rc_status]


class ContactFunctions(Protocol):
    """libroughcontact"""

    rc_status_name: Callable[[rc_status], text]
    rc_status_text: Callable[[rc_status], text]
    rc_last_error: Callable[[], text]
    rc_stop_when: Callable[[statuses], None]
    rc_file_write: Callable[[text, handle, size_t], rc_status]
    rc_version: Callable[[statuses, statuses, statuses, statuses], None]
    rc_gap_from_heights: Callable[[int64_t, array_in, array_in, array_out], rc_status]
    rc_options_create: Callable[[handle, handles], rc_status]
    rc_options_copy: Callable[[handle, handles], rc_status]
    rc_options_destroy: Callable[[handle], None]
    rc_options_set_number: Callable[[handle, text, double], rc_status]
    rc_options_set_text: Callable[[handle, text, text], rc_status]
    rc_options_get_number: Callable[[handle, text, doubles], rc_status]
    rc_options_get_text: Callable[[handle, text, texts], rc_status]
    rc_solve: Callable[[rc_system, rc_step, handle, rc_result], rc_status]
    rc_contact_create: Callable[[rc_system, handle, handles], rc_status]
    rc_contact_destroy: Callable[[handle], None]
    rc_contact_cancel: Callable[[handle], None]
    rc_contact_solve: Callable[[handle, rc_step, rc_result], rc_status]
    rc_contact_certify: Callable[[handle, rc_step, rc_result], rc_status]
    rc_contact_points: Callable[[handle, int64_t, array_out, array_out, integers], rc_status]
    rc_contact_set_options: Callable[[handle, handle], rc_status]
    rc_contact_on_progress: Callable[[handle, Annotated[Any, rc_progress_fn], handle, int64_t], rc_status]
    rc_contact_explain: Callable[[handle, texts], rc_status]
    rc_contact_reset: Callable[[handle], rc_status]
    rc_contact_solve_history: Callable[[handle, rc_history], rc_status]
    rc_contact_indentation: Callable[[handle, array_out], rc_status]
    rc_contact_creep: Callable[[handle, array_out, doubles], rc_status]
    rc_contact_restore: Callable[[handle, rc_state], rc_status]
    rc_batch_solve: Callable[[rc_system, handle, rc_batch], rc_status]
    rc_contact_level: Callable[[handle, int64_t, rc_level], rc_status]
    rc_contact_gradient: Callable[[handle, rc_gradient], rc_status]
    rc_contact_tangent: Callable[[handle, rc_tangent], rc_status]
    rc_greedy: rc_greedy_like
    rc_polonsky_keer: rc_greedy_like
    rc_nnls: rc_greedy_like
    rc_gp: rc_greedy_like
    rc_admm: rc_greedy_like
    rc_cmr: Callable[
        [int64_t, int64_t, double, double, double, doubles, double, int64_t, double, text, doubles, rc_direct], rc_status
    ]
    rc_product_create: Callable[[rc_system, handle, handles], rc_status]
    rc_product_destroy: Callable[[handle], None]
    rc_product_apply: Callable[[handle, array_in, array_out], rc_status]
    rc_area_measure: Callable[[rc_system, array_in, array_in, rc_area], rc_status]
    rc_patches_find: Callable[[rc_system, array_in, array_in, rc_patches], rc_status]
    rc_histogram_fill: Callable[[rc_system, array_in, array_in, rc_histogram], rc_status]
    rc_crossing_find: Callable[[rc_system, array_in, array_in, statuses, statuses], rc_status]
    rc_conductance: Callable[[rc_system, rc_result, double, double, doubles, doubles, doubles], rc_status]
    rc_punch_stiffness: Callable[[rc_system, array_in, handle, doubles, doubles, doubles], rc_status]
    rc_law_create: Callable[[rc_system, handle, rc_law_spec, handles], rc_status]
    rc_law_destroy: Callable[[handle], None]
    rc_law_describe: Callable[[handle, rc_law_info], rc_status]
    rc_law_describe_node: Callable[[handle, int64_t, rc_law_point], rc_status]
    rc_law_pressure: Callable[[handle, double, doubles, doubles, doubles], rc_status]
    rc_law_pressures: Callable[[handle, int64_t, array_in, array_out, array_out, array_out], rc_status]
    rc_law_overclosure: Callable[[handle, double, doubles], rc_status]
    rc_law_gap_conductance: Callable[[handle, double, double, double, doubles], rc_status]
    rc_law_evaluate: Callable[[handle, double, rc_law_point], rc_status]
    rc_law_slip: Callable[[handle, rc_law_slip_state, double, doubles, rc_law_slip_state], rc_status]
    rc_law_slip_bounds: Callable[[handle, rc_law_slip_state, doubles, doubles], rc_status]
    rc_law_save: Callable[[handle, text], rc_status]
    rc_law_load: Callable[[text, handles], rc_status]
    rc_law_export: Callable[[handle, text, rc_law_export_spec], rc_status]
    rc_law_open: Callable[[text, text, handles], rc_status]
    rc_context_create: Callable[[uint32_t, text, Annotated[Any, rc_log_fn], handle, handles], rc_status]
    rc_context_destroy: Callable[[handle], None]
    rc_component_count: Callable[[handle, int32_t], int64_t]
    rc_component_describe: Callable[[handle, int32_t, int64_t, rc_component], rc_status]
    rc_pair_supported: Callable[[handle, text, text, rc_system, int32_t, handle], rc_status]
    rc_kernel_coefficients: Callable[[text, double, double, int64_t, int64_t, doubles], rc_status]
    rc_usable_cores: Callable[[int64_t], int64_t]
    rc_context_register: Callable[[handle, handle], rc_status]


class SurfaceFunctions(Protocol):
    """libroughcontact-surface"""

    rc_surface_last_error: Callable[[], text]
    rc_surface_stop_when: Callable[[statuses], None]
    rc_surface_rmd: Callable[[rc_surface_rmd_spec, int32_t, int32_t, doubles], rc_status]
    rc_surface_spectral: Callable[[rc_surface_spectral_spec, doubles], rc_status]
    rc_surface_shape: Callable[[rc_surface_shape_spec, doubles], rc_status]
    rc_surface_analyze: Callable[[rc_surface_map, rc_surface_statistics], rc_status]
    rc_surface_psd: Callable[[rc_surface_map, doubles, doubles, integers, integers], rc_status]
    rc_surface_fit: Callable[[rc_surface_map, rc_surface_power_law], rc_status]
    rc_surface_cmr_advice: Callable[[rc_surface_map, int32_t, double, rc_surface_cmr], rc_status]
    rc_surface_downsample: Callable[[int64_t, int64_t, doubles, bytes_, int32_t, doubles, bytes_], rc_status]


class FormatsFunctions(Protocol):
    """libroughcontact-formats"""

    rc_surface_read_last_error: Callable[[], text]
    rc_surface_read: Callable[[text, rc_surface_read_spec, rc_surface_file], rc_status]
    rc_surface_read_memory: Callable[[handle, size_t, text, rc_surface_read_spec, rc_surface_file], rc_status]
    rc_surface_file_free: Callable[[rc_surface_file], None]
    rc_surface_unit: Callable[[text, doubles], rc_status]
    rc_surface_format_count: Callable[[], int64_t]
    rc_surface_format_describe: Callable[[int64_t, rc_surface_format], rc_status]
    rc_surface_remove_form: Callable[[int64_t, int64_t, int32_t, doubles], rc_status]
    rc_surface_fill: Callable[[int64_t, int64_t, double, double, doubles], rc_status]
    rc_surface_despike: Callable[[int64_t, int64_t, double, doubles, integers, doubles], rc_status]
    rc_surface_crop: Callable[[integers, integers, double, double, double, double, double, double, doubles], rc_status]
    rc_surface_mirror: Callable[[int64_t, int64_t, int32_t, doubles], rc_status]
    rc_surface_resample: Callable[[rc_surface_resampling], rc_status]
    rc_surface_shift: Callable[
        [int64_t, int64_t, double, double, double, double, int32_t, int32_t, doubles, integers], rc_status
    ]


class FlowFunctions(Protocol):
    """libroughcontact-flow"""

    rc_flow_last_error: Callable[[], text]
    rc_flow_stop_when: Callable[[statuses], None]
    rc_flow_solve: Callable[[rc_flow_spec, rc_flow_result], rc_status]
    rc_flow_of_result: Callable[[rc_system, handle, rc_result, rc_flow_spec, rc_flow_result], rc_status]
    rc_flow_factors_find: Callable[[rc_flow_spec, rc_flow_factors], rc_status]
    rc_flow_closing_pressure: Callable[[rc_system, handle, rc_step, rc_flow_spec, rc_flow_closing], rc_status]


class RequestFunctions(Protocol):
    """libroughcontact-request"""

    rc_request_last_error: Callable[[], text]
    rc_word_count: Callable[[], int64_t]
    rc_word_describe: Callable[[int64_t, rc_word], rc_status]
    rc_request_create: Callable[[rc_request_spec, handles], rc_status]
    rc_request_destroy: Callable[[handle], None]
    rc_request_problem: Callable[[handle, rc_problem_view], rc_status]
    rc_request_option_count: Callable[[handle], int64_t]
    rc_request_remark_count: Callable[[handle], int64_t]
    rc_request_option: Callable[[handle, int64_t, texts, texts], rc_status]
    rc_request_options: Callable[[handle, handle], rc_status]
    rc_request_remark: Callable[[handle, int64_t, rc_remark], rc_status]
    rc_request_note: Callable[[handle, text, double, size_t, text], rc_status]
    rc_request_smooth: Callable[[handle, double, rc_smooth], rc_status]
    rc_budget_create: Callable[[rc_request_spec, rc_budget_spec, handles], rc_status]
    rc_budget_destroy: Callable[[handle], None]
    rc_budget_quantity_count: Callable[[handle], int64_t]
    rc_budget_source_count: Callable[[handle], int64_t]
    rc_budget_get_quantity: Callable[[handle, int64_t, rc_budget_quantity], rc_status]
    rc_budget_get_contribution: Callable[[handle, int64_t, int64_t, rc_budget_contribution], rc_status]


class MpiFunctions(Protocol):
    """libroughcontact-mpi"""

    rc_ranks_rows: Callable[[rc_exchange, rc_system, integers, integers], rc_status]
    rc_ranks_contact_create: Callable[[rc_exchange, rc_system, handle, handles], rc_status]
    rc_ranks_contact_counts: Callable[[handle, rc_ranks_counts], rc_status]
    rc_mpi_exchange_create_f: Callable[[int32_t, rc_exchange], rc_status]
    rc_mpi_exchange_destroy: Callable[[rc_exchange], None]

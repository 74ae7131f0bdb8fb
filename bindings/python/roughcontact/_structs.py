"""The structs of the headers, member by member, with the values of the RC_..._INIT macros.

Written by scripts/bindings.py.
"""

from ._c import *  # noqa: F403
from ._constants import *  # noqa: F403


@struct
class rc_array(Sized):
    members = "handle data; int32_t type reserved; text memory"


@struct
class rc_const_array(Sized):
    members = "handle data; int32_t type reserved; text memory"


rc_apply_fn = callback(int32_t, doubles, doubles, int64_t, handle)


@struct
class rc_system(Sized):
    members = """size_t struct_size; int32_t op=RC_OPERATOR_HALFSPACE boundary; int64_t nx ny; double hx hy modulus;
    doubles dense; int64_t dense_ld; rc_apply_fn apply; handle user; double hardness;
    int32_t creep_by creep_terms; rc_const_array creep_ratio creep_time"""


@struct
class rc_step(Sized):
    members = """size_t struct_size; int32_t control warm_start=1; double target; rc_const_array undeformed_gap mask p0;
    int32_t borrow reserved; double time"""


@struct
class rc_result(Sized):
    members = """size_t struct_size; rc_array p gap; rc_status status=RC_ERR_ARGUMENT; int32_t homogeneous;
    double load approach mean_pressure max_pressure contact_area area_fraction mean_gap energy; int64_t contacts;
    double kkt_primal kkt_dual kkt_complementarity kkt_control tolerance duality_gap gap_error load_lower;
    double load_upper area_lower area_upper; int64_t proven_contacts proven_open undecided;
    double stiffness stiffness_lower stiffness_upper punch_stiffness; int64_t capped; double plastic_volume;
    int64_t proven_capped model_nx model_ny; double error_estimate area_estimate left_out;
    int64_t points candidates modelled iterations products levels; double seconds setup_seconds;
    char*32 solver backend kernel; char*512 note"""


@struct
class rc_progress(Sized):
    members = "size_t struct_size; int64_t iteration products; double kkt seconds"


rc_progress_fn = callback(int32_t, rc_progress, handle)


rc_history_fn = callback(int32_t, int64_t, rc_result, handle)


@struct
class rc_columns(Sized):
    members = """rc_array load approach contact_area mean_gap energy stiffness load_lower load_upper area_lower area_upper;
    rc_array stiffness_lower stiffness_upper certificate iterations products status"""


@struct
class rc_history(Sized):
    members = """size_t struct_size; int32_t control warm_start=1; int64_t n; rc_const_array targets undeformed_gap mask;
    rc_history_fn fn; handle user; int64_t completed; int32_t want_gap=1 virgin; rc_columns columns;
    rc_const_array times"""


@struct
class rc_state(Sized):
    members = """size_t struct_size; rc_const_array undeformed_gap mask p; double approach load; rc_const_array p_before;
    double approach_before load_before; rc_const_array indentation creep; double time"""


rc_batch_fn = callback(int32_t, int64_t, int64_t, rc_result, handle)


rc_batch_progress_fn = callback(int32_t, int64_t, handle)


@struct
class rc_batch(Sized):
    members = """size_t struct_size; int32_t control warm_start=1; int64_t n steps; rc_const_array targets;
    int64_t target_stride; rc_const_array undeformed_gap; int64_t undeformed_gap_stride; rc_const_array mask;
    int64_t mask_stride; rc_const_array p0; rc_array p; rc_batch_fn fn; handle user;
    int64_t written certified first=-1; rc_batch_progress_fn progress; int32_t virgin reserved;
    rc_columns columns; rc_const_array times"""


@struct
class rc_level(Sized):
    members = """size_t struct_size; rc_array p; rc_status status=RC_ERR_ARGUMENT; int32_t reserved; int64_t nx ny;
    double hx hy approach load; int64_t candidates contacts"""


@struct
class rc_gradient(Sized):
    members = """size_t struct_size; rc_const_array dJ_dp dJ_dgap; double dJ_dload dJ_dapproach; rc_array dJ_dundeformed_gap;
    double dJ_dtarget dJ_dmodulus error; int64_t undecided products"""


@struct
class rc_tangent(Sized):
    members = """size_t struct_size; rc_const_array dundeformed_gap; double dtarget dmodulus; rc_array dp dgap;
    double dload dapproach error; int64_t undecided products"""


@struct
class rc_direct(Sized):
    members = """size_t struct_size; rc_status status=RC_ERR_ARGUMENT; int32_t reserved; int64_t iterations products contacts;
    double load energy kkt duality_gap load_lower load_upper; char*512 note"""


@struct
class rc_area(Sized):
    members = "size_t struct_size; int64_t contacts; double area perimeter corrected_area"


@struct
class rc_patches(Sized):
    members = """size_t struct_size; int32_t neighbours=4 reserved; int64_t room;
    rc_array label cells area perimeter load mean_pressure max_pressure peak; int64_t count"""


@struct
class rc_histogram(Sized):
    members = """size_t struct_size; int64_t bins; double upper; rc_array counts density; double width;
    int64_t contacts above; double mean_pressure max_pressure"""


@struct
class rc_law_spec(Sized):
    members = """size_t struct_size; rc_const_array undeformed_gap mask;
    double area p_lower p_upper tolerance=0.001 tolerance_conductance; int32_t bulk reserved;
    double bulk_stiffness; int64_t max_nodes; rc_progress_fn progress; handle user"""


@struct
class rc_law_info(Sized):
    members = """size_t struct_size; int64_t nodes solves; double seconds; int32_t bounds bulk;
    double width width_conductance width_area energy_error modulus hardness area bulk_stiffness mean_gap;
    double x_lower x_upper p_lower p_upper"""


@struct
class rc_law_point(Sized):
    members = """size_t struct_size;
    double x p p_lower p_upper slope slope_lower slope_upper energy area_fraction area_lower area_upper;
    double conductance conductance_lower conductance_upper between_lower between_upper; int32_t bounds reserved"""


@struct
class rc_law_slip_state(Sized):
    members = """size_t struct_size; double mu nu p slope; double*2 shear shear_by_x; double*4 shear_by_slip;
    double dissipated joined; double*64 memory"""


@struct
class rc_law_export_spec(Sized):
    members = "size_t struct_size; int32_t format reserved; int64_t rows; double rho1 rho2 length force beyond error mu nu"


rc_log_fn = callback(None, int32_t, text, handle)


@struct
class rc_component(Sized):
    members = """size_t struct_size; text name summary license origin default_value choices; int32_t type fixed;
    double minimum maximum"""


@struct
class rc_surface_rmd_spec(Sized):
    members = "size_t struct_size; uint64_t seed=1; int32_t levels=8 additions; double hurst=0.7 sigma=1.0 rms_height"


@struct
class rc_surface_spectral_spec(Sized):
    members = """size_t struct_size; uint64_t seed=1; int64_t nx=256 ny=256;
    double hx=1.0 hy=1.0 hurst=0.8 q_low q_rolloff q_high rms_height=1.0 rms_slope;
    int32_t fixed_amplitudes reserved"""


@struct
class rc_surface_shape_spec(Sized):
    members = """size_t struct_size; int32_t shape=RC_SURFACE_PARABOLOID reserved; uint64_t seed=1; int64_t nx=256 ny=256;
    double hx=1.0 hy=1.0 radius=1.0 height=1.0 period_x period_y"""


@struct
class rc_surface_map(Sized):
    members = """size_t struct_size; int64_t nx=1 ny=1; double hx=1.0 hy=1.0; doubles heights;
    int32_t periodic trend=RC_SURFACE_TREND_AUTO"""


@struct
class rc_surface_statistics(Sized):
    members = """size_t struct_size;
    double rms_height skewness kurtosis highest lowest rms_slope rms_slope_x rms_slope_y rms_curvature m0 m2 m4;
    double nayak"""


@struct
class rc_surface_power_law(Sized):
    members = """size_t struct_size; double hurst hurst_error slope prefactor q_min q_max q_rolloff q_cutoff; int64_t peaks;
    double*4 peak_qx peak_qy peak_share"""


@struct
class rc_surface_cmr(Sized):
    members = """size_t struct_size; int32_t trustworthy levels safe_levels reserved;
    double unresolved limit unresolved_overall peak_loss approach coarsest_pitch; char*400 reason"""


@struct
class rc_surface_read_spec(Sized):
    members = "size_t struct_size; text format unit; double hx hy height_range"


@struct
class rc_surface_file(Sized):
    members = """size_t struct_size; int64_t nx ny; double hx hy; doubles heights; int64_t missing;
    int32_t periodic=-1 unit_assumed; char*32 format; char*400 assumed; handle storage; double full_scale"""


@struct
class rc_surface_format(Sized):
    members = "size_t struct_size; text name summary suffixes says; int32_t by_contents reserved"


@struct
class rc_surface_resampling(Sized):
    members = """size_t struct_size; int64_t nx ny; double hx hy; doubles heights;
    int32_t periodic interpolation=RC_SURFACE_CUBIC; int64_t to_nx to_ny; double to_hx to_hy x0 y0; doubles to;
    int64_t missing"""


@struct
class rc_flow_spec(Sized):
    members = """size_t struct_size; int32_t along=RC_FLOW_X sides; double viscosity pressure_drop width=0.01 memory;
    int64_t nx ny; double hx hy; rc_const_array gap gap_error mask; double load; rc_array potential"""


@struct
class rc_flow_result(Sized):
    members = """size_t struct_size; rc_status status=RC_ERR_ARGUMENT; int32_t crosses iterations reserved;
    double flow lower upper constriction; int64_t constriction_x constriction_y;
    double gap_error dropped seconds"""


@struct
class rc_flow_factors(Sized):
    members = """size_t struct_size; rc_status status=RC_ERR_ARGUMENT; int32_t reserved;
    double xx xy yy xx_lower xx_upper xy_lower xy_upper yy_lower yy_upper mean_gap seconds"""


@struct
class rc_flow_closing(Sized):
    members = """size_t struct_size; rc_status status=RC_ERR_ARGUMENT; int32_t steps;
    double lower upper area_fraction constriction seconds"""


@struct
class rc_word(Sized):
    members = "size_t struct_size; text name group form help choices example why_not; int32_t kind most calls reserved"


@struct
class rc_given(Sized):
    members = "text word text; doubles numbers; int64_t n"


@struct
class rc_map(Sized):
    members = """size_t struct_size; text word; doubles heights; bytes_ mask; int64_t nx ny maps; double hx hy; text unit;
    handle contents; size_t size; text name; int32_t periodic=-1 rounded"""


@struct
class rc_request_spec(Sized):
    members = """size_t struct_size; int32_t call numbers spelling reserved; handle words; int64_t n_words; handle maps;
    int64_t n_maps; handle system context"""


@struct
class rc_problem_view(Sized):
    members = """size_t struct_size; rc_system system; doubles heights; bytes_ mask; int64_t maps missing; text loading;
    doubles targets; int64_t n; double metres; int32_t si periodic; text format; double viscosity pressure_drop;
    int32_t along reserved; doubles times; int64_t n_times"""


@struct
class rc_remark(Sized):
    members = "size_t struct_size; int32_t code severity; text word text; double*3 number"


@struct
class rc_smooth(Sized):
    members = "size_t struct_size; double width side max_pressure approach; char*160 remark"


rc_budget_progress_fn = callback(int32_t, int64_t, int64_t, handle)


rc_budget_value_fn = callback(int32_t, rc_system, rc_result, bytes_, handle, doubles, doubles, doubles)


@struct
class rc_budget_spec(Sized):
    members = """size_t struct_size; text sources; handle options; rc_budget_progress_fn progress; handle user;
    rc_budget_value_fn value; text value_name value_unit"""


@struct
class rc_budget_quantity(Sized):
    members = "size_t struct_size; text name unit sentence; double value standard freedom coverage; int64_t dominant"


@struct
class rc_budget_contribution(Sized):
    members = "size_t struct_size; text source given; double standard shift first_order sampled share; int64_t solves"


rc_gather_fn = callback(text, handle, handle, integers, handle)


rc_transpose_fn = callback(text, handle, handle, integers, handle, integers)


rc_shift_fn = callback(text, handle, int64_t, handle, int64_t, int64_t, handle, int64_t)


@struct
class rc_exchange(Sized):
    members = """size_t struct_size; int64_t rank ranks=1; handle user; rc_gather_fn gather; rc_transpose_fn transpose;
    rc_shift_fn shift; text refused"""


@struct
class rc_ranks_counts(Sized):
    members = """size_t struct_size;
    int64_t products transpositions transposed reductions reduced gathers gathered shifts shifted iterations"""

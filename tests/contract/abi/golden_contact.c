/* The numbers of <roughcontact/roughcontact.h> and the headers beside it, see golden.h. */
#include <roughcontact/analysis.h>
#include <roughcontact/derivatives.h>
#include <roughcontact/direct.h>
#include <roughcontact/history.h>
#include <roughcontact/product.h>
#include <roughcontact/ranks.h>
#include <roughcontact/registry.h>

#include "golden.h"

VALUE(RC_OK, 0);
VALUE(RC_WITHIN_GOAL, 100);
VALUE(RC_STOP_MAX_ITER, 101);
VALUE(RC_STOP_TIME, 102);
VALUE(RC_STOP_CANCELLED, 103);
VALUE(RC_STOP_STALLED, 104);
VALUE(RC_UNCERTIFIED, 105);
VALUE(RC_OUTSIDE, 106);
VALUE(RC_ERR_ARGUMENT, -1);
VALUE(RC_ERR_SHAPE, -2);
VALUE(RC_ERR_OPTION, -3);
VALUE(RC_ERR_NO_BACKEND, -4);
VALUE(RC_ERR_NO_SOLVER, -5);
VALUE(RC_ERR_INCOMPATIBLE, -6);
VALUE(RC_ERR_PLUGIN, -7);
VALUE(RC_ERR_MEMORY, -8);
VALUE(RC_ERR_INFEASIBLE, -9);
VALUE(RC_ERR_NUMERIC, -10);
VALUE(RC_ERR_EXTERNAL, -11);
VALUE(RC_ERR_BUSY, -12);
VALUE(RC_ERR_INTERNAL, -99);

VALUE(RC_OPERATOR_HALFSPACE, 1);
VALUE(RC_OPERATOR_DENSE, 2);
VALUE(RC_OPERATOR_CALLBACK, 3);

VALUE(RC_BOUNDARY_FREE, 1);
VALUE(RC_BOUNDARY_PERIODIC, 2);
VALUE(RC_BOUNDARY_PERIODIC_X, 3);
VALUE(RC_BOUNDARY_PERIODIC_Y, 4);

VALUE(RC_CONTROL_APPROACH, 1);
VALUE(RC_CONTROL_LOAD, 2);

VALUE(RC_BATCH_SHARED, -1);

VALUE(RC_LOG_INFO, 1);
VALUE(RC_LOG_WARNING, 2);

VALUE(RC_CONTEXT_NO_PLUGINS, 1);
VALUE(RC_CONTEXT_NO_ENVIRONMENT, 2);

VALUE(RC_TYPE_INT, 1);
VALUE(RC_TYPE_REAL, 2);
VALUE(RC_TYPE_TEXT, 3);

VALUE(RC_ABI, 0);

VALUE(RC_NATIVE, 0);
VALUE(RC_SINGLE, 1);

SIZE(rc_array, 24);
AT(rc_array, data, 0);
AT(rc_array, type, 8);
AT(rc_array, reserved, 12);
AT(rc_array, memory, 16);

SIZE(rc_const_array, 24);
AT(rc_const_array, data, 0);
AT(rc_const_array, type, 8);
AT(rc_const_array, reserved, 12);
AT(rc_const_array, memory, 16);

SIZE(rc_system, 96);
AT(rc_system, struct_size, 0);
AT(rc_system, op, 8);
AT(rc_system, boundary, 12);
AT(rc_system, nx, 16);
AT(rc_system, ny, 24);
AT(rc_system, hx, 32);
AT(rc_system, hy, 40);
AT(rc_system, modulus, 48);
AT(rc_system, dense, 56);
AT(rc_system, dense_ld, 64);
AT(rc_system, apply, 72);
AT(rc_system, user, 80);
AT(rc_system, hardness, 88);

SIZE(rc_step, 104);
AT(rc_step, struct_size, 0);
AT(rc_step, control, 8);
AT(rc_step, warm_start, 12);
AT(rc_step, target, 16);
AT(rc_step, undeformed_gap, 24);
AT(rc_step, mask, 48);
AT(rc_step, p0, 72);
AT(rc_step, borrow, 96);
AT(rc_step, reserved, 100);

SIZE(rc_result, 968);
AT(rc_result, struct_size, 0);
AT(rc_result, p, 8);
AT(rc_result, gap, 32);
AT(rc_result, status, 56);
AT(rc_result, homogeneous, 60);
AT(rc_result, load, 64);
AT(rc_result, approach, 72);
AT(rc_result, mean_pressure, 80);
AT(rc_result, max_pressure, 88);
AT(rc_result, contact_area, 96);
AT(rc_result, area_fraction, 104);
AT(rc_result, mean_gap, 112);
AT(rc_result, energy, 120);
AT(rc_result, contacts, 128);
AT(rc_result, kkt_primal, 136);
AT(rc_result, kkt_dual, 144);
AT(rc_result, kkt_complementarity, 152);
AT(rc_result, kkt_control, 160);
AT(rc_result, tolerance, 168);
AT(rc_result, duality_gap, 176);
AT(rc_result, load_lower, 184);
AT(rc_result, load_upper, 192);
AT(rc_result, area_lower, 200);
AT(rc_result, area_upper, 208);
AT(rc_result, proven_contacts, 216);
AT(rc_result, proven_open, 224);
AT(rc_result, undecided, 232);
AT(rc_result, stiffness, 240);
AT(rc_result, stiffness_lower, 248);
AT(rc_result, stiffness_upper, 256);
AT(rc_result, punch_stiffness, 264);
AT(rc_result, capped, 272);
AT(rc_result, plastic_volume, 280);
AT(rc_result, proven_capped, 288);
AT(rc_result, points, 296);
AT(rc_result, candidates, 304);
AT(rc_result, modelled, 312);
AT(rc_result, iterations, 320);
AT(rc_result, products, 328);
AT(rc_result, levels, 336);
AT(rc_result, seconds, 344);
AT(rc_result, setup_seconds, 352);
AT(rc_result, solver, 360);
AT(rc_result, backend, 392);
AT(rc_result, kernel, 424);
AT(rc_result, note, 456);

SIZE(rc_accuracy, 48);
AT(rc_accuracy, struct_size, 0);
AT(rc_accuracy, model_nx, 8);
AT(rc_accuracy, model_ny, 16);
AT(rc_accuracy, error_estimate, 24);
AT(rc_accuracy, area_estimate, 32);
AT(rc_accuracy, left_out, 40);

SIZE(rc_level, 88);
AT(rc_level, struct_size, 0);
AT(rc_level, p, 8);
AT(rc_level, status, 16);
AT(rc_level, reserved, 20);
AT(rc_level, nx, 24);
AT(rc_level, ny, 32);
AT(rc_level, hx, 40);
AT(rc_level, hy, 48);
AT(rc_level, approach, 56);
AT(rc_level, load, 64);
AT(rc_level, candidates, 72);
AT(rc_level, contacts, 80);

SIZE(rc_state, 80);
AT(rc_state, struct_size, 0);
AT(rc_state, undeformed_gap, 8);
AT(rc_state, mask, 16);
AT(rc_state, p, 24);
AT(rc_state, approach, 32);
AT(rc_state, load, 40);
AT(rc_state, p_before, 48);
AT(rc_state, approach_before, 56);
AT(rc_state, load_before, 64);
AT(rc_state, indentation, 72);

SIZE(rc_history, 192);
AT(rc_history, struct_size, 0);
AT(rc_history, control, 8);
AT(rc_history, warm_start, 12);
AT(rc_history, n, 16);
AT(rc_history, targets, 24);
AT(rc_history, undeformed_gap, 32);
AT(rc_history, mask, 40);
AT(rc_history, load, 48);
AT(rc_history, approach, 56);
AT(rc_history, contact_area, 64);
AT(rc_history, mean_gap, 72);
AT(rc_history, energy, 80);
AT(rc_history, stiffness, 88);
AT(rc_history, load_lower, 96);
AT(rc_history, load_upper, 104);
AT(rc_history, area_lower, 112);
AT(rc_history, area_upper, 120);
AT(rc_history, stiffness_lower, 128);
AT(rc_history, stiffness_upper, 136);
AT(rc_history, certificate, 144);
AT(rc_history, products, 152);
AT(rc_history, fn, 160);
AT(rc_history, user, 168);
AT(rc_history, completed, 176);
AT(rc_history, want_gap, 184);
AT(rc_history, virgin, 188);

SIZE(rc_batch, 280);
AT(rc_batch, struct_size, 0);
AT(rc_batch, control, 8);
AT(rc_batch, warm_start, 12);
AT(rc_batch, n, 16);
AT(rc_batch, steps, 24);
AT(rc_batch, targets, 32);
AT(rc_batch, target_stride, 40);
AT(rc_batch, undeformed_gap, 48);
AT(rc_batch, undeformed_gap_stride, 56);
AT(rc_batch, mask, 64);
AT(rc_batch, mask_stride, 72);
AT(rc_batch, p0, 80);
AT(rc_batch, p, 88);
AT(rc_batch, load, 96);
AT(rc_batch, approach, 104);
AT(rc_batch, contact_area, 112);
AT(rc_batch, mean_gap, 120);
AT(rc_batch, energy, 128);
AT(rc_batch, stiffness, 136);
AT(rc_batch, load_lower, 144);
AT(rc_batch, load_upper, 152);
AT(rc_batch, area_lower, 160);
AT(rc_batch, area_upper, 168);
AT(rc_batch, stiffness_lower, 176);
AT(rc_batch, stiffness_upper, 184);
AT(rc_batch, certificate, 192);
AT(rc_batch, status, 200);
AT(rc_batch, iterations, 208);
AT(rc_batch, products, 216);
AT(rc_batch, fn, 224);
AT(rc_batch, user, 232);
AT(rc_batch, written, 240);
AT(rc_batch, certified, 248);
AT(rc_batch, first, 256);
AT(rc_batch, progress, 264);
AT(rc_batch, virgin, 272);
AT(rc_batch, reserved, 276);

SIZE(rc_gradient, 88);
AT(rc_gradient, struct_size, 0);
AT(rc_gradient, dJ_dp, 8);
AT(rc_gradient, dJ_dgap, 16);
AT(rc_gradient, dJ_dload, 24);
AT(rc_gradient, dJ_dapproach, 32);
AT(rc_gradient, dJ_dundeformed_gap, 40);
AT(rc_gradient, dJ_dtarget, 48);
AT(rc_gradient, dJ_dmodulus, 56);
AT(rc_gradient, error, 64);
AT(rc_gradient, undecided, 72);
AT(rc_gradient, products, 80);

SIZE(rc_tangent, 88);
AT(rc_tangent, struct_size, 0);
AT(rc_tangent, dundeformed_gap, 8);
AT(rc_tangent, dtarget, 16);
AT(rc_tangent, dmodulus, 24);
AT(rc_tangent, dp, 32);
AT(rc_tangent, dgap, 40);
AT(rc_tangent, dload, 48);
AT(rc_tangent, dapproach, 56);
AT(rc_tangent, error, 64);
AT(rc_tangent, undecided, 72);
AT(rc_tangent, products, 80);

SIZE(rc_direct, 600);
AT(rc_direct, struct_size, 0);
AT(rc_direct, status, 8);
AT(rc_direct, reserved, 12);
AT(rc_direct, iterations, 16);
AT(rc_direct, products, 24);
AT(rc_direct, contacts, 32);
AT(rc_direct, load, 40);
AT(rc_direct, energy, 48);
AT(rc_direct, kkt, 56);
AT(rc_direct, duality_gap, 64);
AT(rc_direct, load_lower, 72);
AT(rc_direct, load_upper, 80);
AT(rc_direct, note, 88);

SIZE(rc_area, 40);
AT(rc_area, struct_size, 0);
AT(rc_area, contacts, 8);
AT(rc_area, area, 16);
AT(rc_area, perimeter, 24);
AT(rc_area, corrected_area, 32);

SIZE(rc_patches, 96);
AT(rc_patches, struct_size, 0);
AT(rc_patches, neighbours, 8);
AT(rc_patches, reserved, 12);
AT(rc_patches, room, 16);
AT(rc_patches, label, 24);
AT(rc_patches, cells, 32);
AT(rc_patches, area, 40);
AT(rc_patches, perimeter, 48);
AT(rc_patches, load, 56);
AT(rc_patches, mean_pressure, 64);
AT(rc_patches, max_pressure, 72);
AT(rc_patches, peak, 80);
AT(rc_patches, count, 88);

SIZE(rc_histogram, 80);
AT(rc_histogram, struct_size, 0);
AT(rc_histogram, bins, 8);
AT(rc_histogram, upper, 16);
AT(rc_histogram, counts, 24);
AT(rc_histogram, density, 32);
AT(rc_histogram, width, 40);
AT(rc_histogram, contacts, 48);
AT(rc_histogram, above, 56);
AT(rc_histogram, mean_pressure, 64);
AT(rc_histogram, max_pressure, 72);

SIZE(rc_crossing, 24);
AT(rc_crossing, struct_size, 0);
AT(rc_crossing, contact_x, 8);
AT(rc_crossing, contact_y, 12);
AT(rc_crossing, gap_x, 16);
AT(rc_crossing, gap_y, 20);

SIZE(rc_progress, 40);
AT(rc_progress, struct_size, 0);
AT(rc_progress, iteration, 8);
AT(rc_progress, products, 16);
AT(rc_progress, kkt, 24);
AT(rc_progress, seconds, 32);

SIZE(rc_context_config, 40);
AT(rc_context_config, struct_size, 0);
AT(rc_context_config, flags, 8);
AT(rc_context_config, reserved, 12);
AT(rc_context_config, plugin_path, 16);
AT(rc_context_config, log, 24);
AT(rc_context_config, log_user, 32);

SIZE(rc_component, 40);
AT(rc_component, struct_size, 0);
AT(rc_component, name, 8);
AT(rc_component, summary, 16);
AT(rc_component, license, 24);
AT(rc_component, origin, 32);

SIZE(rc_option_spec, 64);
AT(rc_option_spec, struct_size, 0);
AT(rc_option_spec, key, 8);
AT(rc_option_spec, default_value, 16);
AT(rc_option_spec, choices, 24);
AT(rc_option_spec, help, 32);
AT(rc_option_spec, type, 40);
AT(rc_option_spec, fixed, 44);
AT(rc_option_spec, minimum, 48);
AT(rc_option_spec, maximum, 56);

SIZE(rc_status, 4);

int main(void) { return 0; }

SIZE(rc_exchange, 64);
AT(rc_exchange, struct_size, 0);
AT(rc_exchange, rank, 8);
AT(rc_exchange, ranks, 16);
AT(rc_exchange, user, 24);
AT(rc_exchange, gather, 32);
AT(rc_exchange, transpose, 40);
AT(rc_exchange, shift, 48);
AT(rc_exchange, refused, 56);

SIZE(rc_ranks_counts, 88);
AT(rc_ranks_counts, struct_size, 0);
AT(rc_ranks_counts, products, 8);
AT(rc_ranks_counts, transpositions, 16);
AT(rc_ranks_counts, transposed, 24);
AT(rc_ranks_counts, reductions, 32);
AT(rc_ranks_counts, reduced, 40);
AT(rc_ranks_counts, gathers, 48);
AT(rc_ranks_counts, gathered, 56);
AT(rc_ranks_counts, shifts, 64);
AT(rc_ranks_counts, shifted, 72);
AT(rc_ranks_counts, iterations, 80);

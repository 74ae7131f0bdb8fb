/* The binary interface, written out: every constant, struct size and member offset on a 64-bit (LP64) platform. Nothing
 * here may change while RC_ABI and RC_PLUGIN_ABI_MAJOR stay as they are; members may only be added at the end of a sized
 * struct, with a new line here. Compiles as C99, C11 and C++17. */
#include <roughcontact/plugin.h>

/* An array of negative size where the condition does not hold: the one assertion that all three languages have. */
#define VALUE(name, value) typedef char value_of_##name[(name) == (value) ? 1 : -1]
#define SIZE(type, bytes) typedef char size_of_##type[sizeof(type) == (bytes) ? 1 : -1]
#define AT(type, member, offset) typedef char type##_at_##member[offsetof(type, member) == (offset) ? 1 : -1]

VALUE(RC_OK, 0);
VALUE(RC_STOP_MAX_ITER, 1);
VALUE(RC_STOP_TIME, 2);
VALUE(RC_STOP_CANCELLED, 3);
VALUE(RC_STOP_STALLED, 4);
VALUE(RC_STOP_UNCERTIFIED, 5);
VALUE(RC_WITHIN_GOAL, 6);
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

VALUE(RC_CONTROL_DISPLACEMENT, 1);
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

SIZE(rc_system, 88);
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

SIZE(rc_step, 56);
AT(rc_step, struct_size, 0);
AT(rc_step, control, 8);
AT(rc_step, warm_start, 12);
AT(rc_step, target, 16);
AT(rc_step, gap, 24);
AT(rc_step, p0, 32);
AT(rc_step, mask, 40);
AT(rc_step, borrow, 48);
AT(rc_step, reserved, 52);

SIZE(rc_result, 552);
AT(rc_result, struct_size, 0);
AT(rc_result, p, 8);
AT(rc_result, gap, 16);
AT(rc_result, status, 24);
AT(rc_result, reserved, 28);
AT(rc_result, iterations, 32);
AT(rc_result, applications, 40);
AT(rc_result, points, 48);
AT(rc_result, candidates, 56);
AT(rc_result, modelled, 64);
AT(rc_result, contacts, 72);
AT(rc_result, load, 80);
AT(rc_result, displacement, 88);
AT(rc_result, mean_pressure, 96);
AT(rc_result, contact_area, 104);
AT(rc_result, energy, 112);
AT(rc_result, stiffness, 120);
AT(rc_result, kkt_primal, 128);
AT(rc_result, kkt_dual, 136);
AT(rc_result, kkt_complementarity, 144);
AT(rc_result, kkt_control, 152);
AT(rc_result, seconds, 160);
AT(rc_result, setup_seconds, 168);
AT(rc_result, solver, 176);
AT(rc_result, backend, 208);
AT(rc_result, kernel, 240);
AT(rc_result, note, 272);
AT(rc_result, duality_gap, 432);
AT(rc_result, load_lower, 440);
AT(rc_result, load_upper, 448);
AT(rc_result, area_lower, 456);
AT(rc_result, area_upper, 464);
AT(rc_result, proven_contacts, 472);
AT(rc_result, proven_open, 480);
AT(rc_result, undecided, 488);
AT(rc_result, levels, 496);
AT(rc_result, tolerance, 504);
AT(rc_result, model_nx, 512);
AT(rc_result, model_ny, 520);
AT(rc_result, error_estimate, 528);
AT(rc_result, left_out, 536);
AT(rc_result, area_estimate, 544);

SIZE(rc_level, 88);
AT(rc_level, struct_size, 0);
AT(rc_level, p, 8);
AT(rc_level, status, 16);
AT(rc_level, reserved, 20);
AT(rc_level, nx, 24);
AT(rc_level, ny, 32);
AT(rc_level, hx, 40);
AT(rc_level, hy, 48);
AT(rc_level, displacement, 56);
AT(rc_level, load, 64);
AT(rc_level, candidates, 72);
AT(rc_level, contacts, 80);

SIZE(rc_state, 72);
AT(rc_state, struct_size, 0);
AT(rc_state, gap, 8);
AT(rc_state, mask, 16);
AT(rc_state, p, 24);
AT(rc_state, displacement, 32);
AT(rc_state, load, 40);
AT(rc_state, p_before, 48);
AT(rc_state, displacement_before, 56);
AT(rc_state, load_before, 64);

SIZE(rc_path, 120);
AT(rc_path, struct_size, 0);
AT(rc_path, control, 8);
AT(rc_path, warm_start, 12);
AT(rc_path, n, 16);
AT(rc_path, targets, 24);
AT(rc_path, gap, 32);
AT(rc_path, mask, 40);
AT(rc_path, load, 48);
AT(rc_path, displacement, 56);
AT(rc_path, contact_area, 64);
AT(rc_path, stiffness, 72);
AT(rc_path, certificate, 80);
AT(rc_path, applications, 88);
AT(rc_path, fn, 96);
AT(rc_path, user, 104);
AT(rc_path, completed, 112);

SIZE(rc_batch, 200);
AT(rc_batch, struct_size, 0);
AT(rc_batch, control, 8);
AT(rc_batch, warm_start, 12);
AT(rc_batch, n, 16);
AT(rc_batch, steps, 24);
AT(rc_batch, targets, 32);
AT(rc_batch, target_stride, 40);
AT(rc_batch, gap, 48);
AT(rc_batch, gap_stride, 56);
AT(rc_batch, mask, 64);
AT(rc_batch, mask_stride, 72);
AT(rc_batch, p0, 80);
AT(rc_batch, p, 88);
AT(rc_batch, load, 96);
AT(rc_batch, displacement, 104);
AT(rc_batch, contact_area, 112);
AT(rc_batch, stiffness, 120);
AT(rc_batch, certificate, 128);
AT(rc_batch, status, 136);
AT(rc_batch, iterations, 144);
AT(rc_batch, applications, 152);
AT(rc_batch, fn, 160);
AT(rc_batch, user, 168);
AT(rc_batch, written, 176);
AT(rc_batch, certified, 184);
AT(rc_batch, first, 192);

SIZE(rc_direct, 248);
AT(rc_direct, struct_size, 0);
AT(rc_direct, status, 8);
AT(rc_direct, reserved, 12);
AT(rc_direct, iterations, 16);
AT(rc_direct, applications, 24);
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

SIZE(rc_progress, 40);
AT(rc_progress, struct_size, 0);
AT(rc_progress, iteration, 8);
AT(rc_progress, applications, 16);
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

VALUE(RC_PLUGIN_ABI_MAJOR, 1);
VALUE(RC_PLUGIN_ABI_MINOR, 4);

VALUE(RC_CAP_FREE, 1);
VALUE(RC_CAP_PERIODIC, 2);
VALUE(RC_CAP_DENSE_INPUT, 4);
VALUE(RC_CAP_CALLBACK, 8);
VALUE(RC_CAP_SUBSET, 16);
VALUE(RC_CAP_THREAD_INVARIANT, 32);
VALUE(RC_CAP_SHIFTED, 64);
VALUE(RC_CAP_NORM, 128);
VALUE(RC_CAP_FLOAT, 256);
VALUE(RC_CAP_SCREEN, 512);
VALUE(RC_CAP_APPROXIMATE, 1024);

VALUE(RC_NEEDS_GRID, INT64_C(4294967296));
VALUE(RC_WANTS_BOX, INT64_C(8589934592));

SIZE(rc_host, 96);
AT(rc_host, struct_size, 0);
AT(rc_host, abi_major, 8);
AT(rc_host, abi_minor, 12);
AT(rc_host, fail, 16);
AT(rc_host, log, 24);
AT(rc_host, lock, 32);
AT(rc_host, unlock, 40);
AT(rc_host, option_int, 48);
AT(rc_host, option_real, 56);
AT(rc_host, option_text, 64);
AT(rc_host, coefficients, 72);
AT(rc_host, symbol, 80);
AT(rc_host, window, 88);

SIZE(rc_team, 24);
AT(rc_team, struct_size, 0);
AT(rc_team, threads, 8);
AT(rc_team, share, 16);

SIZE(rc_operator_spec, 48);
AT(rc_operator_spec, struct_size, 0);
AT(rc_operator_spec, system, 8);
AT(rc_operator_spec, kernel, 16);
AT(rc_operator_spec, options, 24);
AT(rc_operator_spec, team, 32);
AT(rc_operator_spec, poll, 40);

SIZE(rc_domain, 32);
AT(rc_domain, struct_size, 0);
AT(rc_domain, n, 8);
AT(rc_domain, index, 16);
AT(rc_domain, zero_mode, 24);

SIZE(rc_screen, 88);
AT(rc_screen, struct_size, 0);
AT(rc_screen, approach, 8);
AT(rc_screen, unit, 16);
AT(rc_screen, gap, 24);
AT(rc_screen, mask, 32);
AT(rc_screen, y, 40);
AT(rc_screen, room, 48);
AT(rc_screen, found, 56);
AT(rc_screen, depth, 64);
AT(rc_screen, n_found, 72);
AT(rc_screen, tile_lowest, 80);

SIZE(rc_backend, 152);
AT(rc_backend, struct_size, 0);
AT(rc_backend, name, 8);
AT(rc_backend, summary, 16);
AT(rc_backend, license, 24);
AT(rc_backend, caps, 32);
AT(rc_backend, n_options, 40);
AT(rc_backend, options, 48);
AT(rc_backend, create, 56);
AT(rc_backend, destroy, 64);
AT(rc_backend, bind, 72);
AT(rc_backend, apply, 80);
AT(rc_backend, field, 88);
AT(rc_backend, modelled, 96);
AT(rc_backend, subset, 104);
AT(rc_backend, shifted, 112);
AT(rc_backend, norm, 120);
AT(rc_backend, apply_float, 128);
AT(rc_backend, screen, 136);
AT(rc_backend, forget, 144);

SIZE(rc_grid, 80);
AT(rc_grid, struct_size, 0);
AT(rc_grid, nx, 8);
AT(rc_grid, ny, 16);
AT(rc_grid, hx, 24);
AT(rc_grid, hy, 32);
AT(rc_grid, gap, 40);
AT(rc_grid, mask, 48);
AT(rc_grid, index, 56);
AT(rc_grid, approach, 64);
AT(rc_grid, boundary, 72);
AT(rc_grid, reserved, 76);

SIZE(rc_coarse, 96);
AT(rc_coarse, struct_size, 0);
AT(rc_coarse, nx, 8);
AT(rc_coarse, ny, 16);
AT(rc_coarse, factor, 24);
AT(rc_coarse, gap, 32);
AT(rc_coarse, mask, 40);
AT(rc_coarse, approach, 48);
AT(rc_coarse, solver, 56);
AT(rc_coarse, p, 64);
AT(rc_coarse, control, 72);
AT(rc_coarse, keep, 76);
AT(rc_coarse, load, 80);
AT(rc_coarse, tol, 88);

SIZE(rc_problem, 176);
AT(rc_problem, struct_size, 0);
AT(rc_problem, n, 8);
AT(rc_problem, control, 16);
AT(rc_problem, reserved, 20);
AT(rc_problem, u, 24);
AT(rc_problem, load, 32);
AT(rc_problem, tol, 40);
AT(rc_problem, apply, 48);
AT(rc_problem, subset, 56);
AT(rc_problem, poll, 64);
AT(rc_problem, lambda_min, 72);
AT(rc_problem, positive, 80);
AT(rc_problem, factors, 84);
AT(rc_problem, grid, 88);
AT(rc_problem, shifted, 96);
AT(rc_problem, norm, 104);
AT(rc_problem, inner, 112);
AT(rc_problem, coarse, 120);
AT(rc_problem, note, 128);
AT(rc_problem, coefficients, 136);
AT(rc_problem, apply_float, 144);
AT(rc_problem, team, 152);
AT(rc_problem, length, 160);
AT(rc_problem, pressure, 168);

SIZE(rc_solver, 72);
AT(rc_solver, struct_size, 0);
AT(rc_solver, name, 8);
AT(rc_solver, summary, 16);
AT(rc_solver, license, 24);
AT(rc_solver, needs, 32);
AT(rc_solver, controls, 40);
AT(rc_solver, reserved, 44);
AT(rc_solver, n_options, 48);
AT(rc_solver, options, 56);
AT(rc_solver, solve, 64);

SIZE(rc_plugin, 64);
AT(rc_plugin, struct_size, 0);
AT(rc_plugin, abi_major, 8);
AT(rc_plugin, abi_minor, 12);
AT(rc_plugin, name, 16);
AT(rc_plugin, version, 24);
AT(rc_plugin, n_backends, 32);
AT(rc_plugin, n_solvers, 40);
AT(rc_plugin, backends, 48);
AT(rc_plugin, solvers, 56);

SIZE(rc_status, 4);

int main(void) { return 0; }

/* The numbers of <roughcontact/plugin.h>, see golden.h. */
#include <roughcontact/plugin.h>

#include "golden.h"

VALUE(RC_PLUGIN_ABI_MAJOR, 1);
VALUE(RC_PLUGIN_ABI_MINOR, 9);

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
VALUE(RC_CAP_FAR_FIELD, 2048);
VALUE(RC_CAP_SINGLE_GAP, 4096);
VALUE(RC_CAP_ROWS, 8192);
VALUE(RC_KERNEL_FREE, 1);
VALUE(RC_KERNEL_PERIODIC, 2);
VALUE(RC_KERNEL_SQUARE, 4);
VALUE(RC_KERNEL_POSITIVE, 8);
VALUE(RC_KERNEL_FAR_FIELD, 16);

VALUE(RC_NEEDS_GRID, INT64_C(4294967296));
VALUE(RC_WANTS_BOX, INT64_C(8589934592));
VALUE(RC_TAKES_CAP, INT64_C(34359738368));
VALUE(RC_READS_SINGLE_GAP, INT64_C(68719476736));
VALUE(RC_TAKES_ROWS, INT64_C(137438953472));

SIZE(rc_rows, 56);
AT(rc_rows, struct_size, 0);
AT(rc_rows, rank, 8);
AT(rc_rows, ranks, 16);
AT(rc_rows, first, 24);
AT(rc_rows, transpose, 32);
AT(rc_rows, agree, 40);
AT(rc_rows, gather, 48);

SIZE(rc_host, 112);
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
AT(rc_host, share, 96);
AT(rc_host, release, 104);

SIZE(rc_team, 24);
AT(rc_team, struct_size, 0);
AT(rc_team, threads, 8);
AT(rc_team, share, 16);

SIZE(rc_operator_spec, 56);
AT(rc_operator_spec, struct_size, 0);
AT(rc_operator_spec, system, 8);
AT(rc_operator_spec, kernel, 16);
AT(rc_operator_spec, options, 24);
AT(rc_operator_spec, team, 32);
AT(rc_operator_spec, poll, 40);
AT(rc_operator_spec, rows, 48);

SIZE(rc_domain, 32);
AT(rc_domain, struct_size, 0);
AT(rc_domain, n, 8);
AT(rc_domain, index, 16);
AT(rc_domain, zero_mode, 24);

SIZE(rc_screen, 96);
AT(rc_screen, struct_size, 0);
AT(rc_screen, approach, 8);
AT(rc_screen, unit, 16);
AT(rc_screen, undeformed_gap, 24);
AT(rc_screen, mask, 32);
AT(rc_screen, y, 40);
AT(rc_screen, room, 48);
AT(rc_screen, found, 56);
AT(rc_screen, depth, 64);
AT(rc_screen, n_found, 72);
AT(rc_screen, tile_lowest, 80);
AT(rc_screen, undeformed_gap_single, 88);

SIZE(rc_facts, 80);
AT(rc_facts, struct_size, 0);
AT(rc_facts, host, 8);
AT(rc_facts, options, 16);
AT(rc_facts, system, 24);
AT(rc_facts, n, 32);
AT(rc_facts, box, 40);
AT(rc_facts, tol, 48);
AT(rc_facts, backend, 56);
AT(rc_facts, caps, 64);
AT(rc_facts, partial, 72);
AT(rc_facts, reserved, 76);

SIZE(rc_estimate, 48);
AT(rc_estimate, struct_size, 0);
AT(rc_estimate, seconds, 8);
AT(rc_estimate, bytes, 16);
AT(rc_estimate, product, 24);
AT(rc_estimate, field, 32);
AT(rc_estimate, factor, 40);

SIZE(rc_backend, 168);
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
AT(rc_backend, score, 152);
AT(rc_backend, rest, 160);

SIZE(rc_grid, 96);
AT(rc_grid, struct_size, 0);
AT(rc_grid, nx, 8);
AT(rc_grid, ny, 16);
AT(rc_grid, hx, 24);
AT(rc_grid, hy, 32);
AT(rc_grid, undeformed_gap, 40);
AT(rc_grid, mask, 48);
AT(rc_grid, index, 56);
AT(rc_grid, approach, 64);
AT(rc_grid, boundary, 72);
AT(rc_grid, reserved, 76);
AT(rc_grid, softness, 80);
AT(rc_grid, undeformed_gap_single, 88);

SIZE(rc_coarse, 96);
AT(rc_coarse, struct_size, 0);
AT(rc_coarse, nx, 8);
AT(rc_coarse, ny, 16);
AT(rc_coarse, factor, 24);
AT(rc_coarse, undeformed_gap, 32);
AT(rc_coarse, mask, 40);
AT(rc_coarse, approach, 48);
AT(rc_coarse, solver, 56);
AT(rc_coarse, p, 64);
AT(rc_coarse, control, 72);
AT(rc_coarse, keep, 76);
AT(rc_coarse, load, 80);
AT(rc_coarse, tol, 88);

SIZE(rc_problem, 208);
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
AT(rc_problem, cap, 176);
AT(rc_problem, rows, 184);
AT(rc_problem, multiplied, 192);
AT(rc_problem, zero_mode, 200);

SIZE(rc_solver, 80);
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
AT(rc_solver, score, 72);

SIZE(rc_kernel_spec, 48);
AT(rc_kernel_spec, struct_size, 0);
AT(rc_kernel_spec, kernel, 8);
AT(rc_kernel_spec, system, 16);
AT(rc_kernel_spec, options, 24);
AT(rc_kernel_spec, length, 32);
AT(rc_kernel_spec, modulus, 40);

SIZE(rc_kernel_bounds, 24);
AT(rc_kernel_bounds, struct_size, 0);
AT(rc_kernel_bounds, lowest, 8);
AT(rc_kernel_bounds, galerkin_share, 16);

SIZE(rc_kernel, 88);
AT(rc_kernel, struct_size, 0);
AT(rc_kernel, name, 8);
AT(rc_kernel, summary, 16);
AT(rc_kernel, license, 24);
AT(rc_kernel, caps, 32);
AT(rc_kernel, n_options, 40);
AT(rc_kernel, options, 48);
AT(rc_kernel, window, 56);
AT(rc_kernel, symbol, 64);
AT(rc_kernel, bounds, 72);
AT(rc_kernel, user, 80);

SIZE(rc_plugin, 80);
AT(rc_plugin, struct_size, 0);
AT(rc_plugin, abi_major, 8);
AT(rc_plugin, abi_minor, 12);
AT(rc_plugin, name, 16);
AT(rc_plugin, version, 24);
AT(rc_plugin, n_backends, 32);
AT(rc_plugin, n_solvers, 40);
AT(rc_plugin, backends, 48);
AT(rc_plugin, solvers, 56);
AT(rc_plugin, n_kernels, 64);
AT(rc_plugin, kernels, 72);

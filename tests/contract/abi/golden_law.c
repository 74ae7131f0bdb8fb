/* The numbers of <roughcontact/law.h>, see golden.h. */
#include <roughcontact/law.h>

#include "golden.h"

VALUE(RC_LAW_BULK_AUTO, 0);
VALUE(RC_LAW_BULK_NONE, 1);
VALUE(RC_LAW_BULK_GIVEN, 2);
VALUE(RC_LAW_BULK_MEAN, 3);

VALUE(RC_LAW_CONVEX, 1);
VALUE(RC_LAW_SLOPES, 2);
VALUE(RC_LAW_MONOTONE, 3);

VALUE(RC_LAW_CSV, 1);
VALUE(RC_LAW_CALCULIX, 2);
VALUE(RC_LAW_ABAQUS, 3);
VALUE(RC_LAW_MOOSE, 4);
VALUE(RC_LAW_TABLE, 5);

SIZE(rc_law_spec, 104);
AT(rc_law_spec, struct_size, 0);
AT(rc_law_spec, undeformed_gap, 8);
AT(rc_law_spec, mask, 16);
AT(rc_law_spec, area, 24);
AT(rc_law_spec, p_lower, 32);
AT(rc_law_spec, p_upper, 40);
AT(rc_law_spec, tolerance, 48);
AT(rc_law_spec, tolerance_conductance, 56);
AT(rc_law_spec, bulk, 64);
AT(rc_law_spec, reserved, 68);
AT(rc_law_spec, bulk_stiffness, 72);
AT(rc_law_spec, max_nodes, 80);
AT(rc_law_spec, progress, 88);
AT(rc_law_spec, user, 96);

SIZE(rc_law_info, 144);
AT(rc_law_info, struct_size, 0);
AT(rc_law_info, nodes, 8);
AT(rc_law_info, solves, 16);
AT(rc_law_info, seconds, 24);
AT(rc_law_info, bounds, 32);
AT(rc_law_info, bulk, 36);
AT(rc_law_info, width, 40);
AT(rc_law_info, width_conductance, 48);
AT(rc_law_info, width_area, 56);
AT(rc_law_info, energy_error, 64);
AT(rc_law_info, modulus, 72);
AT(rc_law_info, hardness, 80);
AT(rc_law_info, area, 88);
AT(rc_law_info, bulk_stiffness, 96);
AT(rc_law_info, mean_gap, 104);
AT(rc_law_info, x_lower, 112);
AT(rc_law_info, x_upper, 120);
AT(rc_law_info, p_lower, 128);
AT(rc_law_info, p_upper, 136);

SIZE(rc_law_node, 120);
AT(rc_law_node, struct_size, 0);
AT(rc_law_node, x, 8);
AT(rc_law_node, p, 16);
AT(rc_law_node, p_lower, 24);
AT(rc_law_node, p_upper, 32);
AT(rc_law_node, slope, 40);
AT(rc_law_node, slope_lower, 48);
AT(rc_law_node, slope_upper, 56);
AT(rc_law_node, energy, 64);
AT(rc_law_node, area_fraction, 72);
AT(rc_law_node, area_lower, 80);
AT(rc_law_node, area_upper, 88);
AT(rc_law_node, between_lower, 96);
AT(rc_law_node, between_upper, 104);
AT(rc_law_node, bounds, 112);
AT(rc_law_node, reserved, 116);

SIZE(rc_law_point, 104);
AT(rc_law_point, struct_size, 0);
AT(rc_law_point, x, 8);
AT(rc_law_point, p, 16);
AT(rc_law_point, p_lower, 24);
AT(rc_law_point, p_upper, 32);
AT(rc_law_point, slope, 40);
AT(rc_law_point, energy, 48);
AT(rc_law_point, area_fraction, 56);
AT(rc_law_point, area_lower, 64);
AT(rc_law_point, area_upper, 72);
AT(rc_law_point, conductance, 80);
AT(rc_law_point, conductance_lower, 88);
AT(rc_law_point, conductance_upper, 96);

SIZE(rc_law_export_spec, 72);
AT(rc_law_export_spec, struct_size, 0);
AT(rc_law_export_spec, format, 8);
AT(rc_law_export_spec, reserved, 12);
AT(rc_law_export_spec, rows, 16);
AT(rc_law_export_spec, rho1, 24);
AT(rc_law_export_spec, rho2, 32);
AT(rc_law_export_spec, length, 40);
AT(rc_law_export_spec, force, 48);
AT(rc_law_export_spec, beyond, 56);
AT(rc_law_export_spec, error, 64);

/* The numbers of <roughcontact/surface.h>, see golden.h. */
#include <roughcontact/surface.h>

#include "golden.h"

VALUE(RC_SURFACE_PARABOLOID, 1);
VALUE(RC_SURFACE_SPHERE, 2);
VALUE(RC_SURFACE_WAVES, 3);
VALUE(RC_SURFACE_PYRAMIDS, 4);
VALUE(RC_SURFACE_NOISE, 5);

VALUE(RC_SURFACE_TREND_AUTO, 0);
VALUE(RC_SURFACE_TREND_MEAN, 1);
VALUE(RC_SURFACE_TREND_PLANE, 2);

VALUE(RC_SURFACE_SUBSAMPLE, 1);
VALUE(RC_SURFACE_MEAN, 2);
VALUE(RC_SURFACE_MAX, 3);

VALUE(RC_SURFACE_PEAKS, 4);

SIZE(rc_surface_rmd_spec, 48);
AT(rc_surface_rmd_spec, struct_size, 0);
AT(rc_surface_rmd_spec, seed, 8);
AT(rc_surface_rmd_spec, levels, 16);
AT(rc_surface_rmd_spec, additions, 20);
AT(rc_surface_rmd_spec, hurst, 24);
AT(rc_surface_rmd_spec, sigma, 32);
AT(rc_surface_rmd_spec, rms_height, 40);

SIZE(rc_surface_spectral_spec, 104);
AT(rc_surface_spectral_spec, struct_size, 0);
AT(rc_surface_spectral_spec, seed, 8);
AT(rc_surface_spectral_spec, nx, 16);
AT(rc_surface_spectral_spec, ny, 24);
AT(rc_surface_spectral_spec, hx, 32);
AT(rc_surface_spectral_spec, hy, 40);
AT(rc_surface_spectral_spec, hurst, 48);
AT(rc_surface_spectral_spec, q_low, 56);
AT(rc_surface_spectral_spec, q_rolloff, 64);
AT(rc_surface_spectral_spec, q_high, 72);
AT(rc_surface_spectral_spec, rms_height, 80);
AT(rc_surface_spectral_spec, rms_slope, 88);
AT(rc_surface_spectral_spec, fixed_amplitudes, 96);
AT(rc_surface_spectral_spec, reserved, 100);

SIZE(rc_surface_shape_spec, 88);
AT(rc_surface_shape_spec, struct_size, 0);
AT(rc_surface_shape_spec, shape, 8);
AT(rc_surface_shape_spec, reserved, 12);
AT(rc_surface_shape_spec, seed, 16);
AT(rc_surface_shape_spec, nx, 24);
AT(rc_surface_shape_spec, ny, 32);
AT(rc_surface_shape_spec, hx, 40);
AT(rc_surface_shape_spec, hy, 48);
AT(rc_surface_shape_spec, radius, 56);
AT(rc_surface_shape_spec, height, 64);
AT(rc_surface_shape_spec, period_x, 72);
AT(rc_surface_shape_spec, period_y, 80);

SIZE(rc_surface_map, 56);
AT(rc_surface_map, struct_size, 0);
AT(rc_surface_map, nx, 8);
AT(rc_surface_map, ny, 16);
AT(rc_surface_map, hx, 24);
AT(rc_surface_map, hy, 32);
AT(rc_surface_map, heights, 40);
AT(rc_surface_map, periodic, 48);
AT(rc_surface_map, trend, 52);

SIZE(rc_surface_statistics, 112);
AT(rc_surface_statistics, struct_size, 0);
AT(rc_surface_statistics, rms_height, 8);
AT(rc_surface_statistics, skewness, 16);
AT(rc_surface_statistics, kurtosis, 24);
AT(rc_surface_statistics, highest, 32);
AT(rc_surface_statistics, lowest, 40);
AT(rc_surface_statistics, rms_slope, 48);
AT(rc_surface_statistics, rms_slope_x, 56);
AT(rc_surface_statistics, rms_slope_y, 64);
AT(rc_surface_statistics, rms_curvature, 72);
AT(rc_surface_statistics, m0, 80);
AT(rc_surface_statistics, m2, 88);
AT(rc_surface_statistics, m4, 96);
AT(rc_surface_statistics, nayak, 104);

SIZE(rc_surface_power_law, 176);
AT(rc_surface_power_law, struct_size, 0);
AT(rc_surface_power_law, hurst, 8);
AT(rc_surface_power_law, hurst_error, 16);
AT(rc_surface_power_law, slope, 24);
AT(rc_surface_power_law, prefactor, 32);
AT(rc_surface_power_law, q_min, 40);
AT(rc_surface_power_law, q_max, 48);
AT(rc_surface_power_law, q_rolloff, 56);
AT(rc_surface_power_law, q_cutoff, 64);
AT(rc_surface_power_law, peaks, 72);
AT(rc_surface_power_law, peak_qx, 80);
AT(rc_surface_power_law, peak_qy, 112);
AT(rc_surface_power_law, peak_share, 144);

SIZE(rc_surface_cmr, 472);
AT(rc_surface_cmr, struct_size, 0);
AT(rc_surface_cmr, trustworthy, 8);
AT(rc_surface_cmr, levels, 12);
AT(rc_surface_cmr, safe_levels, 16);
AT(rc_surface_cmr, reserved, 20);
AT(rc_surface_cmr, unresolved, 24);
AT(rc_surface_cmr, limit, 32);
AT(rc_surface_cmr, unresolved_overall, 40);
AT(rc_surface_cmr, peak_loss, 48);
AT(rc_surface_cmr, approach, 56);
AT(rc_surface_cmr, coarsest_pitch, 64);
AT(rc_surface_cmr, reason, 72);

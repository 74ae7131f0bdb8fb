/* roughcontact-surface: generation and analysis of rough surfaces. A separate library (libroughcontact-surface), so that a
 * program that only solves contacts does not link the GNU Scientific Library.
 *
 * Licence: this library's own code is BSD-3-Clause, but it links GSL, so a program that links it is subject to the
 * GPL, version 3 or later.
 *
 * Conventions
 *   heights         z [length], towards the other body: the highest point touches first; x fastest,
 *                   point (ix, iy) at index iy*nx + ix
 *   wave numbers    q = 2 pi / wavelength [1/length]
 *   PSD             C(qx, qy) = nx ny hx hy |a|^2 with a = DFT(z) / (nx ny)  [length^4]: the sum of C over all wave
 *                   vectors but the mean, divided by the area nx hx ny hy, is the variance of the heights
 *                   (Jacobs, Junge & Pastewka 2017). A self-affine surface has C ~ q^(-2 - 2H), H its Hurst
 *                   exponent; a profile (nx or ny = 1) C ~ q^(-1 - 2H).
 *
 * Lengths, wave numbers and slopes that are not 0 lie in 1e-60 .. 1e60, heights within +-1e60.
 *
 * Every function returns an rc_status: RC_OK, RC_STOP_CANCELLED or a negative one, with the text in rc_surface_last_error().
 * All of them are thread-safe and keep nothing; the caller owns every array. Arrays are written only if RC_OK is returned; they
 * are plain pointers, as this library fills the host's memory alone. Sized structs: see roughcontact.h. GSL's error handler is
 * neither used nor changed.
 *
 * Reproducibility: the same numbers come from every call, in any thread. Midpoint displacement and noise are bitwise
 * equal on all machines with IEEE 754 doubles (integers, + - * / and square roots only); the others use the platform's
 * sine, cosine and power functions and agree to 1e-12 of the rms height.
 */
#ifndef ROUGHCONTACT_SURFACE_H
#define ROUGHCONTACT_SURFACE_H

#include "roughcontact.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The calling thread's last failure in this library, as "where: what, value, limit, what to do"; "" if the last call
 *  returned RC_OK. Valid until the thread's next call. */
RC_API const char *rc_surface_last_error(void);
/** As rc_stop_when, of the calling thread's calls of this library: they fail with RC_STOP_CANCELLED. */
RC_API void rc_surface_stop_when(const int32_t *flag);

/** @defgroup generate Generators  @{ */

/** Random midpoint displacement (Peitgen & Saupe 1988, algorithm MidPointFM2D). */
typedef struct rc_surface_rmd_spec {
  size_t struct_size;  /* sizeof(rc_surface_rmd_spec)                                                        */
  uint64_t seed;       /* any number                                                                        */
  int32_t levels;      /* 1 .. 14: the finest stage has 2^levels + 1 vertices a side                         */
  int32_t additions;   /* 1: random additions to all earlier points at every stage (coarse stages are then no
                          sub-samplings of fine ones); 0: new points only, as Bemporad & Paggi (2015) use it */
  double hurst;        /* 0 < H <= 1                                                                        */
  double sigma;        /* standard deviation of the corners [length], > 0; read if rms_height is 0           */
  double rms_height;   /* > 0: all stages are scaled so that the finest has it [length]; 0: not scaled       */
} rc_surface_rmd_spec;
#define RC_SURFACE_RMD_SPEC_INIT \
  { sizeof(rc_surface_rmd_spec), 1, 8, 0, 0.7, 1.0, 0.0 }

/** The surface at a stage: out [(2^stage + 1)^2] heights of the vertices, or with crop = 1 out [(2^stage)^2], without the
 *  last row and column. 0 <= stage <= levels. Without additions, stage s is every second vertex of stage s + 1, bit for
 *  bit. Errors: ARGUMENT, MEMORY. */
RC_API rc_status rc_surface_rmd(const rc_surface_rmd_spec *spec, int32_t stage, int32_t crop, double *out);

/** Periodic self-affine surface: Gaussian noise filtered to C(q) = 0 below q_low, constant up to q_rolloff,
 *  ~ q^(-2 - 2H) (profiles: q^(-1 - 2H)) up to q_high, 0 above. */
typedef struct rc_surface_spectral_spec {
  size_t struct_size;  /* sizeof(rc_surface_spectral_spec)                                                   */
  uint64_t seed;       /* any number                                                                        */
  int64_t nx, ny;      /* points, >= 1                                                                      */
  double hx, hy;       /* pitch [length], 1e-60 .. 1e60                                                      */
  double hurst;        /* 0 <= H <= 1                                                                        */
  double q_low;        /* [1/length]; 0: none                                                                */
  double q_rolloff;    /* [1/length]; 0: none                                                                */
  double q_high;       /* [1/length]; 0: pi / max(hx, hy), the largest wave number resolved in both directions */
  double rms_height;   /* [length]; exactly one of rms_height and rms_slope is > 0, the other 0              */
  double rms_slope;    /* of the trigonometric interpolant: sum of q^2 C / area is its square                */
  int32_t fixed_amplitudes; /* 1: |a| exactly as C(q), only the phases are random; 0: Gaussian amplitudes     */
  int32_t reserved;    /* 0                                                                                 */
} rc_surface_spectral_spec;
#define RC_SURFACE_SPECTRAL_SPEC_INIT \
  { sizeof(rc_surface_spectral_spec), 1, 256, 256, 1.0, 1.0, 0.8, 0.0, 0.0, 0.0, 1.0, 0.0, 0, 0 }

/** out [nx*ny] heights, mean 0. Errors: ARGUMENT (also where no wave lies between the cut-offs), SHAPE, MEMORY. */
RC_API rc_status rc_surface_spectral(const rc_surface_spectral_spec *spec, double *out);

enum {
  RC_SURFACE_PARABOLOID = 1, /* -r^2 / (2 radius) about the grid's centre                                    */
  RC_SURFACE_SPHERE = 2,     /* sqrt(radius^2 - r^2) - radius about the grid's centre, -radius where r > radius */
  RC_SURFACE_WAVES = 3,      /* height cos(2 pi x / period_x) cos(2 pi y / period_y); a period of 0: no waves along it */
  RC_SURFACE_PYRAMIDS = 4,   /* square pyramids of this height: height min(t(x / period_x), t(y / period_y)), t a triangle
                                wave from 0 to 1 with t(0) = 1; a period of 0: ridges                        */
  RC_SURFACE_NOISE = 5       /* independent Gaussian heights, standard deviation height                      */
};
typedef struct rc_surface_shape_spec {
  size_t struct_size;  /* sizeof(rc_surface_shape_spec)                                                      */
  int32_t shape;       /* RC_SURFACE_*                                                                      */
  int32_t reserved;    /* 0                                                                                 */
  uint64_t seed;       /* NOISE                                                                             */
  int64_t nx, ny;      /* points, >= 1; point (ix, iy) lies at x = ix hx, y = iy hy                          */
  double hx, hy;       /* pitch [length], 1e-60 .. 1e60                                                      */
  double radius;       /* PARABOLOID, SPHERE [length], > 0                                                   */
  double height;       /* WAVES: amplitude; PYRAMIDS: base to tip; NOISE: rms [length]; > 0                  */
  double period_x, period_y; /* WAVES, PYRAMIDS [length], >= 0, not both 0                                   */
} rc_surface_shape_spec;
#define RC_SURFACE_SHAPE_SPEC_INIT \
  { sizeof(rc_surface_shape_spec), RC_SURFACE_PARABOLOID, 0, 1, 256, 256, 1.0, 1.0, 1.0, 1.0, 0.0, 0.0 }

/** out [nx*ny] heights. Errors: ARGUMENT, SHAPE. */
RC_API rc_status rc_surface_shape(const rc_surface_shape_spec *spec, double *out);
/** @} */

/** @defgroup analyze Analysis  @{ */

enum { RC_SURFACE_TREND_AUTO = 0, RC_SURFACE_TREND_MEAN = 1, RC_SURFACE_TREND_PLANE = 2 };
/** A surface to be analysed; heights are only read. */
typedef struct rc_surface_map {
  size_t struct_size;    /* sizeof(rc_surface_map)                                                           */
  int64_t nx, ny;        /* points, >= 1                                                                    */
  double hx, hy;         /* pitch [length], 1e-60 .. 1e60                                                    */
  const double *heights; /* [nx*ny] finite                                                                   */
  int32_t periodic;      /* 1: the surface repeats: no window, differences across the edges                  */
  int32_t trend;         /* RC_SURFACE_TREND_*, removed first; AUTO: the mean if periodic, else the plane    */
} rc_surface_map;
#define RC_SURFACE_MAP_INIT \
  { sizeof(rc_surface_map), 1, 1, 1.0, 1.0, NULL, 0, RC_SURFACE_TREND_AUTO }

/** Moments of the heights less their trend. Slopes are forward differences, second derivatives central ones. NaN where a
 *  number has no meaning (the skewness of a flat surface). */
typedef struct rc_surface_statistics {
  size_t struct_size;
  double rms_height;           /* Sq: root of the mean square over all points [length]                       */
  double skewness, kurtosis;   /* Ssk, Sku (ISO 25178): third and fourth moment over powers of Sq; 0 and 3 for a Gaussian */
  double highest, lowest;      /* above the trend [length]                                                   */
  double rms_slope;            /* root of rms_slope_x^2 + rms_slope_y^2                                       */
  double rms_slope_x, rms_slope_y;
  double rms_curvature;        /* of the mean curvature (zxx + zyy) / 2 [1/length]                           */
  double m0, m2, m4;           /* spectral moments of a profile, averaged over x and y (McCool 1987): mean squares of
                                  height, slope and second derivative                                        */
  double nayak;                /* Nayak's bandwidth parameter m0 m4 / m2^2                                   */
} rc_surface_statistics;
#define RC_SURFACE_STATISTICS_INIT RC_BEGIN(rc_surface_statistics)

/** Errors: ARGUMENT (heights that are not finite: how many and where the first is), SHAPE, MEMORY. */
RC_API rc_status rc_surface_analyze(const rc_surface_map *map, rc_surface_statistics *out);

/** Radial average of the PSD in rings of width 2 pi / max(nx hx, ny hy): mean wave number q, mean PSD and number of modes,
 *  each [*count], q increasing, the mean left out: sum of modes * psd / (nx hx ny hy) is the variance. Maps that are not
 *  periodic are multiplied by a Hann window in x and y, after its weighted mean was taken off, and divided by the
 *  window's rms: the variance is then the one weighted by the window's square.
 *  *count: capacity of the arrays in, number of rings out. With q, psd and modes NULL only *count is written.
 *  Errors: ARGUMENT (capacity too small), SHAPE, MEMORY. Non-powers of two cost some five times more. */
RC_API rc_status rc_surface_psd(const rc_surface_map *map, double *q, double *psd, int64_t *modes, int64_t *count);

/** Features of the spectrum, from the radial PSD in bins of a quarter octave up to pi / max(hx, hy). */
#define RC_SURFACE_PEAKS 4
typedef struct rc_surface_power_law {
  size_t struct_size;
  double hurst;         /* of the longest power-law range; outside 0 .. 1 the surface is not self-affine; NaN where there
                           is none of at least half a decade                                                 */
  double hurst_error;   /* half of the 95 % confidence interval                                              */
  double slope;         /* exponent of C ~ q^slope in the range                                              */
  double prefactor;     /* C = prefactor q^slope [length^4 with q in 1/length]                                */
  double q_min, q_max;  /* the range [1/length]; NaN where there is none                                     */
  double q_rolloff;     /* below it the PSD is flat; NaN: none seen                                          */
  double q_cutoff;      /* above it the PSD falls faster than the power law, or is 0; NaN: none seen         */
  int64_t peaks;        /* number of periodic textures found, 0 .. RC_SURFACE_PEAKS, the strongest first     */
  double peak_qx[RC_SURFACE_PEAKS], peak_qy[RC_SURFACE_PEAKS]; /* wave vectors [1/length]                     */
  double peak_share[RC_SURFACE_PEAKS];                         /* of the variance                            */
} rc_surface_power_law;
#define RC_SURFACE_POWER_LAW_INIT RC_BEGIN(rc_surface_power_law)

/** Errors: as rc_surface_analyze; ARGUMENT for a flat map. */
RC_API rc_status rc_surface_fit(const rc_surface_map *map, rc_surface_power_law *out);

/** Whether cascade multi-resolution (Bemporad & Paggi 2015, section 5) without a check of omitted points can be trusted
 *  on this surface. It finds contacts only near contacts of a coarser grid. The criterion is the share of the roughness *within
 *  reach of the other body* that the coarsest grid does not resolve: over the points higher than max - approach, the
 *  variance that block means leave out, divided by the variance of the heights. */
typedef struct rc_surface_cmr {
  size_t struct_size;
  int32_t trustworthy;      /* 1: unresolved <= limit                                                        */
  int32_t levels;           /* halvings of the grid, as asked                                                */
  int32_t safe_levels;      /* the largest number of halvings, up to levels, for which it is trustworthy      */
  int32_t reserved;
  double unresolved;        /* share within reach that the coarsest grid does not resolve; about 0 .. 1.5     */
  double limit;             /* 0.5, from trials: see docs/surfaces.md                                          */
  double unresolved_overall; /* the same share over the whole surface                                        */
  double peak_loss;         /* by how much sub-sampling lowers the highest point, over the approach          */
  double approach;          /* [length], as used                                                             */
  double coarsest_pitch;    /* the larger one [length]                                                       */
  char reason[400];         /* the advice in words, with the numbers                                         */
} rc_surface_cmr;
#define RC_SURFACE_CMR_INIT \
  { sizeof(rc_surface_cmr), 0, 0, 0, 0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, "" }

/** levels >= 1 halvings, such that at least 4 points remain along the longer side; approach: of the other body from the
 *  highest point [length], 0: (highest - mean)/2 as in the paper. Errors: as rc_surface_fit. */
RC_API rc_status rc_surface_cmr_advice(const rc_surface_map *map, int32_t levels, double approach, rc_surface_cmr *out);

enum { RC_SURFACE_SUBSAMPLE = 1, RC_SURFACE_MEAN = 2, RC_SURFACE_MAX = 3 };
/** Halves a grid: blocks of 2 x 2 points become one, at odd sizes the last blocks are smaller. SUBSAMPLE takes the point at
 *  even ix and iy (or the next of the block that is not masked), MEAN the mean, MAX the highest. heights [nx*ny]; mask
 *  [nx*ny] or NULL, 0: the point is not there and its height not read; out and out_mask (may be NULL)
 *  [((nx+1)/2) * ((ny+1)/2)]: a coarse point is masked, with height NaN, where all of its block are.
 *  Errors: ARGUMENT, SHAPE, MEMORY. */
RC_API rc_status rc_surface_downsample(int64_t nx, int64_t ny, const double *heights, const uint8_t *mask, int32_t filter,
                                       double *out, uint8_t *out_mask);
/** @} */

#ifdef __cplusplus
}
#endif
#endif

/* steel OUT.law: the contact law of a rough patch, steel on steel. 256 x 256 points 1 um apart, rms slope 0.05; units mm, N, MPa.
 */
#include <math.h>
#include <roughcontact/law.h>
#include <stdio.h>

enum { N = 256 };

int main(int argc, char** argv) {
  static double heights[N * N], gap[N * N];
  const double step = 1e-3, pi = 3.14159265358979;
  double slope2 = 0;
  if (argc != 2) return fprintf(stderr, "steel OUT.law\n"), 2;
  /* Waves that repeat with the patch, of 1 to 32 periods across it; amplitudes of a self-affine surface that rolls off at 4
     periods, phases pseudo-random. */
  unsigned seed = 1;
  for (int kx = -32; kx <= 32; ++kx)
    for (int ky = 0; ky <= 32; ++ky) {
      const double k = hypot(kx, ky);
      if (k < 1 || k > 32) continue;
      seed = seed * 1664525u + 1013904223u;
      const double phase = 2 * pi * (seed >> 8) / 16777216., amplitude = pow(fmax(k, 4), -1.8), q = 2 * pi * k / (N * step);
      slope2 += amplitude * amplitude * q * q / 2;
      for (int j = 0; j < N; ++j)
        for (int i = 0; i < N; ++i) heights[j * N + i] += amplitude * cos(2 * pi * (kx * i + ky * j) / N + phase);
    }
  for (int i = 0; i < N * N; ++i) heights[i] *= 0.05 / sqrt(slope2);
  rc_gap_from_heights(N * N, RC_IN(heights), RC_IN(NULL), RC_OUT(gap));

  rc_system system = RC_SYSTEM_INIT;
  system.boundary = RC_BOUNDARY_PERIODIC;
  system.nx = system.ny = N;
  system.hx = system.hy = step;
  system.modulus = 210000 / (2 * (1 - 0.3 * 0.3)); /* both bodies of steel */
  rc_law_spec spec = RC_LAW_SPEC_INIT;
  spec.undeformed_gap = RC_IN(gap);
  spec.p_lower = 1;
  spec.p_upper = 500;
  rc_law* law = NULL;
  const rc_status status = rc_law_create(&system, NULL, &spec, &law);
  if (!law || rc_law_save(law, argv[1])) return fprintf(stderr, "%s\n", rc_last_error()), 1;
  rc_law_info info = RC_LAW_INFO_INIT;
  rc_law_describe(law, &info);
  printf("%lld nodes, pressure within %.2g %% from %g to %g MPa%s\n", (long long)info.nodes, 100 * info.width, info.p_lower,
         info.p_upper, status == RC_OK ? "" : " (by estimate)");
  rc_law_destroy(law);
  return 0;
}

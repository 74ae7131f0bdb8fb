/* surfaces FILE: makes a surface by FFTs and Gaussian numbers, finds its statistics, and reads FILE; 1 where one of them is not
 * as it should be. For systems whose Python is not to be had. */
#include <math.h>
#include <roughcontact/formats.h>
#include <roughcontact/surface.h>
#include <stdio.h>

enum { N = 64 };

int main(int count, char** words) {
  static double heights[N * N];
  double squares = 0;
  rc_surface_spectral_spec spec = RC_SURFACE_SPECTRAL_SPEC_INIT;
  rc_surface_file file = RC_SURFACE_FILE_INIT;
  if (count != 2) return fprintf(stderr, "surfaces FILE\n"), 2;
  spec.nx = spec.ny = N;
  spec.fixed_amplitudes = 1;
  if (rc_surface_spectral(&spec, heights) != RC_OK) return fprintf(stderr, "%s\n", rc_surface_last_error()), 1;
  for (int i = 0; i < N * N; ++i) squares += heights[i] * heights[i] / (N * N);
  if (fabs(squares - 1) > 1e-9) return fprintf(stderr, "heights of mean square %g instead of 1\n", squares), 1;
  if (rc_surface_read(words[1], NULL, &file) != RC_OK) return fprintf(stderr, "%s\n", rc_surface_read_last_error()), 1;
  printf("read %lld x %lld points of format %s\n", (long long)file.nx, (long long)file.ny, file.format);
  const int sized = file.nx * file.ny > 1;
  rc_surface_file_free(&file);
  return sized ? 0 : 1;
}

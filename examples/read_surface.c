/* Reads a surface file, fills its missing points, takes its tilt off, and prints what it is. read_surface FILE [PITCH], the pitch
 * in metres where the file does not say it. Needs libroughcontact-formats. */
#include <roughcontact/formats.h>
#include <stdio.h>
#include <stdlib.h>

static int failed(void) {
  fprintf(stderr, "%s\n", rc_surface_read_last_error());
  return 1;
}

int main(int count, char** arguments) {
  if (count < 2) return fprintf(stderr, "usage: read_surface FILE [PITCH]\n"), 2;
  rc_surface_read_spec spec = RC_SURFACE_READ_SPEC_INIT;
  if (count > 2) spec.hx = spec.hy = strtod(arguments[2], NULL);
  rc_surface_file file = RC_SURFACE_FILE_INIT;
  if (rc_surface_read(arguments[1], &spec, &file) != RC_OK) return failed();

  rc_status status = RC_OK;
  if (file.missing > 0 && file.hx > 0) status = rc_surface_fill(file.nx, file.ny, file.hx, file.hy, file.heights);
  if (status == RC_OK) status = rc_surface_remove_form(file.nx, file.ny, RC_SURFACE_FORM_PLANE, file.heights);
  if (status == RC_OK)
    printf("%lld x %lld points, %s, pitch %g m, %g m, %lld missing%s%s\n", (long long)file.nx, (long long)file.ny, file.format,
           file.hx, file.hy, (long long)file.missing, file.assumed[0] ? "; " : "", file.assumed);
  rc_surface_file_free(&file);
  return status == RC_OK ? 0 : failed();
}

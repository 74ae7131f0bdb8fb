/* The numbers of <roughcontact/formats.h>, see golden.h. */
#include <roughcontact/formats.h>

#include "golden.h"

VALUE(RC_SURFACE_FORM_MEAN, 1);
VALUE(RC_SURFACE_FORM_PLANE, 2);
VALUE(RC_SURFACE_FORM_QUADRIC, 3);

SIZE(rc_surface_read_spec, 40);
AT(rc_surface_read_spec, struct_size, 0);
AT(rc_surface_read_spec, format, 8);
AT(rc_surface_read_spec, unit, 16);
AT(rc_surface_read_spec, hx, 24);
AT(rc_surface_read_spec, hy, 32);

SIZE(rc_surface_file, 504);
AT(rc_surface_file, struct_size, 0);
AT(rc_surface_file, nx, 8);
AT(rc_surface_file, ny, 16);
AT(rc_surface_file, hx, 24);
AT(rc_surface_file, hy, 32);
AT(rc_surface_file, heights, 40);
AT(rc_surface_file, missing, 48);
AT(rc_surface_file, periodic, 56);
AT(rc_surface_file, unit_assumed, 60);
AT(rc_surface_file, format, 64);
AT(rc_surface_file, assumed, 96);
AT(rc_surface_file, storage, 496);

SIZE(rc_surface_format, 48);
AT(rc_surface_format, struct_size, 0);
AT(rc_surface_format, name, 8);
AT(rc_surface_format, summary, 16);
AT(rc_surface_format, suffixes, 24);
AT(rc_surface_format, says, 32);
AT(rc_surface_format, by_contents, 40);
AT(rc_surface_format, reserved, 44);

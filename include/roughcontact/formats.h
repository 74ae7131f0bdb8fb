/* roughcontact-formats: surfaces from files of X3P, Digital Surf, SDF, Gwyddion, text and others. A library of its own
 * (libroughcontact-formats), so that a program that only solves contacts does not link libzip, pugixml and zlib. All of them have
 * permissive licences.
 *
 * docs/surface-files.md lists the formats. Lengths are in metres, also of files in other units;
 * heights increase towards the other body, x fastest, point (ix, iy) at index iy*nx + ix.
 *
 * Functions that return an rc_status return RC_OK or a negative one, with the text in rc_surface_read_last_error(). All of them
 * are thread-safe, keep nothing and print nothing. What they write to is written only if RC_OK is returned; arrays are
 * plain pointers, as this library fills the host's memory alone. Sized structs: see roughcontact.h. The memory for a file is
 * limited by its size, not by its header.
 *
 * In builds that read HDF5, calls on such files use libhdf5 one at a time. Its handler of errors and H5PLset_loading_state are as
 * before when a call returns; meanwhile it prints nothing and loads no plugin, in no thread. If libhdf5 is not built for threads
 * (H5is_library_threadsafe), no other thread may call it meanwhile. After some damaged files it prints a line when the process
 * ends.
 */
#ifndef ROUGHCONTACT_FORMATS_H
#define ROUGHCONTACT_FORMATS_H

#include "roughcontact.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The calling thread's last failure in this library, as "where: what, value, limit, what to do"; "" if the last call
 *  returned RC_OK. Valid until the thread's next call. */
RC_API const char *rc_surface_read_last_error(void);

/** @defgroup read Surfaces from files  @{ */

/** Values that override or complete the file. */
typedef struct rc_surface_read_spec {
  size_t struct_size;  /* sizeof(rc_surface_read_spec)                                                       */
  const char *format;  /* name of a format; NULL: by the contents, else by the suffix of the file's name     */
  const char *unit;    /* of lengths whose unit the file does not name, of hx, hy and height_range, as rc_surface_unit knows
                          it; NULL: "m". If the file names the units of all its lengths, it must be theirs       */
  double hx, hy;       /* pitch of a file that has none; a file's own must be the same to 1e-6. Both 0: the file's    */
  double height_range; /* between the values 0 and full_scale of a picture of whole numbers, in `unit`; other files ignore it.
                          0: not given, and such pictures are refused                                        */
} rc_surface_read_spec;
#define RC_SURFACE_READ_SPEC_INIT RC_BEGIN(rc_surface_read_spec)

/** A surface as it was read. Begin with RC_SURFACE_FILE_INIT; rc_surface_file_free frees the memory that a call has allocated. */
typedef struct rc_surface_file {
  size_t struct_size;  /* sizeof(rc_surface_file)                                                            */
  int64_t nx, ny;      /* points                                                                            */
  double hx, hy;       /* pitch [m]; 0 if neither the file nor the caller has one                            */
  double *heights;     /* [nx*ny] [m], NaN where a point is missing; the caller may change them              */
  int64_t missing;     /* points                                                                            */
  int32_t periodic;    /* 1: the surface repeats; 0: the file says that it does not; -1: the file does not say */
  int32_t unit_assumed; /* 1: the file does not name the units of all its lengths, and none was given: m is taken    */
  char format[32];     /* name of the format that was recognised                                             */
  char assumed[400];   /* assumptions about what the file leaves open, one sentence after the other; "" if none       */
  void *storage;       /* the library's own                                                                 */
  double full_scale;   /* the largest value of a picture of whole numbers: 255, 65535; 0: heights have a scale       */
} rc_surface_file;
#define RC_SURFACE_FILE_INIT \
  { sizeof(rc_surface_file), 0, 0, 0.0, 0.0, NULL, 0, -1, 0, "", "", NULL, 0.0 }

/** Reads the first map of a file. spec: NULL is RC_SURFACE_READ_SPEC_INIT. *out is overwritten, and its earlier memory is not
 *  freed. Errors: ARGUMENT (also a file that cannot be opened, is damaged or of no known format; a unit that is no
 *  length; a unit or pitch that contradicts the file), MEMORY. */
RC_API rc_status rc_surface_read(const char *path, const rc_surface_read_spec *spec, rc_surface_file *out);

/** The same for a file in memory, data [size], which is only read. name: NULL, or the file's name, for its suffix and for
 *  messages. */
RC_API rc_status rc_surface_read_memory(const void *data, size_t size, const char *name, const rc_surface_read_spec *spec,
                                        rc_surface_file *out);

/** Frees the memory that a call has allocated, and resets the struct except its struct_size. NULL and new structs are allowed. */
RC_API void rc_surface_file_free(rc_surface_file *file);

/** Metres per unit of length: "m" with any SI prefix, "A" (angstrom), "micron", or such a name spelt out ("millimetres").
 *  Errors: ARGUMENT (the name is no length). */
RC_API rc_status rc_surface_unit(const char *name, double *metres);

/** A format that can be read. The texts live as long as the library. */
typedef struct rc_surface_format {
  size_t struct_size;
  const char *name;      /* of rc_surface_read_spec.format                                                   */
  const char *summary;
  const char *suffixes;  /* separated by spaces, ".txt .csv"                                                  */
  const char *says;      /* the lengths that such a file contains: "pitch and unit"                          */
  int32_t by_contents;   /* 1: recognised by its contents; 0: by the suffix                                   */
  int32_t reserved;
} rc_surface_format;
#define RC_SURFACE_FORMAT_INIT RC_BEGIN(rc_surface_format)

RC_API int64_t rc_surface_format_count(void);

/** index: 0 .. count - 1. Errors: ARGUMENT. */
RC_API rc_status rc_surface_format_describe(int64_t index, rc_surface_format *out);
/** @} */

/** @defgroup prepare Heights before they are pressed  @{ */

enum { RC_SURFACE_FORM_MEAN = 1, RC_SURFACE_FORM_PLANE = 2, RC_SURFACE_FORM_QUADRIC = 3 };

/** Subtracts the least-squares fit of 1, of 1, x, y, or of 1, x, y, x^2, xy, y^2 from heights [nx*ny], over the points that are
 *  not NaN. Errors: ARGUMENT, SHAPE, MEMORY. */
RC_API rc_status rc_surface_remove_form(int64_t nx, int64_t ny, int32_t form, double *heights);

/** Gives every height [nx*ny] that is NaN the mean of its four neighbours, weighted by 1/pitch^2, as a soap film spans a hole:
 *  filled heights lie between those around the hole. What was in the hole is unknown, so contact there is a guess.
 *  Errors: ARGUMENT (also where all are NaN, or more than 2^23), SHAPE, MEMORY. */
RC_API rc_status rc_surface_fill(int64_t nx, int64_t ny, double hx, double hy, double *heights);

/** Gives every spike of heights [nx*ny] the value NaN. r is the height less the median of the heights, not NaN, of the 5 x 5
 *  points around; edges are reflected (... 1 0 | 0 1 2 ...). A spike has |r| > factor * (median of all |r|), factor > 0; if that
 *  median is 0 there is none. *spikes: how many; *largest: the largest |r| of them, 0 without; either may be NULL.
 *  Errors: ARGUMENT, SHAPE, MEMORY. */
RC_API rc_status rc_surface_despike(int64_t nx, int64_t ny, double factor, double *heights, int64_t *spikes, double *largest);

/** Keeps the points of heights [*nx * *ny] whose cells have their middles in x0 .. x1 and y0 .. y1, which count from the outer edge
 *  of the first cell [unit of hx, hy]: writes them to the beginning of heights, and their numbers to *nx and *ny. The map no
 *  longer repeats. Errors: ARGUMENT (also a region without any middle), SHAPE, MEMORY. */
RC_API rc_status rc_surface_crop(int64_t *nx, int64_t *ny, double hx, double hy, double x0, double x1, double y0, double y1,
                                 double *heights);

enum { RC_SURFACE_MIRROR_X = 1, RC_SURFACE_MIRROR_Y = 2 };

/** Reverses the order of heights [nx*ny] along x, y, or both (the sum), as a body that is turned over shows them; no height
 *  changes. Errors: ARGUMENT, SHAPE, MEMORY. */
RC_API rc_status rc_surface_mirror(int64_t nx, int64_t ny, int32_t axes, double *heights);

enum { RC_SURFACE_LINEAR = 1, RC_SURFACE_CUBIC = 2 };

/** A map and another grid. Begin with RC_SURFACE_RESAMPLING_INIT. */
typedef struct rc_surface_resampling {
  size_t struct_size;
  int64_t nx, ny;        /* of the map                                                                               */
  double hx, hy;         /* its pitch [length]                                                                       */
  const double *heights; /* [nx*ny], NaN where missing                                                               */
  int32_t periodic;      /* 1: the map repeats, and has heights everywhere; 0: not beyond its first and last points  */
  int32_t interpolation; /* RC_SURFACE_LINEAR, or _CUBIC: convolution with a = -1/2, at edges the parabola's continuation
                            (Keys 1981, equations 15 and 19); linear along an axis of two points. Exact at the map's points */
  int64_t to_nx, to_ny;  /* points of the other grid                                                                 */
  double to_hx, to_hy;   /* its pitch [length], at most 1.5 times the map's: a coarser grid would skip its summits   */
  double x0, y0;         /* place of its first point, from the map's first [length]                                  */
  double *to;            /* out [to_nx*to_ny]: NaN outside of the map, and where a missing height takes part; no part of
                            heights                                                                                  */
  int64_t missing;       /* out: points that are NaN                                                                 */
} rc_surface_resampling;
#define RC_SURFACE_RESAMPLING_INIT RC_BEGIN_WITH(rc_surface_resampling, interpolation = RC_SURFACE_CUBIC)

/** Heights at the points of another grid. Errors: ARGUMENT, SHAPE, MEMORY. */
RC_API rc_status rc_surface_resample(rc_surface_resampling *resampling);

/** Moves a map on its grid: heights(x, y) becomes heights(x - dx, y - dy), by rc_surface_resample. *missing: points that are NaN
 *  afterwards; may be NULL. Errors: ARGUMENT, SHAPE, MEMORY. */
RC_API rc_status rc_surface_shift(int64_t nx, int64_t ny, double hx, double hy, double dx, double dy, int32_t periodic,
                                  int32_t interpolation, double *heights, int64_t *missing);
/** @} */

#ifdef __cplusplus
}
#endif
#endif

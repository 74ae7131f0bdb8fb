/* roughcontact-formats: surfaces from the files of instruments and programs. A library of its own (libroughcontact-formats),
 * so that a program that only solves contacts does not link libzip, pugixml and zlib. All of them have permissive licences.
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
  const char *unit;    /* of lengths whose unit the file does not name, and of hx and hy, as rc_surface_unit knows it;
                          NULL: "m". If the file names the units of all its lengths, it must be theirs       */
  double hx, hy;       /* pitch of a file that has none; a file's own must be the same to 1e-6. Both 0: the file's    */
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
} rc_surface_file;
#define RC_SURFACE_FILE_INIT \
  { sizeof(rc_surface_file), 0, 0, 0.0, 0.0, NULL, 0, -1, 0, "", "", NULL }

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
/** @} */

#ifdef __cplusplus
}
#endif
#endif

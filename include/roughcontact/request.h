/* roughcontact-request: the words of a user, read once for every program. Words go in, key and value with units, as do maps in
 * memory; a problem comes out: the system, the surface as it is pressed, targets, and remarks on what was assumed. A library of its
 * own (libroughcontact-request) over libroughcontact and libroughcontact-formats, under the licence of both.
 *
 * docs/words.md lists the words. Lengths come out in metres, pressures in Pa, forces in N, unless no word, map or file has a unit
 * and RC_NUMBERS_OWN is asked for: then they stay in the caller's consistent set of units.
 *
 * Functions that return an rc_status return RC_OK or a negative one, with the text in rc_request_last_error(). All of them are
 * thread-safe, keep nothing and print nothing. What they write to is written only if RC_OK is returned. Sized structs: see
 * roughcontact.h.
 */
#ifndef ROUGHCONTACT_REQUEST_H
#define ROUGHCONTACT_REQUEST_H

#include "formats.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The calling thread's last failure in this library, for the user: "word: value, what is expected"; "" if the last call
 *  returned RC_OK. Valid until the thread's next call. */
RC_API const char *rc_request_last_error(void);

/** @defgroup words The words  @{ */

/* Calls that take words; bits of rc_word.calls. */
enum {
  RC_CALL_SOLVE = 1,    /* one step                                                                                  */
  RC_CALL_HISTORY = 2,  /* steps in order                                                                            */
  RC_CALL_BATCH = 4,    /* many contacts                                                                             */
  RC_CALL_LAW = 8,      /* a contact law between two pressures                                                       */
  RC_CALL_ANALYZE = 16, /* parameters of the surface; nothing presses                                                */
  RC_CALL_ROWS = 32     /* a history of which the caller has some rows                                               */
};

/* The value of a word. */
enum {
  RC_WORD_MAP = 1,      /* heights: a file's name, or an rc_map                                                      */
  RC_WORD_LENGTH = 2,
  RC_WORD_PRESSURE = 3,
  RC_WORD_FORCE = 4,
  RC_WORD_SHARE = 5,    /* "10%" or 0.1                                                                              */
  RC_WORD_NUMBER = 6,
  RC_WORD_NAME = 7,     /* one of rc_word.choices, or any where there are none                                       */
  RC_WORD_SHAPE = 8,    /* "sphere:R=1mm", or an rc_map                                                              */
  RC_WORD_OPTION = 9,   /* of the library, see rc_component_describe                                                 */
  RC_WORD_TIME = 10
};

/** A word. The texts live as long as the library. */
typedef struct rc_word {
  size_t struct_size;
  const char *name;      /* "missing"                                                                                */
  const char *group;     /* heading in a list of words                                                               */
  const char *form;      /* of the value: "LENGTH"                                                                   */
  const char *help;      /* a sentence, with the default                                                             */
  const char *choices;   /* separated by spaces: "reject fill exclude"; "": it has none                              */
  const char *example;   /* a value                                                                                  */
  const char *why_not;   /* why the calls that do not take it do not; "": all take it                                */
  int32_t kind;          /* RC_WORD_*                                                                                */
  int32_t most;          /* numbers that it takes                                                                    */
  int32_t calls;         /* RC_CALL_* that take it                                                                   */
  int32_t reserved;
} rc_word;
#define RC_WORD_INIT RC_BEGIN(rc_word)

RC_API int64_t rc_word_count(void);

/** index: 0 .. count - 1. Errors: ARGUMENT. */
RC_API rc_status rc_word_describe(int64_t index, rc_word *out);
/** @} */

/** @defgroup request From words to a problem  @{ */

/** A word and its value: a text as users write it, or numbers [n] without a unit. */
typedef struct rc_given {
  const char *word;
  const char *text;      /* NULL: numbers                                                                            */
  const double *numbers;
  int64_t n;
} rc_given;

/** Heights in memory, in place of a file, or the contents of a file. heights and mask are read until the request is destroyed. */
typedef struct rc_map {
  size_t struct_size;
  const char *word;      /* "surface", "against", "shape", "gap": undeformed gaps, or "maps": of a budget            */
  const double *heights; /* [maps*ny*nx], NaN: missing. NULL: the caller has them, and asks for the rest             */
  const uint8_t *mask;   /* [maps*ny*nx], 0: the point carries no pressure, whatever its height; NULL: none          */
  int64_t nx, ny;        /* of contents those of the mask, if there is one                                           */
  int64_t maps;          /* surfaces on one grid, of a batch; 0 counts as 1                                          */
  double hx, hy;         /* pitch; each 0: by the word pitch                                                         */
  const char *unit;      /* of heights and hx, hy; NULL: not known                                                   */
  const void *contents;  /* [size] of a file, in place of heights; NULL: none                                        */
  size_t size;
  const char *name;      /* of that file, for its suffix and for messages; NULL: it has none                         */
  int32_t periodic;      /* 1: the surface repeats; 0: it does not; -1: not known                                    */
  int32_t rounded;       /* 1: hx, hy are rounded, and the word pitch may differ from them by a thousandth           */
} rc_map;
#define RC_MAP_INIT RC_BEGIN_WITH(rc_map, periodic = -1)

/* The unit of numbers that have none. */
enum {
  RC_NUMBERS_SI = 0,     /* m, Pa and N; lengths by the word unit; and a remark says so                              */
  RC_NUMBERS_OWN = 1     /* the caller's consistent set, until a text, map or file has a unit: then m, Pa and N      */
};
/* How words are spelt in messages. */
enum {
  RC_SPELLING_PLAIN = 0,   /* nu2, missing fill                                                                      */
  RC_SPELLING_OPTION = 1,  /* --nu2, --missing fill                                                                  */
  RC_SPELLING_KEYWORD = 2, /* nu2, missing='fill', heights for surface                                               */
  RC_SPELLING_FIELD = 3    /* opts.nu2, opts.missing = 'fill'                                                        */
};

typedef struct rc_request_spec {
  size_t struct_size;
  int32_t call;            /* one RC_CALL_*                                                                          */
  int32_t numbers;         /* RC_NUMBERS_*                                                                           */
  int32_t spelling;        /* RC_SPELLING_*                                                                          */
  int32_t reserved;
  const rc_given *words;   /* [n_words]                                                                              */
  int64_t n_words;
  const rc_map *maps;      /* [n_maps], with one struct_size                                                         */
  int64_t n_maps;
  const rc_system *system; /* of the caller's: its grid, pitch, boundary and elasticity then hold; NULL: none        */
  rc_context *context;     /* whose options and kernels; NULL: the default one                                       */
} rc_request_spec;
#define RC_REQUEST_SPEC_INIT RC_BEGIN(rc_request_spec)

typedef struct rc_request rc_request; /* owns what it gives. Read by any thread.                                     */

/** Reads the words and maps. Words that the table does not have are options of the library, with -, _ and . as one letter.
 *  Wrong words are refused before a file is read, in the table's order. Errors: ARGUMENT (also of a file), SHAPE, OPTION,
 *  MEMORY. */
RC_API rc_status rc_request_create(const rc_request_spec *spec, rc_request **out);
RC_API void rc_request_destroy(rc_request *request);

/** What the words mean. Pointers are the request's, or the caller's heights and mask where no word changes them. */
typedef struct rc_problem_view {
  size_t struct_size;
  rc_system system;        /* a half-space, or the caller's; ANALYZE: the grid and its boundary                      */
  const double *heights;   /* [maps*ny*nx] as pressed; NULL where the caller has them                                */
  const uint8_t *mask;     /* [maps*ny*nx], 0: excluded, and the height may be NaN; NULL: none is                    */
  int64_t maps;
  int64_t missing;         /* points without a height before they were filled or excluded                            */
  const char *loading;     /* "approach", "load", "pressure", "area", "closing-pressure"; NULL: nothing presses      */
  const double *targets;   /* [n] of it                                                                              */
  int64_t n;
  double metres;           /* that a length of the caller's counts: of a gap, and of later lengths without a unit    */
  int32_t si;              /* 1: m, Pa, N; 0: the caller's set                                                       */
  int32_t periodic;        /* whether the surface repeats: 1, 0, or -1: not known                                    */
  const char *format;      /* of the surface's file; "": none                                                        */
  double viscosity;        /* of the word leak [pressure time]; 0: no leak is asked for                              */
  double pressure_drop;    /* of the same [pressure]                                                                 */
  int32_t along;           /* RC_FLOW_X or RC_FLOW_Y, of the words leak and closing-pressure; 0: neither is given    */
  int32_t reserved;
  const double *times;     /* [n_times] of the steps, for bodies that creep; NULL: none. But for BATCH one for each target */
  int64_t n_times;
} rc_problem_view;
#define RC_PROBLEM_VIEW_INIT RC_BEGIN(rc_problem_view)

/** Errors: ARGUMENT. */
RC_API rc_status rc_request_problem(const rc_request *request, rc_problem_view *out);

/** The options that the words set: those among the words, and what a layer sets. */
RC_API int64_t rc_request_option_count(const rc_request *request);
/** index: 0 .. count - 1. *key, *text: live as long as the request. Errors: ARGUMENT. */
RC_API rc_status rc_request_option(const rc_request *request, int64_t index, const char **key, const char **text);

/** Sets these options. Errors: as rc_options_set_text. */
RC_API rc_status rc_request_options(const rc_request *request, rc_options *into);

/* Remarks. */
enum {
  RC_REMARK_FILE = 1,      /* what a file leaves open or has besides                                                 */
  RC_REMARK_UNIT = 2,      /* m is taken for lengths without a unit                                                  */
  RC_REMARK_BOUNDARY = 3,  /* periodic is taken: neither a word nor a map says it                                    */
  RC_REMARK_ENDS = 4,      /* free is taken, as the map says, or the shape needs                                     */
  RC_REMARK_MISSING = 5,   /* points were filled or excluded: count, ix and iy of the first                          */
  RC_REMARK_SMALL = 6,     /* a pressure below that of any solid: a unit may be missing                              */
  RC_REMARK_CROPPED = 7,   /* points of the map before and after                                                     */
  RC_REMARK_SPIKES = 8,    /* points that were taken out, and the farthest of them from the median                   */
  RC_REMARK_RESAMPLED = 9, /* pitch of the other body before and after                                               */
  RC_REMARK_OVERLAP = 10,  /* points that are left, and the shift                                                    */
  RC_REMARK_PITCH = 11,    /* the file says it: hx, hy                                                               */
  RC_REMARK_LAYER = 12     /* Poisson's ratio of the half-space below it is taken                                    */
};
enum { RC_FACT = 0, RC_ASSUMED = 1, RC_DOUBTFUL = 2 };

typedef struct rc_remark {
  size_t struct_size;
  int32_t code;            /* RC_REMARK_*                                                                            */
  int32_t severity;        /* RC_FACT, RC_ASSUMED or RC_DOUBTFUL                                                     */
  const char *word;        /* that settles it, or ""                                                                 */
  const char *text;        /* for people                                                                             */
  double number[3];
} rc_remark;
#define RC_REMARK_INIT RC_BEGIN(rc_remark)

RC_API int64_t rc_request_remark_count(const rc_request *request);
/** index: 0 .. count - 1. Errors: ARGUMENT. */
RC_API rc_status rc_request_remark(const rc_request *request, int64_t index, rc_remark *out);

/** The note of a result (rc_result.note), with the words that help where it doubts the map: "level them with --remove plane"; and
 *  that the contact of a named shape does not fit on the map under this load. text: [size], cut off where it is too long.
 *  Errors: ARGUMENT. */
RC_API rc_status rc_request_note(const rc_request *request, const char *note, double load, size_t size, char *text);

/** The contact of the smooth body that the word shape names with the half-space: Hertz' for a sphere (Johnson 1985, 4.22 to 4.24)
 *  and a cylinder (4.42 to 4.45), for a wedge 5.5. */
typedef struct rc_smooth {
  size_t struct_size;
  double width;            /* of the contact                                                                         */
  double side;             /* of the map along it; where it is less than width, the map presses as a punch           */
  double max_pressure;     /* NaN for a wedge, where it is infinite                                                  */
  double approach;         /* NaN for a cylinder and a wedge, of which it is not determined                          */
  char remark[160];        /* that the map is too small, for people; ""                                              */
} rc_smooth;
#define RC_SMOOTH_INIT RC_BEGIN(rc_smooth)

/** load: 0 or more. Errors: ARGUMENT (no shape was named, or the system is no homogeneous half-space). */
RC_API rc_status rc_request_smooth(const rc_request *request, double load, rc_smooth *out);
/** @} */

#ifdef __cplusplus
}
#endif
#endif

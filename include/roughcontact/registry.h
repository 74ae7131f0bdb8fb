/* roughcontact: contexts, and the lists of solvers, backends, kernels and options. */
#ifndef ROUGHCONTACT_REGISTRY_H
#define ROUGHCONTACT_REGISTRY_H

#include "roughcontact.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { RC_LOG_INFO = 1, RC_LOG_WARNING = 2 };
typedef void (*rc_log_fn)(int32_t level, const char *message, void *user);

enum {
  RC_CONTEXT_NO_PLUGINS = 1,    /* never load code from disk                                                         */
  RC_CONTEXT_NO_ENVIRONMENT = 2 /* ignore RC_PLUGIN_PATH                                                             */
};

/* Kinds of components that a context lists. */
enum { RC_COMPONENT_SOLVER = 1, RC_COMPONENT_BACKEND = 2, RC_COMPONENT_KERNEL = 3, RC_COMPONENT_OPTION = 4 };
enum { RC_TYPE_INT = 1, RC_TYPE_REAL = 2, RC_TYPE_TEXT = 3 };
/** A component, or an option, which has the members from default_value on. Strings live as long as the context. Components of
 *  plugin.h declare their options as such structs, which live as long as they do; license and origin are then not looked at. */
typedef struct rc_component {
  size_t struct_size;
  const char *name;        /* of an option: its key                                                                  */
  const char *summary;     /* one line                                                                               */
  const char *license;     /* of the component with what it links (SPDX); "" for the library's kernels and options   */
  const char *origin;      /* "built-in" or the file it was loaded from; "" for options                              */
  const char *default_value; /* as text                                                                              */
  const char *choices;     /* TEXT: "a|b|c", NULL: any text                                                          */
  int32_t type;            /* RC_TYPE_*                                                                              */
  int32_t fixed;           /* 1: cannot change after rc_contact_create                                               */
  double minimum, maximum; /* INT and REAL, inclusive                                                                */
} rc_component;
#define RC_COMPONENT_INIT RC_BEGIN(rc_component)

/** @defgroup context Context: the registry  @{ */
/** A registry of its own. flags: RC_CONTEXT_*, or 0. plugin_path: absolute directories with ':' between them, searched before
 *  RC_PLUGIN_PATH and the installed one; relative ones are refused; NULL: none; copied. log, which gets log_user: NULL: silent; the
 *  threads of a batch call it as well, and at the same time. Errors: ARGUMENT, MEMORY. The result is destroyed by the caller. */
RC_API rc_status rc_context_create(uint32_t flags, const char *plugin_path, rc_log_fn log, void *log_user, rc_context **out);
/** NULL is allowed. Contacts and options made from it keep what they need, and may call its log until they are
 *  destroyed. */
RC_API void rc_context_destroy(rc_context *context);
/** How many components of a kind, RC_COMPONENT_*, the context has; 0 for another kind. A NULL context is the default one. The first
 *  call loads every plugin of the search path; files that are refused are reported to the context's log as warnings. A plugin that
 *  itself refuses, for example because the machine has no device, is reported as RC_LOG_INFO. */
RC_API int64_t rc_component_count(rc_context *context, int32_t kind);
/** Component i, 0 .. count-1. Solvers, backends and kernels are sorted by name; options are the core's keys, then those of every
 *  component. Errors: ARGUMENT. */
RC_API rc_status rc_component_describe(rc_context *context, int32_t kind, int64_t i, rc_component *out);
/** RC_OK if this solver can run on this backend for this system and control, RC_CONTROL_*; otherwise the status that
 *  rc_contact_solve would give, with the reason in rc_last_error(). options may be NULL. */
RC_API rc_status rc_pair_supported(rc_context *context, const char *solver, const char *backend, const rc_system *system,
                                   int32_t control, const rc_options *options);
/** Influence coefficients of a kernel of the default context, with the default values of its options: out[iy*nx + ix] = E*
 *  times the deflection [length] at offset (ix*hx, iy*hy) from a cell under unit pressure, for E* = 1. Free boundaries; relative
 *  error <= 1e-12 for the library's kernels. out is a pointer, as in plugin.h, where kernels give these numbers.
 *  Errors: ARGUMENT, SHAPE, OPTION (unknown kernel), INCOMPATIBLE (hx != hy where the kernel needs square cells; not for free
 *  boundaries), NUMERIC and PLUGIN (values that are refused). */
RC_API rc_status rc_kernel_coefficients(const char *kernel, double hx, double hy, int64_t nx, int64_t ny, double *out);
/** @} */

/** @defgroup cores Cores of the process  @{ */
/** Cores that this process may keep busy, 1 .. 1024, the default of option threads in the command and in Python: those that its
 *  threads may run on, or `allowed` if that is above 0; at most the time that control groups grant it (rounded up), and the first
 *  numbers of OMP_THREAD_LIMIT and OMP_NUM_THREADS. Variables that are no lists of whole numbers above 0 are ignored. */
RC_API int64_t rc_usable_cores(int64_t allowed);
/** @} */

#ifdef __cplusplus
}
#endif
#endif

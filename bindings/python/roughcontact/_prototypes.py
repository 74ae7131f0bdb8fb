"""The functions of <roughcontact/roughcontact.h> and <roughcontact/surface.h>: their C declarations and what ctypes makes of
them."""

import ctypes
import re
from typing import Any, Dict, List, Tuple

from ._structs import CALLBACKS, STRUCTS
from ._surface_structs import SURFACE_STRUCTS

CONTACT_FUNCTIONS = """
void rc_version(int32_t *major, int32_t *minor, int32_t *patch, int32_t *abi)
const char *rc_status_name(rc_status status)
const char *rc_status_text(rc_status status)
const char *rc_last_error(void)

void rc_system_init(rc_system *system, size_t struct_size)
void rc_step_init(rc_step *step, size_t struct_size)
void rc_result_init(rc_result *result, size_t struct_size)
void rc_context_config_init(rc_context_config *config, size_t struct_size)
void rc_path_init(rc_path *path, size_t struct_size)
void rc_batch_init(rc_batch *batch, size_t struct_size)
void rc_state_init(rc_state *state, size_t struct_size)
void rc_level_init(rc_level *level, size_t struct_size)
void rc_direct_init(rc_direct *result, size_t struct_size)
void rc_area_init(rc_area *area, size_t struct_size)
void rc_patches_init(rc_patches *patches, size_t struct_size)
void rc_histogram_init(rc_histogram *histogram, size_t struct_size)

rc_status rc_context_create(const rc_context_config *config, rc_context **out)
void rc_context_destroy(rc_context *context)
int64_t rc_backend_count(rc_context *context)
rc_status rc_backend_describe(rc_context *context, int64_t i, rc_component *out)
int64_t rc_solver_count(rc_context *context)
rc_status rc_solver_describe(rc_context *context, int64_t i, rc_component *out)
int64_t rc_kernel_count(rc_context *context)
rc_status rc_kernel_describe(rc_context *context, int64_t i, rc_component *out)
rc_status rc_pair_supported(rc_context *context, const char *solver, const char *backend, const rc_system *system, \
int32_t control, const rc_options *options)
rc_status rc_kernel_coefficients(const char *kernel, double hx, double hy, int64_t nx, int64_t ny, double *out)

rc_status rc_options_create(rc_context *context, rc_options **out)
void rc_options_destroy(rc_options *options)
rc_status rc_options_set_int(rc_options *options, const char *key, int64_t value)
rc_status rc_options_set_real(rc_options *options, const char *key, double value)
rc_status rc_options_set_text(rc_options *options, const char *key, const char *value)
rc_status rc_options_parse(rc_options *options, const char *key, const char *text)
rc_status rc_options_get_int(const rc_options *options, const char *key, int64_t *out)
rc_status rc_options_get_real(const rc_options *options, const char *key, double *out)
rc_status rc_options_get_text(const rc_options *options, const char *key, const char **out)
int64_t rc_options_count(rc_context *context)
rc_status rc_options_describe(rc_context *context, int64_t i, rc_option_spec *out)

rc_status rc_contact_create(const rc_system *system, const rc_options *options, rc_contact **out)
rc_status rc_contact_set_options(rc_contact *contact, const rc_options *options)
rc_status rc_contact_on_progress(rc_contact *contact, rc_progress_fn fn, void *user, int64_t every)
rc_status rc_contact_solve(rc_contact *contact, const rc_step *step, rc_result *result)
rc_status rc_contact_certify(rc_contact *contact, const rc_step *step, rc_result *result)
rc_status rc_contact_solve_path(rc_contact *contact, rc_path *path)
rc_status rc_contact_level(rc_contact *contact, int64_t i, rc_level *out)
rc_status rc_contact_points(rc_contact *contact, int64_t room, int64_t *index, double *p, int64_t *n)
rc_status rc_contact_reset(rc_contact *contact)
rc_status rc_contact_restore(rc_contact *contact, const rc_state *state)
void rc_contact_cancel(rc_contact *contact)
void rc_contact_destroy(rc_contact *contact)
rc_status rc_solve(const rc_system *system, const rc_step *step, const rc_options *options, rc_result *result)
rc_status rc_batch_solve(const rc_system *system, const rc_options *options, rc_batch *batch)

rc_status rc_greedy(int64_t n, const double *H, int64_t ld, const double *u, double *p, double *w, double tol, \
int64_t max_iter, rc_direct *result)
rc_status rc_polonsky_keer(int64_t n, const double *H, int64_t ld, const double *u, double *p, double *w, double tol, \
int64_t max_iter, rc_direct *result)
rc_status rc_nnls(int64_t n, const double *H, int64_t ld, const double *u, double *p, double *w, double tol, \
int64_t max_iter, rc_direct *result)
rc_status rc_gp(int64_t n, const double *H, int64_t ld, const double *u, double *p, double *w, double tol, \
int64_t max_iter, rc_direct *result)
rc_status rc_admm(int64_t n, const double *H, int64_t ld, const double *u, double *p, double *w, double tol, \
int64_t max_iter, rc_direct *result)
rc_status rc_cmr(int64_t nx, int64_t ny, double hx, double hy, double modulus, const double *heights, double delta, \
int64_t levels, double h, const char *inner, double *p, rc_direct *result)

rc_status rc_area_measure(const rc_system *system, const double *p, const uint8_t *mask, rc_area *out)
rc_status rc_patches_find(const rc_system *system, const double *p, const uint8_t *mask, rc_patches *out)
rc_status rc_histogram_fill(const rc_system *system, const double *p, const uint8_t *mask, rc_histogram *out)
"""

SURFACE_FUNCTIONS = """
const char *rc_surface_last_error(void)
rc_status rc_surface_rmd(const rc_surface_rmd_spec *spec, int32_t stage, int32_t crop, double *out)
rc_status rc_surface_spectral(const rc_surface_spectral_spec *spec, double *out)
rc_status rc_surface_shape(const rc_surface_shape_spec *spec, double *out)
rc_status rc_surface_analyze(const rc_surface_map *map, rc_surface_statistics *out)
rc_status rc_surface_psd(const rc_surface_map *map, double *q, double *psd, int64_t *modes, int64_t *count)
rc_status rc_surface_fit(const rc_surface_map *map, rc_surface_power_law *out)
rc_status rc_surface_cmr_advice(const rc_surface_map *map, int32_t levels, double approach, rc_surface_cmr *out)
rc_status rc_surface_downsample(int64_t nx, int64_t ny, const double *heights, const uint8_t *mask, int32_t filter, \
double *out, uint8_t *out_mask)
"""

_SCALARS = {
    "int32_t": ctypes.c_int32,
    "rc_status": ctypes.c_int32,
    "int64_t": ctypes.c_int64,
    "uint8_t": ctypes.c_uint8,
    "size_t": ctypes.c_size_t,
    "double": ctypes.c_double,
}
_NAMED: Dict[str, Any] = {each.__name__: each for each in STRUCTS + SURFACE_STRUCTS}
_NAMED.update(zip(("rc_path_fn", "rc_batch_fn", "rc_progress_fn", "rc_log_fn"), CALLBACKS))
_HANDLES = {"void", "rc_context", "rc_options", "rc_contact"}


def _translate(declaration: str) -> Tuple[str, Any]:
    """(name, ctypes type) of "const double *out" and the like."""
    match = re.fullmatch(r"(?:const )?(\w+) (\**)(\w+)", declaration)
    assert match, declaration
    base, stars, name = match.groups()
    if base == "void" and not stars:
        return name, None
    if base in _HANDLES or base == "char":  # one star is in the type
        kind: Any = ctypes.c_char_p if base == "char" else ctypes.c_void_p
        stars = stars[1:]
    else:
        kind = _SCALARS.get(base) or _NAMED[base]
    for _ in stars:
        kind = ctypes.POINTER(kind)
    return name, kind


def prototypes(declarations: str) -> List[Tuple[str, Any, List[Any]]]:
    """(name, result, arguments) of every function declared."""
    found = []
    for line in declarations.split("\n"):
        if line:
            head, arguments = line[:-1].split("(")
            name, result = _translate(head)
            found.append((name, result, [] if arguments == "void" else [_translate(a)[1] for a in arguments.split(", ")]))
    return found

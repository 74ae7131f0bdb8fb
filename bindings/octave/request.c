#include "request.h"

#include <math.h>
#include <roughcontact/registry.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Keeps the library's text, which lasts only until the next call. */
static rc_status keep_message(rc_request* request, rc_status status) {
  if (status != RC_OK) snprintf(request->message, sizeof request->message, "%s", rc_last_error());
  return status;
}

rc_status rc_request_refuse(rc_request* request, rc_status status, const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(request->message, sizeof request->message, format, arguments);
  va_end(arguments);
  return status;
}

rc_status rc_request_open(rc_request* request, int64_t nx, int64_t ny) {
  const rc_request empty = {RC_SYSTEM_INIT, RC_STEP_INIT, NULL, NULL, NULL, RC_ACCURACY_INIT, NULL, ""};
  *request = empty;
  request->system.nx = nx;
  request->system.ny = ny;
  return keep_message(request, rc_options_create(NULL, &request->options));
}

void rc_request_close(rc_request* request) {
  rc_options_destroy(request->options);
  free(request->explanation);
  free(request->mask);
  free(request->undeformed_gap);
  memset(request, 0, sizeof *request);
}

/* The option whose key is `field` with '_' for '.'; 0 if there is none. The schema lists the core's keys first. */
static int find_option(const char* field, rc_option_spec* spec) {
  const int64_t count = rc_options_count(NULL);
  for (int64_t i = 0; i < count; ++i) {
    spec->struct_size = sizeof *spec;
    if (rc_options_describe(NULL, i, spec) != RC_OK) return 0;
    const char *a = spec->key, *b = field;
    while (*a && (*a == *b || (*a == '.' && *b == '_'))) ++a, ++b;
    if (!*a && !*b) return 1;
  }
  return 0;
}

static rc_status set_target(rc_request* request, int32_t control, double value) {
  if (request->step.control)
    return rc_request_refuse(request, RC_ERR_ARGUMENT, "give one of opts.displacement and opts.load, not both");
  request->step.control = control;
  request->step.target = value;
  return RC_OK;
}

rc_status rc_request_number(rc_request* request, const char* field, double value) {
  if (!strcmp(field, "hx")) return request->system.hx = value, RC_OK;
  if (!strcmp(field, "hy")) return request->system.hy = value, RC_OK;
  if (!strcmp(field, "modulus")) return request->system.modulus = value, RC_OK;
  if (!strcmp(field, "displacement")) return set_target(request, RC_CONTROL_DISPLACEMENT, value);
  if (!strcmp(field, "load")) return set_target(request, RC_CONTROL_LOAD, value);

  rc_option_spec spec;
  if (!find_option(field, &spec)) return keep_message(request, rc_options_set_real(request->options, field, value));
  if (spec.type != RC_TYPE_INT) return keep_message(request, rc_options_set_real(request->options, spec.key, value));
  if (!(fabs(value) <= 9007199254740992.0) || value != floor(value))
    return rc_request_refuse(request, RC_ERR_OPTION, "opts.%s = %g is not an integer", field, value);
  return keep_message(request, rc_options_set_int(request->options, spec.key, (int64_t)value));
}

rc_status rc_request_text(rc_request* request, const char* field, const char* value) {
  if (!strcmp(field, "boundary")) {
    if (!strcmp(value, "free")) return request->system.boundary = RC_BOUNDARY_FREE, RC_OK;
    if (!strcmp(value, "periodic")) return request->system.boundary = RC_BOUNDARY_PERIODIC, RC_OK;
    return rc_request_refuse(request, RC_ERR_ARGUMENT, "opts.boundary = \"%s\" is not known; give \"free\" or \"periodic\"",
                             value);
  }
  rc_option_spec spec;
  return keep_message(request, rc_options_parse(request->options, find_option(field, &spec) ? spec.key : field, value));
}

rc_status rc_request_mask(rc_request* request, int64_t nx, int64_t ny, const uint8_t* mask) {
  if (nx != request->system.nx || ny != request->system.ny)
    return rc_request_refuse(request, RC_ERR_SHAPE, "opts.mask is %lld by %lld, z is %lld by %lld", (long long)nx, (long long)ny,
                             (long long)request->system.nx, (long long)request->system.ny);
  const size_t bytes = (size_t)nx * (size_t)ny;
  free(request->mask);
  request->mask = malloc(bytes ? bytes : 1);
  if (!request->mask) return rc_request_refuse(request, RC_ERR_MEMORY, "out of memory for opts.mask");
  memcpy(request->mask, mask, bytes);
  return RC_OK;
}

rc_status rc_request_solve(rc_request* request, const double* heights, const double* p0, double* p, double* gap,
                           rc_progress_fn interrupted, rc_result* result) {
  if (!request->step.control) return rc_request_refuse(request, RC_ERR_ARGUMENT, "give opts.displacement or opts.load");
  const size_t n = (size_t)request->system.nx * (size_t)request->system.ny;
  request->undeformed_gap = malloc(n ? n * sizeof *heights : 1);
  if (!request->undeformed_gap) return rc_request_refuse(request, RC_ERR_MEMORY, "out of memory for the gap of %zu points", n);
  rc_status status = rc_gap_from_heights((int64_t)n, heights, request->mask, request->undeformed_gap);
  if (status != RC_OK) return keep_message(request, status);
  request->step.undeformed_gap = request->undeformed_gap;
  request->step.mask = request->mask;
  request->step.p0 = p0;
  const rc_result empty = RC_RESULT_INIT;
  *result = empty;
  result->p = p;
  result->gap = gap;

  rc_contact* contact = NULL;
  status = rc_contact_create(&request->system, request->options, &contact);
  if (status == RC_OK) status = rc_contact_on_progress(contact, interrupted, NULL, 1);
  if (status == RC_OK) status = rc_contact_solve(contact, &request->step, result);
  keep_message(request, status);
  const char* why = NULL;
  if (status >= 0 && rc_contact_explain(contact, &why) == RC_OK && (request->explanation = malloc(strlen(why) + 1)))
    strcpy(request->explanation, why);
  if (status >= 0) rc_contact_accuracy(contact, &request->accuracy);
  rc_contact_destroy(contact);
  return status;
}

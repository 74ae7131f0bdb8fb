/* rc_solve as a MEX function, for Octave and for MATLAB. Build, in this folder:
 *   mkoctfile --mex rc_solve.c $(pkg-config --cflags --libs roughcontact) \
 *     -Wl,-rpath,$(pkg-config --variable=libdir roughcontact)                 (Octave)
 *   mex rc_solve.c -I<include> -L<lib> -lroughcontact -lut                    (MATLAB) */
#include <math.h>
#include <mex.h>
#include <roughcontact/derivatives.h>
#include <roughcontact/registry.h>
#include <roughcontact/roughcontact.h>
#include <signal.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

/* The arguments of rc_solve(z, opts). A function that fails returns a status other than RC_OK and sets message. Memory
 * is MEX's, freed when the function ends; the options are the library's, destroyed by close_request. */
typedef struct Request {
  rc_system system; /* z is nx by ny, first index fastest */
  rc_step step;
  rc_options* options;
  uint8_t* mask;        /* NULL: all points */
  rc_accuracy accuracy; /* out */
  rc_gradient gradient; /* of a certified answer, where it is asked for */
  bool asks_gradient;
  mxArray* by_gap;   /* what it writes; NULL: none was computed */
  char* explanation; /* of rc_contact_explain, after a solve */
  char message[1024];
} Request;

/* Whether Ctrl-C was pressed. Neither program documents how a MEX function can ask: these are their own variables for it. */
#ifdef MATLAB_MEX_FILE
extern bool utIsInterruptPending(void);
static int32_t interrupted(const rc_progress* progress, void* user) { return (void)progress, (void)user, utIsInterruptPending(); }
#else
extern sig_atomic_t octave_interrupt_state;
static int32_t interrupted(const rc_progress* progress, void* user) {
  return (void)progress, (void)user, octave_interrupt_state > 0;
}
#endif

/* Keeps the library's text, which lasts only until the next call. */
static rc_status keep_message(Request* request, rc_status status) {
  if (status != RC_OK) snprintf(request->message, sizeof request->message, "%s", rc_last_error());
  return status;
}

/* The own objections of rc_solve, with printf's formats. */
static rc_status refuse(Request* request, rc_status status, const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(request->message, sizeof request->message, format, arguments);
  va_end(arguments);
  return status;
}

static rc_status open_request(Request* request, int64_t nx, int64_t ny) {
  *request = (Request){RC_SYSTEM_INIT, RC_STEP_INIT, NULL, NULL, RC_ACCURACY_INIT, RC_GRADIENT_INIT, false, NULL, NULL, ""};
  request->system.nx = nx;
  request->system.ny = ny;
  return keep_message(request, rc_options_create(NULL, &request->options));
}

static void close_request(Request* request) {
  rc_options_destroy(request->options);
  request->options = NULL;
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

static rc_status set_target(Request* request, int32_t control, double value) {
  if (request->step.control) return refuse(request, RC_ERR_ARGUMENT, "give one of opts.approach and opts.load, not both");
  request->step.control = control;
  request->step.target = value;
  return RC_OK;
}

/* A field of opts: hx, hy, modulus, hardness, approach, load, gradient, dJ_dload, dJ_dapproach, boundary, or an option of the
 * library with '_' for '.'. */
static rc_status set_number(Request* request, const char* field, double value) {
  if (!strcmp(field, "hx")) return request->system.hx = value, RC_OK;
  if (!strcmp(field, "hy")) return request->system.hy = value, RC_OK;
  if (!strcmp(field, "modulus")) return request->system.modulus = value, RC_OK;
  if (!strcmp(field, "hardness")) return request->system.hardness = value, RC_OK;
  if (!strcmp(field, "approach")) return set_target(request, RC_CONTROL_APPROACH, value);
  if (!strcmp(field, "gradient")) return request->asks_gradient = value != 0, RC_OK;
  if (!strcmp(field, "dJ_dload")) return request->gradient.dJ_dload = value, RC_OK;
  if (!strcmp(field, "dJ_dapproach")) return request->gradient.dJ_dapproach = value, RC_OK;
  if (!strcmp(field, "load")) return set_target(request, RC_CONTROL_LOAD, value);

  rc_option_spec spec;
  if (!find_option(field, &spec)) return keep_message(request, rc_options_set_real(request->options, field, value));
  if (spec.type != RC_TYPE_INT) return keep_message(request, rc_options_set_real(request->options, spec.key, value));
  if (!(fabs(value) <= 9007199254740992.0) || value != floor(value))
    return refuse(request, RC_ERR_OPTION, "opts.%s = %g is not an integer", field, value);
  return keep_message(request, rc_options_set_int(request->options, spec.key, (int64_t)value));
}

static rc_status set_text(Request* request, const char* field, const char* value) {
  if (!strcmp(field, "boundary")) {
    static const char* const names[] = {"free", "periodic", "periodic-x", "periodic-y"};
    for (int32_t i = 0; i < 4; ++i)
      if (!strcmp(value, names[i])) return request->system.boundary = RC_BOUNDARY_FREE + i, RC_OK;
    return refuse(request, RC_ERR_ARGUMENT,
                  "opts.boundary = \"%s\" is not known; give \"free\", \"periodic\", \"periodic-x\" or \"periodic-y\"", value);
  }
  rc_option_spec spec;
  return keep_message(request, rc_options_parse(request->options, find_option(field, &spec) ? spec.key : field, value));
}

/* heights have nx*ny values, as has p; gap may be NULL. */
static rc_status solve(Request* request, const double* heights, double* p, double* gap, rc_result* result) {
  if (!request->step.control) return refuse(request, RC_ERR_ARGUMENT, "give opts.approach or opts.load");
  if (!request->system.boundary)
    return refuse(
        request, RC_ERR_ARGUMENT,
        "give opts.boundary: \"periodic\" for a sample of a larger surface, as a map of roughness is; \"free\" for a body "
        "that ends at the grid's edges, as a ball does");
  const size_t n = (size_t)request->system.nx * (size_t)request->system.ny;
  double* undeformed_gap = mxMalloc(n * sizeof *undeformed_gap + 1);
  rc_status status = rc_gap_from_heights((int64_t)n, RC_IN(heights), RC_IN(request->mask), RC_OUT(undeformed_gap));
  if (status != RC_OK) return keep_message(request, status);
  request->step.undeformed_gap = RC_IN(undeformed_gap);
  request->step.mask = RC_IN(request->mask);
  *result = (rc_result)RC_RESULT_INIT;
  result->p = RC_OUT(p);
  result->gap = RC_OUT(gap);

  rc_contact* contact = NULL;
  status = rc_contact_create(&request->system, request->options, &contact);
  if (status == RC_OK) status = rc_contact_on_progress(contact, interrupted, NULL, 1);
  if (status == RC_OK) status = rc_contact_solve(contact, &request->step, result);
  keep_message(request, status);
  const char* why = NULL;
  if (status >= 0 && rc_contact_explain(contact, &why) == RC_OK) request->explanation = strcpy(mxMalloc(strlen(why) + 1), why);
  if (status >= 0) rc_contact_accuracy(contact, &request->accuracy);
  if (status == RC_OK && request->asks_gradient) {
    request->by_gap = mxCreateDoubleMatrix((size_t)request->system.nx, (size_t)request->system.ny, mxREAL);
    request->gradient.dJ_dundeformed_gap = RC_OUT(mxGetPr(request->by_gap));
    const rc_status found = keep_message(request, rc_contact_gradient(contact, &request->gradient));
    if (found != RC_OK && found != RC_STOP_STALLED) status = found;
  }
  rc_contact_destroy(contact);
  return status;
}

/* mexErrMsgIdAndTxt does not return: all that is open is closed first. */
static void check(Request* request, rc_status status) {
  if (status >= 0) return;
  char id[64];
  snprintf(id, sizeof id, "roughcontact:%s", rc_status_name(status));
  close_request(request);
  mexErrMsgIdAndTxt(id, "rc_solve: %s", request->message);
}

/* The values of a real matrix as doubles; memory that is taken for it is MEX's, freed when the function ends. */
static const double* numbers(const mxArray* value) {
  if (mxIsDouble(value) && !mxIsSparse(value)) return mxGetPr(value);
  mxArray *given = (mxArray*)value, *doubles, *full;
  mexCallMATLAB(1, &doubles, 1, &given, "double");
  mexCallMATLAB(1, &full, 1, &doubles, "full");
  return mxGetPr(full);
}

static const double* matrix(Request* request, const char* name, const mxArray* value) {
  if (!(mxIsDouble(value) || mxIsSingle(value)) || mxIsComplex(value) || mxGetNumberOfDimensions(value) != 2)
    check(request, refuse(request, RC_ERR_ARGUMENT, "%s must be a real matrix, double or single", name));
  return numbers(value);
}

static void set_mask(Request* request, const mxArray* value) {
  if (!(mxIsLogical(value) || mxIsNumeric(value)) || mxIsComplex(value) || mxGetNumberOfDimensions(value) != 2)
    check(request, refuse(request, RC_ERR_ARGUMENT, "opts.mask must be a logical matrix"));
  const long long nx = (long long)mxGetM(value), ny = (long long)mxGetN(value);
  if (nx != request->system.nx || ny != request->system.ny)
    check(request, refuse(request, RC_ERR_SHAPE, "opts.mask is %lld by %lld, z is %lld by %lld", nx, ny,
                          (long long)request->system.nx, (long long)request->system.ny));
  const size_t n = mxGetNumberOfElements(value);
  const double* present = numbers(value);
  request->mask = mxMalloc(n + 1);
  for (size_t i = 0; i < n; ++i) request->mask[i] = present[i] != 0;
}

static void set_field(Request* request, const char* field, const mxArray* value) {
  if (value && mxIsChar(value) && mxGetM(value) <= 1) {
    char* text = mxArrayToString(value);
    check(request, set_text(request, field, text ? text : ""));
    mxFree(text);
  } else if (value && (mxIsNumeric(value) || mxIsLogical(value)) && !mxIsComplex(value) && mxGetNumberOfElements(value) == 1) {
    check(request, set_number(request, field, mxGetScalar(value)));
  } else {
    check(request, refuse(request, RC_ERR_ARGUMENT, "opts.%s must be a number or a text", field));
  }
}

static mxArray* gradient_of(const Request* request) {
  static const char* names[] = {"undeformed_gap", "target", "modulus", "error", "undecided", "products"};
  if (!request->by_gap) return NULL;
  const rc_gradient* found = &request->gradient;
  const double numbers[] = {found->dJ_dtarget, found->dJ_dmodulus, found->error, (double)found->undecided,
                            (double)found->products};
  mxArray* gradient = mxCreateStructMatrix(1, 1, sizeof names / sizeof *names, names);
  mxSetField(gradient, 0, names[0], request->by_gap);
  for (size_t i = 0; i < sizeof numbers / sizeof *numbers; ++i)
    mxSetField(gradient, 0, names[i + 1], mxCreateDoubleScalar(numbers[i]));
  return gradient;
}

static mxArray* info_of(const rc_result* result, const Request* request, mxArray* gap) {
  const rc_accuracy* accuracy = &request->accuracy;
  static const char* names[] = {
#define NUMBER(from, name) #name,
#define TEXT(from, name) #name,
#include "result_fields.def"
#undef NUMBER
#undef TEXT
      "status_name", "status_text", "message", "explanation", "gap", "gradient"};
  mxArray* info = mxCreateStructMatrix(1, 1, sizeof names / sizeof *names, names);
#define NUMBER(from, name) mxSetField(info, 0, #name, mxCreateDoubleScalar((double)from->name));
#define TEXT(from, name) mxSetField(info, 0, #name, mxCreateString(from->name));
#include "result_fields.def"
#undef NUMBER
#undef TEXT
  mxSetField(info, 0, "status_name", mxCreateString(rc_status_name(result->status)));
  mxSetField(info, 0, "status_text", mxCreateString(rc_status_text(result->status)));
  mxSetField(info, 0, "message", mxCreateString(request->message));
  mxSetField(info, 0, "explanation", mxCreateString(request->explanation ? request->explanation : ""));
  mxSetField(info, 0, "gap", gap);
  mxSetField(info, 0, "gradient", gradient_of(request));
  return info;
}

void mexFunction(int nlhs, mxArray* plhs[], int nrhs, const mxArray* prhs[]) {
  if (nrhs != 2) mexErrMsgIdAndTxt("roughcontact:RC_ERR_ARGUMENT", "usage: [p, info] = rc_solve(z, opts)");
  const size_t nx = mxGetM(prhs[0]), ny = mxGetN(prhs[0]);
  Request request;
  check(&request, open_request(&request, (int64_t)nx, (int64_t)ny));
  const double* heights = matrix(&request, "z", prhs[0]);
  const struct {
    const char* name;
    rc_const_array* to;
  } fields[] = {{"p0", &request.step.p0}, {"dJ_dp", &request.gradient.dJ_dp}, {"dJ_dgap", &request.gradient.dJ_dgap}};
  if (!mxIsStruct(prhs[1]) || mxGetNumberOfElements(prhs[1]) != 1)
    check(&request, refuse(&request, RC_ERR_ARGUMENT, "opts must be a struct"));
  for (int k = 0; k < mxGetNumberOfFields(prhs[1]); ++k) {
    const char* field = mxGetFieldNameByNumber(prhs[1], k);
    const mxArray* value = mxGetFieldByNumber(prhs[1], 0, k);
    size_t which = 0;
    while (which < 3 && strcmp(field, fields[which].name)) ++which;
    if (value && !strcmp(field, "mask")) {
      set_mask(&request, value);
    } else if (value && which < 3) {
      char name[16];
      snprintf(name, sizeof name, "opts.%s", field);
      *fields[which].to = RC_IN(matrix(&request, name, value));
      if (mxGetM(value) != nx || mxGetN(value) != ny)
        check(&request, refuse(&request, RC_ERR_SHAPE, "%s must have the shape of z", name));
    } else {
      set_field(&request, field, value);
    }
  }

  plhs[0] = mxCreateDoubleMatrix(nx, ny, mxREAL);
  mxArray* gap = nlhs > 1 ? mxCreateDoubleMatrix(nx, ny, mxREAL) : NULL;
  rc_result result;
  const rc_status status = solve(&request, heights, mxGetPr(plhs[0]), gap ? mxGetPr(gap) : NULL, &result);
  if (status == RC_STOP_CANCELLED) {
    close_request(&request);
    mexErrMsgIdAndTxt("roughcontact:RC_STOP_CANCELLED", "rc_solve: interrupted");
  }
  check(&request, status);
  /* A warning may be an error to the user, and not return: everything is given back before. */
  if (gap) plhs[1] = info_of(&result, &request, gap);
  close_request(&request);
  if (status != RC_OK && status != RC_WITHIN_GOAL) {
    char id[64];
    snprintf(id, sizeof id, "roughcontact:%s", rc_status_name(status));
    mexWarnMsgIdAndTxt(id, "rc_solve: %s", request.message);
  }
}

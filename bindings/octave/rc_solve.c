/* rc_solve as a MEX function, for Octave and for MATLAB. Build, in this folder:
 *   mkoctfile --mex rc_solve.c $(pkg-config --cflags --libs roughcontact-request) \
 *     -Wl,-rpath,$(pkg-config --variable=libdir roughcontact)                 (Octave)
 *   mex rc_solve.c -I<include> -L<lib> -lroughcontact-request -lroughcontact-formats -lroughcontact -lut (MATLAB)
 * With -DRC_SOLVE_FLOW and libroughcontact-flow, which is under the GPL, it also has the words leak and closing_pressure. */
#include <math.h>
#include <mex.h>
#include <roughcontact/derivatives.h>
#include <roughcontact/request.h>
#include <signal.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#ifdef RC_SOLVE_FLOW
#include <roughcontact/flow.h>
#endif

/* The arguments of rc_solve(z, opts). A function that fails returns a status other than RC_OK and sets message. Memory
 * is MEX's, freed when the function ends; the options are the library's, destroyed by close_request. */
typedef struct Request {
  rc_map map;      /* z is nx by ny, first index fastest */
  rc_given* words; /* [n] fields of opts that are words or options of the library */
  int64_t n;
  rc_request* request; /* what they mean */
  rc_problem_view view;
  rc_options* options;
  rc_gradient gradient; /* of a certified answer, where it is asked for */
  bool asks_gradient;
  mxArray* by_gap;   /* what it writes; NULL: none was computed */
  mxArray* flow;     /* of the words leak and closing_pressure; NULL: neither is given */
  bool in_time;      /* a word is time or steps: several steps are solved */
  mxArray* history;  /* of them; NULL: one step is solved */
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

/* Keeps a library's text, which lasts only until the next call. */
static rc_status keep(Request* request, rc_status status, const char* text) {
  if (status != RC_OK) snprintf(request->message, sizeof request->message, "%s", text);
  return status;
}
static rc_status keep_message(Request* request, rc_status status) { return keep(request, status, rc_last_error()); }
static rc_status keep_refusal(Request* request, rc_status status) { return keep(request, status, rc_request_last_error()); }

/* The own objections of rc_solve, with printf's formats. */
static rc_status refuse(Request* request, rc_status status, const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(request->message, sizeof request->message, format, arguments);
  va_end(arguments);
  return status;
}

static void close_request(Request* request) {
  rc_options_destroy(request->options);
  rc_request_destroy(request->request);
  request->options = NULL;
  request->request = NULL;
}

/* Reads the words: the problem and the options. */
static rc_status read_words(Request* request) {
  rc_request_spec spec = RC_REQUEST_SPEC_INIT;
  spec.call = request->in_time ? RC_CALL_HISTORY : RC_CALL_SOLVE;
  spec.numbers = RC_NUMBERS_OWN;
  spec.spelling = RC_SPELLING_FIELD;
  spec.words = request->words;
  spec.n_words = request->n;
  spec.maps = &request->map;
  spec.n_maps = 1;
  rc_status status = keep_refusal(request, rc_request_create(&spec, &request->request));
  if (status == RC_OK) status = keep_refusal(request, rc_request_problem(request->request, &request->view));
  if (status == RC_OK) status = keep_message(request, rc_options_create(NULL, &request->options));
  if (status == RC_OK) status = keep_refusal(request, rc_request_options(request->request, request->options));
  return status;
}

/* The request's assumptions and doubts, in MEX's memory; NULL: none. */
static char* remarks_of(const Request* request) {
  char text[1024] = "";
  const int64_t count = rc_request_remark_count(request->request);
  for (int64_t i = 0; i < count; ++i) {
    rc_remark remark = RC_REMARK_INIT;
    if (rc_request_remark(request->request, i, &remark) != RC_OK || remark.severity == RC_FACT) continue;
    const size_t used = strlen(text);
    snprintf(text + used, sizeof text - used, "%s%s", used ? "; " : "", remark.text);
  }
  return *text ? strcpy(mxMalloc(strlen(text) + 1), text) : NULL;
}

/* A struct of numbers, whose names a comma-separated list has. */
static mxArray* struct_of(const char* names, const double* numbers) {
  mxArray* made = mxCreateStructMatrix(1, 1, 0, NULL);
  char name[32];
  for (int read = 0; sscanf(names, " %31[^,]%n", name, &read) == 1; names += *names == ',') {
    mxSetFieldByNumber(made, 0, mxAddField(made, name), mxCreateDoubleScalar(*numbers++));
    names += read;
  }
  return made;
}

/* The leak of an answer; without one the pressure at which the seal closes. */
static rc_status find_flow(Request* request, const rc_step* step, const rc_result* result) {
#ifdef RC_SOLVE_FLOW
  const rc_system* system = &request->view.system;
  rc_flow_spec spec = RC_FLOW_SPEC_INIT;
  spec.along = request->view.along;
  rc_status status;
#ifndef MATLAB_MEX_FILE
  rc_flow_stop_when((const int32_t*)&octave_interrupt_state);
#endif
  if (result) {
    rc_flow_result found = RC_FLOW_RESULT_INIT;
    spec.viscosity = request->view.viscosity;
    spec.pressure_drop = request->view.pressure_drop;
    spec.mask = step->mask;
    status = rc_flow_of_result(system, request->options, result, &spec, &found);
    const double numbers[] = {found.flow,
                              found.lower,
                              found.upper,
                              found.constriction,
                              (double)found.constriction_x + 1,
                              (double)found.constriction_y + 1,
                              found.gap_error,
                              found.seconds};
    request->flow = struct_of("flow,lower,upper,constriction,constriction_x,constriction_y,gap_error,seconds", numbers);
  } else {
    rc_flow_closing found = RC_FLOW_CLOSING_INIT;
    status = rc_flow_closing_pressure(system, request->options, step, &spec, &found);
    const double numbers[] = {found.lower, found.upper, found.area_fraction, found.constriction, found.steps, found.seconds};
    request->flow = struct_of("lower,upper,area_fraction,constriction,steps,seconds", numbers);
  }
  return status == RC_STOP_STALLED ? RC_OK : keep(request, status, rc_flow_last_error());
#else
  (void)step, (void)result;
  return refuse(request, RC_ERR_ARGUMENT, "opts.leak, opts.closing_pressure: compile rc_solve.c with -DRC_SOLVE_FLOW");
#endif
}

/* Numbers of each step: info.history. */
enum { HISTORY_COLUMNS = 6 };
static const char* const history_names[] = {"load", "approach", "mean_pressure", "contact_area", "area_fraction", "status"};

/* Solves the steps in order; p, gap and result are of the last one. A step that is not certified ends them. */
static rc_status solve_steps(Request* request, rc_contact* contact, rc_step step, rc_result* result) {
  const rc_problem_view* const view = &request->view;
  const double share =
      step.control == RC_CONTROL_AREA ? (double)(view->system.nx * view->system.ny) * view->system.hx * view->system.hy : 1;
  double* columns[HISTORY_COLUMNS] = {0};
  if (request->in_time) {
    request->history = mxCreateStructMatrix(1, 1, HISTORY_COLUMNS, (const char**)history_names);
    for (int column = 0; column < HISTORY_COLUMNS; ++column) {
      mxArray* const values = mxCreateDoubleMatrix((size_t)view->n, 1, mxREAL);
      columns[column] = mxGetPr(values);
      for (int64_t k = 0; k < view->n; ++k) columns[column][k] = NAN;
      mxSetField(request->history, 0, history_names[column], values);
    }
    mxArray* const times = mxCreateDoubleMatrix((size_t)view->n_times, 1, mxREAL);
    if (view->n_times > 0) memcpy(mxGetPr(times), view->times, (size_t)view->n_times * sizeof *view->times);
    mxSetFieldByNumber(request->history, 0, mxAddField(request->history, "time"), times);
  }
  rc_status status = RC_OK;
  for (int64_t k = 0; k < view->n && (status == RC_OK || status == RC_WITHIN_GOAL); ++k) {
    step.target = view->targets[k] * share;
    if (view->n_times > 0) step.time = view->times[k];
    status = rc_contact_solve(contact, &step, result);
    step.undeformed_gap = step.mask = step.p0 = (rc_const_array){0};
    if (!request->in_time || status < 0) continue;
    const double numbers[HISTORY_COLUMNS] = {result->load,         result->approach,      result->mean_pressure,
                                             result->contact_area, result->area_fraction, (double)status};
    for (int column = 0; column < HISTORY_COLUMNS; ++column) columns[column][k] = numbers[column];
  }
  return status;
}

/* p has nx*ny values; gap may be NULL. */
static rc_status solve(Request* request, rc_const_array p0, double* p, double* gap, rc_result* result) {
  const rc_system* system = &request->view.system;
  const char* const loading = request->view.loading;
  const int64_t n = system->nx * system->ny;
  double* undeformed_gap = mxMalloc((size_t)n * sizeof *undeformed_gap + 1);
  rc_status status = rc_gap_from_heights(n, RC_IN(request->view.heights), RC_IN(request->view.mask), RC_OUT(undeformed_gap));
  if (status != RC_OK) return keep_message(request, status);
  rc_step step = RC_STEP_INIT;
  step.control = !strcmp(loading, "approach")   ? RC_CONTROL_APPROACH
                 : !strcmp(loading, "load")     ? RC_CONTROL_LOAD
                 : !strcmp(loading, "pressure") ? RC_CONTROL_PRESSURE
                                                : RC_CONTROL_AREA;
  step.undeformed_gap = RC_IN(undeformed_gap);
  step.mask = RC_IN(request->view.mask);
  step.p0 = p0;
  *result = (rc_result)RC_RESULT_INIT;
  result->p = RC_OUT(p);
  result->gap = RC_OUT(gap);

  if (request->view.n == 0) {
    result->status = RC_OK;
    return find_flow(request, &step, NULL);
  }
  rc_contact* contact = NULL;
  status = rc_contact_create(system, request->options, &contact);
  if (status == RC_OK) status = rc_contact_on_progress(contact, interrupted, NULL, 1);
  if (status == RC_OK) status = solve_steps(request, contact, step, result);
  keep_message(request, status);
  const char* why = NULL;
  if (status >= 0 && rc_contact_explain(contact, &why) == RC_OK) request->explanation = strcpy(mxMalloc(strlen(why) + 1), why);
  if (status == RC_OK && request->asks_gradient) {
    request->by_gap = mxCreateDoubleMatrix((size_t)system->nx, (size_t)system->ny, mxREAL);
    request->gradient.dJ_dundeformed_gap = RC_OUT(mxGetPr(request->by_gap));
    const rc_status found = keep_message(request, rc_contact_gradient(contact, &request->gradient));
    if (found != RC_OK && found != RC_STOP_STALLED) status = found;
  }
  rc_contact_destroy(contact);
  if (status >= 0 && status != RC_STOP_CANCELLED && request->view.along != 0) {
    const rc_status found = find_flow(request, &step, result);
    if (found != RC_OK) status = found;
  }
  return status;
}

/* mexErrMsgIdAndTxt does not return: all that is open is closed first. */
static void check(Request* request, rc_status status) {
  if (status >= 0) return;
  char id[64];
  snprintf(id, sizeof id, "roughcontact:%s", rc_status_name(status));
  close_request(request);
  mexErrMsgIdAndTxt(id, "%s", request->message); /* both programs name the function before it */
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
  if (nx != request->map.nx || ny != request->map.ny)
    check(request, refuse(request, RC_ERR_SHAPE, "opts.mask is %lld by %lld, z is %lld by %lld", nx, ny,
                          (long long)request->map.nx, (long long)request->map.ny));
  const size_t n = mxGetNumberOfElements(value);
  const double* present = numbers(value);
  uint8_t* mask = mxMalloc(n + 1);
  for (size_t i = 0; i < n; ++i) mask[i] = present[i] != 0;
  request->map.mask = mask;
}

/* A field of opts that is a word or, with '_' for '.', an option of the library; hx and hy are the pitch of z. */
static void set_field(Request* request, const char* field, const mxArray* value) {
  const bool number =
      value && (mxIsNumeric(value) || mxIsLogical(value)) && !mxIsComplex(value) && mxGetNumberOfElements(value) > 0;
  const bool text = value && mxIsChar(value) && mxGetM(value) <= 1;
  double* const own[] = {&request->map.hx, &request->map.hy, &request->gradient.dJ_dload, &request->gradient.dJ_dapproach};
  static const char* const names[] = {"hx", "hy", "dJ_dload", "dJ_dapproach"};
  if (!number && !text) check(request, refuse(request, RC_ERR_ARGUMENT, "opts.%s must be a number or a text", field));
  for (int i = 0; i < 4; ++i)
    if (number && !strcmp(field, names[i])) {
      *own[i] = mxGetScalar(value);
      return;
    }
  if (number && !strcmp(field, "gradient")) {
    request->asks_gradient = mxGetScalar(value) != 0;
    return;
  }
  const rc_given word = {field, text ? mxArrayToString(value) : NULL, text ? NULL : numbers(value),
                         text ? 0 : (int64_t)mxGetNumberOfElements(value)};
  request->in_time = request->in_time || !strcmp(field, "time") || !strcmp(field, "steps");
  request->words[request->n++] = word;
}

static mxArray* gradient_of(const Request* request) {
  if (!request->by_gap) return NULL;
  const rc_gradient* found = &request->gradient;
  const double numbers[] = {found->dJ_dtarget, found->dJ_dmodulus, found->error, (double)found->undecided,
                            (double)found->products};
  mxArray* gradient = struct_of("target,modulus,error,undecided,products", numbers);
  mxSetFieldByNumber(gradient, 0, mxAddField(gradient, "undeformed_gap"), request->by_gap);
  return gradient;
}

static mxArray* info_of(const rc_result* result, const Request* request, mxArray* gap) {
  static const char* names[] = {
#define NUMBER(name) #name,
#define TEXT(name) #name,
#include "result_fields.def"
#undef NUMBER
#undef TEXT
      "status_name", "status_text", "message", "explanation", "gap", "gradient", "flow", "history"};
  mxArray* info = mxCreateStructMatrix(1, 1, sizeof names / sizeof *names, names);
#define NUMBER(name) mxSetField(info, 0, #name, mxCreateDoubleScalar((double)result->name));
#define TEXT(name) mxSetField(info, 0, #name, mxCreateString(result->name));
#include "result_fields.def"
#undef NUMBER
#undef TEXT
  mxSetField(info, 0, "status_name", mxCreateString(rc_status_name(result->status)));
  mxSetField(info, 0, "status_text", mxCreateString(rc_status_text(result->status)));
  mxSetField(info, 0, "message", mxCreateString(request->message));
  mxSetField(info, 0, "explanation", mxCreateString(request->explanation ? request->explanation : ""));
  mxSetField(info, 0, "gap", gap);
  mxSetField(info, 0, "gradient", gradient_of(request));
  mxSetField(info, 0, "flow", request->flow);
  mxSetField(info, 0, "history", request->history);
  return info;
}

void mexFunction(int nlhs, mxArray* plhs[], int nrhs, const mxArray* prhs[]) {
  if (nrhs != 2) mexErrMsgIdAndTxt("roughcontact:RC_ERR_ARGUMENT", "usage: [p, info] = rc_solve(z, opts)");
  const size_t nx = mxGetM(prhs[0]), ny = mxGetN(prhs[0]);
  Request request = {.map = RC_MAP_INIT, .view = RC_PROBLEM_VIEW_INIT, .gradient = RC_GRADIENT_INIT};
  request.map.word = "surface";
  request.map.nx = (int64_t)nx;
  request.map.ny = (int64_t)ny;
  request.map.heights = matrix(&request, "z", prhs[0]);
  rc_const_array p0 = {0};
  const struct {
    const char* name;
    rc_const_array* to;
  } fields[] = {{"p0", &p0}, {"dJ_dp", &request.gradient.dJ_dp}, {"dJ_dgap", &request.gradient.dJ_dgap}};
  if (!mxIsStruct(prhs[1]) || mxGetNumberOfElements(prhs[1]) != 1)
    check(&request, refuse(&request, RC_ERR_ARGUMENT, "opts must be a struct"));
  request.words = mxMalloc((size_t)mxGetNumberOfFields(prhs[1]) * sizeof *request.words + 1);
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

  check(&request, read_words(&request));
  char* const remarks = remarks_of(&request);
  plhs[0] = mxCreateDoubleMatrix(nx, ny, mxREAL);
  mxArray* gap = nlhs > 1 || request.view.along != 0 ? mxCreateDoubleMatrix(nx, ny, mxREAL) : NULL;
  rc_result result;
  const rc_status status = solve(&request, p0, mxGetPr(plhs[0]), gap ? mxGetPr(gap) : NULL, &result);
  if (status == RC_STOP_CANCELLED) {
    close_request(&request);
    mexErrMsgIdAndTxt("roughcontact:RC_STOP_CANCELLED", "rc_solve: interrupted");
  }
  check(&request, status);
  /* A warning may be an error to the user, and not return: everything is given back before. */
  if (nlhs > 1) plhs[1] = info_of(&result, &request, gap);
  close_request(&request);
  if (remarks) mexWarnMsgIdAndTxt("roughcontact:assumed", "rc_solve: %s", remarks);
  if (status != RC_OK && status != RC_WITHIN_GOAL) {
    char id[64];
    snprintf(id, sizeof id, "roughcontact:%s", rc_status_name(status));
    mexWarnMsgIdAndTxt(id, "rc_solve: %s", request.message);
  }
}

/* rc_solve as a MEX function, for Octave and for MATLAB. Build, in this folder:
 *   mkoctfile --mex -o rc_solve.mex rc_solve_mex.c request.c $(pkg-config --cflags --libs roughcontact)   (Octave)
 *   mex -output rc_solve rc_solve_mex.c request.c -I<include> -L<lib> -lroughcontact -lut      (MATLAB) */
#include <mex.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "request.h"

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

/* mexErrMsgIdAndTxt does not return: all that is open is closed first. */
static void check(rc_request* request, rc_status status) {
  if (status >= 0) return;
  char id[64], message[sizeof request->message];
  snprintf(id, sizeof id, "roughcontact:%s", rc_status_name(status));
  snprintf(message, sizeof message, "%s", request->message);
  rc_request_close(request);
  mexErrMsgIdAndTxt(id, "rc_solve: %s", message);
}

/* The values of a real matrix as doubles; memory that is taken for it is MEX's, freed when the function ends. */
static const double* numbers(const mxArray* value) {
  if (mxIsDouble(value) && !mxIsSparse(value)) return mxGetPr(value);
  mxArray *given = (mxArray*)value, *doubles, *full;
  mexCallMATLAB(1, &doubles, 1, &given, "double");
  mexCallMATLAB(1, &full, 1, &doubles, "full");
  return mxGetPr(full);
}

static const double* matrix(rc_request* request, const char* name, const mxArray* value) {
  if (!(mxIsDouble(value) || mxIsSingle(value)) || mxIsComplex(value) || mxGetNumberOfDimensions(value) != 2)
    check(request, rc_request_refuse(request, RC_ERR_ARGUMENT, "%s must be a real matrix, double or single", name));
  return numbers(value);
}

static void set_mask(rc_request* request, const mxArray* value) {
  if (!(mxIsLogical(value) || mxIsNumeric(value)) || mxIsComplex(value) || mxGetNumberOfDimensions(value) != 2)
    check(request, rc_request_refuse(request, RC_ERR_ARGUMENT, "opts.mask must be a logical matrix"));
  const size_t n = mxGetNumberOfElements(value);
  const double* present = numbers(value);
  uint8_t* bytes = mxMalloc(n + 1);
  for (size_t i = 0; i < n; ++i) bytes[i] = present[i] != 0;
  check(request, rc_request_mask(request, (int64_t)mxGetM(value), (int64_t)mxGetN(value), bytes));
  mxFree(bytes);
}

static void set_field(rc_request* request, const char* field, const mxArray* value) {
  if (value && mxIsChar(value) && mxGetM(value) <= 1) {
    char* text = mxArrayToString(value);
    check(request, rc_request_text(request, field, text ? text : ""));
    mxFree(text);
  } else if (value && (mxIsNumeric(value) || mxIsLogical(value)) && !mxIsComplex(value) && mxGetNumberOfElements(value) == 1) {
    check(request, rc_request_number(request, field, mxGetScalar(value)));
  } else {
    check(request, rc_request_refuse(request, RC_ERR_ARGUMENT, "opts.%s must be a number or a text", field));
  }
}

static mxArray* info_of(const rc_result* result, const rc_request* request, mxArray* gap) {
  const rc_accuracy* accuracy = &request->accuracy;
  static const char* names[] = {
#define NUMBER(from, name) #name,
#define TEXT(from, name) #name,
#include "result_fields.def"
#undef NUMBER
#undef TEXT
      "status_name", "status_text", "message", "explanation", "gap"};
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
  return info;
}

void mexFunction(int nlhs, mxArray* plhs[], int nrhs, const mxArray* prhs[]) {
  if (nrhs != 2) mexErrMsgIdAndTxt("roughcontact:RC_ERR_ARGUMENT", "usage: [p, info] = rc_solve(z, opts)");
  const size_t nx = mxGetM(prhs[0]), ny = mxGetN(prhs[0]);
  rc_request request;
  check(&request, rc_request_open(&request, (int64_t)nx, (int64_t)ny));
  const double *heights = matrix(&request, "z", prhs[0]), *p0 = NULL;
  if (!mxIsStruct(prhs[1]) || mxGetNumberOfElements(prhs[1]) != 1)
    check(&request, rc_request_refuse(&request, RC_ERR_ARGUMENT, "opts must be a struct"));
  for (int k = 0; k < mxGetNumberOfFields(prhs[1]); ++k) {
    const char* field = mxGetFieldNameByNumber(prhs[1], k);
    const mxArray* value = mxGetFieldByNumber(prhs[1], 0, k);
    if (value && !strcmp(field, "mask")) {
      set_mask(&request, value);
    } else if (value && !strcmp(field, "p0")) {
      p0 = matrix(&request, "opts.p0", value);
      if (mxGetM(value) != nx || mxGetN(value) != ny)
        check(&request, rc_request_refuse(&request, RC_ERR_SHAPE, "opts.p0 must have the shape of z"));
    } else {
      set_field(&request, field, value);
    }
  }

  plhs[0] = mxCreateDoubleMatrix(nx, ny, mxREAL);
  mxArray* gap = nlhs > 1 ? mxCreateDoubleMatrix(nx, ny, mxREAL) : NULL;
  rc_result result;
  const rc_status status =
      rc_request_solve(&request, heights, p0, mxGetPr(plhs[0]), gap ? mxGetPr(gap) : NULL, interrupted, &result);
  if (status == RC_STOP_CANCELLED) {
    rc_request_close(&request);
    mexErrMsgIdAndTxt("roughcontact:RC_STOP_CANCELLED", "rc_solve: interrupted");
  }
  check(&request, status);
  /* A warning may be an error to the user, and not return: everything is given back before. */
  if (gap) plhs[1] = info_of(&result, &request, gap);
  char message[sizeof request.message];
  snprintf(message, sizeof message, "%s", request.message);
  rc_request_close(&request);
  if (status != RC_OK && status != RC_WITHIN_GOAL) {
    char id[64];
    snprintf(id, sizeof id, "roughcontact:%s", rc_status_name(status));
    mexWarnMsgIdAndTxt(id, "rc_solve: %s", message);
  }
}

/* rc_surface_read as a MEX function, for Octave and for MATLAB. Build, in this folder:
 *   mkoctfile --mex rc_surface_read.c $(pkg-config --cflags --libs roughcontact-formats) \
 *     -Wl,-rpath,$(pkg-config --variable=libdir roughcontact)                 (Octave)
 *   mex rc_surface_read.c -I<include> -L<lib> -lroughcontact-formats                         (MATLAB) */
#include <mex.h>
#include <roughcontact/formats.h>
#include <string.h>

static void refuse(const char* text) { mexErrMsgIdAndTxt("roughcontact:RC_ERR_ARGUMENT", "rc_surface_read: %s", text); }

/* Fields of opts: pitch, height_range, unit, format. Texts are MEX's, freed when the function ends. */
static void set_field(rc_surface_read_spec* spec, const char* field, const mxArray* value) {
  if (!strcmp(field, "pitch") || !strcmp(field, "height_range")) {
    const size_t count = value ? mxGetNumberOfElements(value) : 0;
    if (count < 1 || count > 2 || !mxIsDouble(value) || mxIsComplex(value) || mxIsSparse(value))
      refuse("opts.pitch must be a number or [hx, hy], opts.height_range a number");
    if (*field == 'h') {
      spec->height_range = mxGetPr(value)[0];
      return;
    }
    spec->hx = mxGetPr(value)[0];
    spec->hy = mxGetPr(value)[count - 1];
    return;
  }
  const char** text = !strcmp(field, "unit") ? &spec->unit : !strcmp(field, "format") ? &spec->format : NULL;
  if (!text)
    mexErrMsgIdAndTxt("roughcontact:RC_ERR_ARGUMENT", "rc_surface_read: opts.%s is not pitch, height_range, unit or format",
                      field);
  if (!value || !mxIsChar(value))
    mexErrMsgIdAndTxt("roughcontact:RC_ERR_ARGUMENT", "rc_surface_read: opts.%s must be a text", field);
  *text = mxArrayToString(value);
}

/* From here on only lack of memory does not return before the library's memory is given back. */
void mexFunction(int nlhs, mxArray* plhs[], int nrhs, const mxArray* prhs[]) {
  if (nrhs < 1 || nrhs > 2 || !mxIsChar(prhs[0]) || (nrhs == 2 && (!mxIsStruct(prhs[1]) || mxGetNumberOfElements(prhs[1]) != 1)))
    mexErrMsgIdAndTxt("roughcontact:RC_ERR_ARGUMENT", "usage: [z, info] = rc_surface_read(path, opts)");
  rc_surface_read_spec spec = RC_SURFACE_READ_SPEC_INIT;
  for (int k = 0; nrhs == 2 && k < mxGetNumberOfFields(prhs[1]); ++k)
    set_field(&spec, mxGetFieldNameByNumber(prhs[1], k), mxGetFieldByNumber(prhs[1], 0, k));

  const char* path = mxArrayToString(prhs[0]);
  rc_surface_file* file = mxMalloc(sizeof *file);
  *file = (rc_surface_file)RC_SURFACE_FILE_INIT;
  if (rc_surface_read(path, &spec, file) != RC_OK)
    mexErrMsgIdAndTxt("roughcontact:RC_ERR_ARGUMENT", "%s", rc_surface_read_last_error());
  plhs[0] = mxCreateDoubleMatrix((size_t)file->nx, (size_t)file->ny, mxREAL);
  memcpy(mxGetPr(plhs[0]), file->heights, (size_t)file->nx * (size_t)file->ny * sizeof *file->heights);
  const rc_surface_file read = *file;
  rc_surface_file_free(file);
  if (read.unit_assumed)
    mexWarnMsgIdAndTxt("roughcontact:assumed_unit",
                       "rc_surface_read: %s does not name the unit of all its lengths: m is taken; give opts.unit", path);
  if (nlhs < 2) return;
  static const char* names[] = {"hx", "hy", "missing", "periodic", "format", "assumed"};
  plhs[1] = mxCreateStructMatrix(1, 1, sizeof names / sizeof *names, names);
  mxSetField(plhs[1], 0, "hx", mxCreateDoubleScalar(read.hx));
  mxSetField(plhs[1], 0, "hy", mxCreateDoubleScalar(read.hy));
  mxSetField(plhs[1], 0, "missing", mxCreateDoubleScalar((double)read.missing));
  mxSetField(plhs[1], 0, "periodic", mxCreateDoubleScalar(read.periodic));
  mxSetField(plhs[1], 0, "format", mxCreateString(read.format));
  mxSetField(plhs[1], 0, "assumed", mxCreateString(read.assumed));
}

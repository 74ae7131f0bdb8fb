// rc_solve for Octave. Build: mkoctfile rc_solve.cc request.c $(pkg-config --cflags --libs roughcontact)
#include <octave/oct.h>
#include <octave/ov-struct.h>
#include <octave/quit.h>

#include <exception>
#include <string>
#include <vector>

#include "request.h"

namespace {

struct Request : rc_request {
  Request(octave_idx_type nx, octave_idx_type ny) { check(rc_request_open(this, nx, ny)); }
  ~Request() { rc_request_close(this); }
  Request(const Request&) = delete;
  Request& operator=(const Request&) = delete;

  void check(rc_status status) const {
    if (status < 0) error_with_id((std::string("roughcontact:") + rc_status_name(status)).c_str(), "rc_solve: %s", message);
  }
};

NDArray matrix(Request& request, const std::string& name, const octave_value& value) {
  if (!(value.is_double_type() || value.is_single_type()) || value.iscomplex() || value.ndims() != 2)
    request.check(rc_request_refuse(&request, RC_ERR_ARGUMENT, "%s must be a real matrix, double or single", name.c_str()));
  return value.array_value();
}

void set_mask(Request& request, const octave_value& value) {
  if (!(value.islogical() || value.isnumeric()) || value.iscomplex() || value.ndims() != 2)
    request.check(rc_request_refuse(&request, RC_ERR_ARGUMENT, "opts.mask must be a logical matrix"));
  const boolNDArray mask = value.bool_array_value();
  std::vector<std::uint8_t> bytes(mask.data(), mask.data() + mask.numel());
  request.check(rc_request_mask(&request, value.rows(), value.columns(), bytes.data()));
}

void set_field(Request& request, const std::string& field, const octave_value& value) {
  if (value.is_string() && value.rows() <= 1) {
    request.check(rc_request_text(&request, field.c_str(), value.string_value().c_str()));
  } else if ((value.isnumeric() || value.islogical()) && !value.iscomplex() && value.numel() == 1) {
    request.check(rc_request_number(&request, field.c_str(), value.double_value()));
  } else {
    request.check(rc_request_refuse(&request, RC_ERR_ARGUMENT, "opts.%s must be a number or a text", field.c_str()));
  }
}

// Octave's interrupt is an exception, which must not pass through the library: it waits here until the solve has ended.
std::int32_t interrupted(const rc_progress*, void* user) {
  try {
    octave_quit();
    return 0;
  } catch (...) {
    *static_cast<std::exception_ptr*>(user) = std::current_exception();
    return 1;
  }
}

octave_scalar_map info_of(const rc_result& result, const rc_request& request) {
  const rc_accuracy& accuracy = request.accuracy;
  octave_scalar_map info;
#define NUMBER(from, name) info.setfield(#name, octave_value(static_cast<double>(from.name)));
#define TEXT(from, name) info.setfield(#name, octave_value(std::string(from.name)));
#include "result_fields.def"
#undef NUMBER
#undef TEXT
  info.setfield("status_name", octave_value(std::string(rc_status_name(result.status))));
  info.setfield("status_text", octave_value(std::string(rc_status_text(result.status))));
  info.setfield("message", octave_value(std::string(request.message)));
  info.setfield("explanation", octave_value(std::string(request.explanation ? request.explanation : "")));
  return info;
}

}  // namespace

DEFUN_DLD(rc_solve, args, nargout,
          "-*- texinfo -*-\n"
          "@deftypefn {} {[@var{p}, @var{info}] =} rc_solve (@var{z}, @var{opts})\n"
          "Press the height map @var{z} into an elastic half-space: pressures @var{p} and what is certified of them.\n\n"
          "The first index of @var{z} runs along x. Fields of @var{opts}: @code{displacement} (counted from first touch) or\n"
          "@code{load}; @code{hx}, @code{hy}, @code{modulus}; @code{boundary} (\"free\" or \"periodic\"); @code{mask};\n"
          "@code{p0}; and every option of the library, such as @code{solver}, @code{backend}, @code{kernel}, @code{tol},\n"
          "with @code{_} for the dots of its name.\n"
          "@end deftypefn") {
  if (args.length() != 2) print_usage();
  Request request(args(0).rows(), args(0).columns());
  const NDArray heights = matrix(request, "z", args(0));
  if (!args(1).isstruct() || args(1).numel() != 1)
    request.check(rc_request_refuse(&request, RC_ERR_ARGUMENT, "opts must be a struct"));
  const octave_scalar_map opts = args(1).scalar_map_value();
  NDArray p0;
  for (octave_idx_type k = 0; k < opts.nfields(); ++k) {
    const std::string field = opts.fieldnames()(k);
    const octave_value value = opts.getfield(field);
    if (field == "mask") {
      set_mask(request, value);
    } else if (field == "p0") {
      p0 = matrix(request, "opts.p0", value);
      if (p0.dims() != heights.dims())
        request.check(rc_request_refuse(&request, RC_ERR_SHAPE, "opts.p0 must have the shape of z"));
    } else {
      set_field(request, field, value);
    }
  }

  NDArray p(heights.dims());
  NDArray gap(nargout > 1 ? heights.dims() : dim_vector(0, 0));
  std::exception_ptr pending;
  rc_result result;
  const rc_status status = rc_request_solve(&request, heights.data(), p0.isempty() ? nullptr : p0.data(), p.fortran_vec(),
                                            nargout > 1 ? gap.fortran_vec() : nullptr, interrupted, &pending, &result);
  if (pending) std::rethrow_exception(pending);
  request.check(status);
  if (status != RC_OK && status != RC_WITHIN_GOAL)
    warning_with_id((std::string("roughcontact:") + rc_status_name(status)).c_str(), "rc_solve: %s", request.message);
  octave_value_list out;
  out(0) = p;
  if (nargout > 1) {
    octave_scalar_map info = info_of(result, request);
    info.setfield("gap", gap);
    out(1) = info;
  }
  return out;
}

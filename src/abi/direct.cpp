// rc_greedy .. rc_admm, rc_cmr: a contact made, used once and dropped, for callers who want no handles.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "abi/guard.h"
#include "abi/sized_struct.h"
#include "contact/calls/contact.h"
#include "core/grid.h"

namespace {

using namespace rc;

// nx: of a grid, whose points are then named by column and row; 0: of a vector.
void check_array(const double* values, std::int64_t n, const char* name, std::int64_t nx = 0) {
  if (!values) fail(RC_ERR_ARGUMENT, name, " is null");
  for (std::int64_t i = 0; i < n; ++i)
    if (!std::isfinite(values[i]))
      fail(RC_ERR_ARGUMENT, name, "[", i, "] = ", values[i], " is not finite", nx > 0 ? " (" + place(i, nx) + ")" : "");
}

class Settings {
 public:
  explicit Settings(const char* solver) { set(RC_OPT_SOLVER, std::string(solver)); }
  Settings& set(const char* key, const OptionValue& value) {
    options_.set(key, value);
    return *this;
  }
  const rc_options& options() const { return options_; }

 private:
  rc_options options_{Context::standard(), {}};
};

void check_size_of(const rc_direct* result) {
  if (result) check_size(result, "rc_direct");
}

void report(const Numbers& answer, const System& system, rc_direct* result) {
  if (!result) return;
  rc_direct written{};
  written.status = answer.status;
  written.iterations = answer.work.iterations;
  written.products = answer.work.products;
  written.contacts = answer.totals.contacts;
  written.load = answer.load(system);
  written.energy = answer.totals.energy * system.cell_area();
  written.kkt = answer.certificate.worst();
  written.duality_gap = answer.bounds.duality_gap;
  written.load_lower = answer.bounds.load_lower;
  written.load_upper = answer.bounds.load_upper;
  std::snprintf(written.note, sizeof written.note, "%s", answer.note);
  write(result, written);
}

struct Matrix {
  std::int64_t n;
  const double* entries;
  std::int64_t ld;
};

// With gap -u and approach 0 the deformed gap is Hp - u.
rc_status on_matrix(const char* where, const char* solver, const Matrix& H, const double* u, double* p, double* w, double tol,
                    std::int64_t max_iter, rc_direct* result) {
  return guard(where, [&] {
    check_size_of(result);
    if (H.n < 1) fail(RC_ERR_SHAPE, "n = ", H.n, " must be >= 1");
    if (!H.entries) fail(RC_ERR_ARGUMENT, "H is null");
    if (H.ld < H.n) fail(RC_ERR_SHAPE, "ld = ", H.ld, " must be >= n = ", H.n);
    check_array(u, H.n, "u");
    check_array(p, H.n, "p");

    rc_system system = RC_SYSTEM_INIT;
    system.op = RC_OPERATOR_DENSE;
    system.nx = H.n;
    system.ny = 1;
    system.hx = system.hy = 1;  // a load is then the sum of p
    system.dense = H.entries;
    system.dense_ld = H.ld;
    Contact contact(system, Settings(solver).set(RC_OPT_TOL, tol).set(RC_OPT_MAX_ITER, max_iter).options());

    std::vector<double> gap(u, u + H.n);
    for (double& value : gap) value = -value;
    rc_step step = RC_STEP_INIT;
    step.control = RC_CONTROL_APPROACH;
    step.undeformed_gap = RC_IN(gap.data());
    step.p0.data = p;
    const Numbers numbers = contact.solve(step, {{p}, {w}});
    report(numbers, contact.problem().system, result);
    return numbers.status;
  });
}

}  // namespace

extern "C" {

rc_status rc_greedy(int64_t n, const double* H, int64_t ld, const double* u, double* p, double* w, double tol, int64_t max_iter,
                    rc_direct* result) {
  return on_matrix("rc_greedy", "greedy", {n, H, ld}, u, p, w, tol, max_iter, result);
}

rc_status rc_polonsky_keer(int64_t n, const double* H, int64_t ld, const double* u, double* p, double* w, double tol,
                           int64_t max_iter, rc_direct* result) {
  return on_matrix("rc_polonsky_keer", "polonsky-keer", {n, H, ld}, u, p, w, tol, max_iter, result);
}

rc_status rc_nnls(int64_t n, const double* H, int64_t ld, const double* u, double* p, double* w, double tol, int64_t max_iter,
                  rc_direct* result) {
  return on_matrix("rc_nnls", "nnls", {n, H, ld}, u, p, w, tol, max_iter, result);
}

rc_status rc_gp(int64_t n, const double* H, int64_t ld, const double* u, double* p, double* w, double tol, int64_t max_iter,
                rc_direct* result) {
  return on_matrix("rc_gp", "gp", {n, H, ld}, u, p, w, tol, max_iter, result);
}

rc_status rc_admm(int64_t n, const double* H, int64_t ld, const double* u, double* p, double* w, double tol, int64_t max_iter,
                  rc_direct* result) {
  return on_matrix("rc_admm", "admm", {n, H, ld}, u, p, w, tol, max_iter, result);
}

rc_status rc_cmr(int64_t nx, int64_t ny, double hx, double hy, double modulus, const double* heights, double approach,
                 int64_t levels, double radius, const char* inner, double* p, rc_direct* result) {
  return guard("rc_cmr", [&] {
    check_size_of(result);
    if (levels < 1) fail(RC_ERR_ARGUMENT, "levels = ", levels, " must be >= 1: the given grid is one of them");
    if (!std::isfinite(approach)) fail(RC_ERR_ARGUMENT, "approach = ", approach, " is not finite");
    if (!p) fail(RC_ERR_ARGUMENT, "p is null");

    const rc_system system = free_half_space(nx, ny, hx, hy, modulus);
    Settings settings("cmr");
    settings.set("cmr.levels", levels).set("cmr.radius", radius);
    if (inner) settings.set("cmr.inner", std::string(inner));
    Contact contact(system, settings.options());
    if (inner && std::string_view(inner) != "auto") settings.options().context->solver(inner);
    check_array(heights, nx * ny, "heights", nx);

    std::vector<double> gap(static_cast<std::size_t>(nx * ny));
    raise_if_failed(rc_gap_from_heights(nx * ny, RC_IN(heights), {}, RC_OUT(gap.data())), "the undeformed gap");
    rc_step step = RC_STEP_INIT;
    step.control = RC_CONTROL_APPROACH;
    step.undeformed_gap = RC_IN(gap.data());
    step.target = approach;
    const Numbers numbers = contact.solve(step, {{p}, {}});
    report(numbers, contact.problem().system, result);
    return numbers.status;
  });
}

}  // extern "C"

// Direct routines: each row of the first kind is tried on all five routines for a matrix.
#include <roughcontact/direct.h>

#include <cstring>

#include "case.h"
#include "scene.h"

namespace errors {

namespace {

using Routine = rc_status (*)(std::int64_t, const double*, std::int64_t, const double*, double*, double*, double, std::int64_t,
                              rc_direct*);
constexpr std::pair<const char*, Routine> routines[] = {{"rc_greedy: ", rc_greedy},
                                                        {"rc_polonsky_keer: ", rc_polonsky_keer},
                                                        {"rc_gp: ", rc_gp},
                                                        {"rc_admm: ", rc_admm},
                                                        {"rc_nnls: ", rc_nnls}};

// A valid call, to be spoiled in one place.
struct DirectCall {
  std::vector<double> H{2, 1, 1, 2}, u{1, 1}, p{0, 0}, w{7, 7};
  std::int64_t n = 2, ld = 2, max_iter = 100;
  double tol = 1e-8;
  const double *H_given = H.data(), *u_given = u.data();
  double* p_given = p.data();
};

template <class Spoil> auto matrix_with(const Spoil& spoil) {
  return [spoil] {
    std::vector<Outcome> outcomes;
    for (const auto& [name, routine] : routines) {
      DirectCall call;
      spoil(call);
      const std::vector<double> p = call.p;
      rc_direct result;
      std::memset(static_cast<void*>(&result), 0x5a, sizeof result);
      result.struct_size = sizeof result;
      const rc_direct before = result;
      outcomes.emplace_back(
          routine(call.n, call.H_given, call.ld, call.u_given, call.p_given, call.w.data(), call.tol, call.max_iter, &result));
      assert_int_equal(outcomes.back().status, outcomes.front().status);
      assert_int_equal(outcomes.back().message.rfind(name, 0), 0);
      assert_memory_equal(call.p.data(), p.data(), 2 * sizeof(double));
      assert_true(call.w[0] == 7 && call.w[1] == 7);
      assert_memory_equal(&result, &before, sizeof result);
    }
    return outcomes.back();
  };
}

struct CascadeCall {
  std::int64_t nx = side, ny = side, levels = 1;
  double hx = 1, hy = 1, modulus = 1, approach = 0.5, h = 2;
  std::vector<double> heights = std::vector<double>(points, 0.0), p = std::vector<double>(points, 7.0);
  const double* heights_given = heights.data();
  double* p_given = p.data();
  const char* inner = nullptr;
};

template <class Spoil> auto cascade_with(const Spoil& spoil) {
  return [spoil] {
    CascadeCall c;
    spoil(c);
    const Outcome outcome =
        rc_cmr(c.nx, c.ny, c.hx, c.hy, c.modulus, c.heights_given, c.approach, c.levels, c.h, c.inner, c.p_given, nullptr);
    for (const double value : c.p) assert_true(value == 7);
    return outcome;
  };
}

}  // namespace

Section direct_routines() {
  const rc_status refused = RC_ERR_ARGUMENT, shape = RC_ERR_SHAPE, option = RC_ERR_OPTION;
  return {
      "Direct routines",
      {
          {"matrix: n = 0", shape, {"rc_nnls: n = 0 must be >= 1"}, matrix_with([](DirectCall& c) { c.n = 0; })},
          {"matrix: n = -3", shape, {"rc_nnls: n = -3 must be >= 1"}, matrix_with([](DirectCall& c) { c.n = -3; })},
          {"matrix: ld < n", shape, {"rc_nnls: ld = 1 must be >= n = 2"}, matrix_with([](DirectCall& c) { c.ld = 1; })},
          {"matrix: H is null", refused, {"rc_nnls: H is null"}, matrix_with([](DirectCall& c) { c.H_given = nullptr; })},
          {"matrix: u is null", refused, {"rc_nnls: u is null"}, matrix_with([](DirectCall& c) { c.u_given = nullptr; })},
          {"matrix: p is null", refused, {"rc_nnls: p is null"}, matrix_with([](DirectCall& c) { c.p_given = nullptr; })},
          {"matrix: H with NaN", refused, {"rc_nnls: dense matrix: entry (1, 0) is nan"}, matrix_with([](DirectCall& c) {
             c.H[2] = nan;
           })},
          {"matrix: u with NaN", refused, {"rc_nnls: u[1] = nan is not finite"}, matrix_with([](DirectCall& c) {
             c.u[1] = nan;
           })},
          {"matrix: u with infinity", refused, {"rc_nnls: u[0] = inf is not finite"}, matrix_with([](DirectCall& c) {
             c.u[0] = infinity;
           })},
          {"matrix: p with NaN", refused, {"rc_nnls: p[1] = nan is not finite"}, matrix_with([](DirectCall& c) {
             c.p[1] = nan;
           })},
          {"matrix: H not symmetric",
           refused,
           {"rc_nnls: dense matrix is not symmetric: entry (1, 0) = 1.5 but (0, 1) = 1"},
           matrix_with([](DirectCall& c) { c.H[2] = 1.5; })},
          {"matrix: H with a negative diagonal",
           RC_ERR_NUMERIC,
           {"rc_nnls: dense matrix is not positive definite: diagonal entry 0 is -2"},
           matrix_with([](DirectCall& c) { c.H[0] = -2; })},
          {"matrix: tol = 0", option, {"rc_nnls: option \"tol\" = 0"}, matrix_with([](DirectCall& c) { c.tol = 0; })},
          {"matrix: tol = NaN", option, {"rc_nnls: option \"tol\" = nan"}, matrix_with([](DirectCall& c) { c.tol = nan; })},
          {"matrix: max_iter = 0", option, {"rc_nnls: option \"max_iter\" = 0"}, matrix_with([](DirectCall& c) {
             c.max_iter = 0;
           })},
          {"`rc_cmr`: nx = 0", shape, {"rc_cmr: nx = 0, ny = 4 must both be >= 1"}, cascade_with([](CascadeCall& c) {
             c.nx = 0;
           })},
          {"`rc_cmr`: hx = 0",
           refused,
           {"rc_cmr: rc_system.hx = 0 must be a positive finite length"},
           cascade_with([](CascadeCall& c) { c.hx = 0; })},
          {"`rc_cmr`: modulus = NaN",
           refused,
           {"rc_cmr: rc_system.modulus = nan must be positive and finite"},
           cascade_with([](CascadeCall& c) { c.modulus = nan; })},
          {"`rc_cmr`: heights is null", refused, {"rc_cmr: heights is null"}, cascade_with([](CascadeCall& c) {
             c.heights_given = nullptr;
           })},
          {"`rc_cmr`: heights with NaN",
           refused,
           {"rc_cmr: heights[3] = nan is not finite (ix=3, iy=0)"},
           cascade_with([](CascadeCall& c) { c.heights[3] = nan; })},
          {"`rc_cmr`: approach = NaN", refused, {"rc_cmr: approach = nan is not finite"}, cascade_with([](CascadeCall& c) {
             c.approach = nan;
           })},
          {"`rc_cmr`: levels = 0",
           refused,
           {"rc_cmr: levels = 0 must be >= 1: the given grid is one of them"},
           cascade_with([](CascadeCall& c) { c.levels = 0; })},
          {"`rc_cmr`: levels = 99", option, {"rc_cmr: option \"cmr.levels\" = 99"}, cascade_with([](CascadeCall& c) {
             c.levels = 99;
           })},
          {"`rc_cmr`: h = 0", option, {"rc_cmr: option \"cmr.radius\" = 0"}, cascade_with([](CascadeCall& c) { c.h = 0; })},
          {"`rc_cmr`: h = NaN", option, {"rc_cmr: option \"cmr.radius\" = nan"}, cascade_with([](CascadeCall& c) { c.h = nan; })},
          {"`rc_cmr`: unknown inner solver",
           RC_ERR_NO_SOLVER,
           {"rc_cmr: solver \"nnlss\" not found; did you mean \"nnls\"?"},
           cascade_with([](CascadeCall& c) { c.inner = "nnlss"; })},
          {"`rc_cmr`: itself as inner solver", RC_ERR_INCOMPATIBLE, {"rc_cmr: "}, cascade_with([](CascadeCall& c) {
             c.inner = "cmr";
           })},
          {"`rc_cmr`: p is null", refused, {"rc_cmr: p is null"}, cascade_with([](CascadeCall& c) { c.p_given = nullptr; })},
      }};
}

}  // namespace errors

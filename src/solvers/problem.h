// The problem of <roughcontact/plugin.h> in mathematical terms. Plugins of this source tree may include it.
#pragma once

#include <cstdint>
#include <numeric>
#include <roughcontact/plugin.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/certificate_terms.h"
#include "core/ranks.h"
#include "grid/gap_values.h"

namespace rc {

using Vector = std::vector<double>;
using Positions = std::vector<std::int64_t>;

// Leaves a solver from any depth with a status that is not RC_OK: a requested stop, or that of a failed product.
using roughcontact::check;

class Problem {
 public:
  Problem(const rc_host& host, const rc_problem& problem, const rc_options& options)
      : host_(host), problem_(problem), options_(options) {}

  std::int64_t size() const { return problem_.n; }
  // Null: all is here. Only solvers built into this library get rows, and those are its own.
  const Ranks* ranks() const { return SharedRows::ranks_of(problem_.rows); }
  bool load_control() const { return problem_.control == RC_CONTROL_LOAD; }
  const double* u() const { return problem_.u; }  // null: (approach - gap) / length_unit()
  double load() const { return problem_.load; }
  double cap() const { return problem_.cap; }  // 0 <= p <= cap; may be infinite
  double tol() const { return problem_.tol; }
  // The least scale of residuals: in full periodic contact the penetration, the usual scale, may vanish under any load.
  double least_scale() const {
    const bool periodic = problem_.grid && problem_.grid->boundary == RC_BOUNDARY_PERIODIC;
    const std::int64_t n = ranks() ? grid()->nx * grid()->ny : size();
    return periodic && load_control() ? least_scale_under(problem_.load, static_cast<double>(n)) : 0.0;
  }

  // y = H x
  void apply(const Vector& x, Vector& y) const { apply(x.data(), y.data()); }
  bool has_subset() const { return problem_.subset != nullptr; }
  // H[a,a] x = b; x: start in, answer out.
  rc_status try_subset(const Positions& a, const Vector& b, Vector& x) const {
    return problem_.subset(&problem_, static_cast<std::int64_t>(a.size()), a.data(), b.data(), x.data());
  }
  // (H + rho I) x = b to a relative residual of tol; x: start in, answer out.
  void shifted(double rho, double tol, const Vector& b, Vector& x) const {
    check(problem_.shifted(&problem_, rho, tol, b.data(), x.data()));
  }
  bool factors() const { return problem_.factors != 0; }  // systems on subsets cost no products
  bool has_norm() const { return problem_.norm != nullptr; }
  double norm() const {  // of H, Frobenius
    double value = 0;
    check(problem_.norm(&problem_, &value));
    return value;
  }
  double lambda_min() const { return problem_.lambda_min; }  // a lower bound of the eigenvalues; 0: none is known
  bool positive() const { return problem_.positive != 0; }   // no entry of H is negative
  const rc_grid* grid() const { return problem_.grid; }
  GapValues gap() const {
    const auto points = static_cast<std::size_t>(ranks() ? size() : grid()->nx * grid()->ny);
    return {grid()->undeformed_gap, points};
  }
  std::span<const std::uint8_t> mask() const { return {grid()->mask, grid()->mask ? gap().size() : 0}; }  // empty: all points
  // Runs another solver, with pressure on the positions `a` only. product: null, or receives H p.
  rc_status inner(const char* solver, const Positions& a, double* p, Vector* product) const {
    return problem_.inner(&problem_, solver, static_cast<std::int64_t>(a.size()), a.data(), tol(), p,
                          product ? product->data() : nullptr);
  }
  // Goes on from p with nnls, which ends after finitely many steps on every surface.
  rc_status by_nnls(double* p) const {
    Positions all(static_cast<std::size_t>(size()));
    std::iota(all.begin(), all.end(), std::int64_t{0});
    return inner("nnls", all, p, nullptr);
  }
  // Solves on a coarser grid. Leaves where the whole solve must end.
  rc_status coarse(rc_coarse& request) const {
    const rc_status status = problem_.coarse(&problem_, &request);
    if (status == RC_STOP_CANCELLED || status == RC_STOP_TIME || status == RC_ERR_MEMORY) check(status);
    return status;
  }
  // The point of the grid that unknown i stands for.
  std::int64_t point(std::int64_t i) const { return grid()->index ? grid()->index[i] : i; }
  // The overlap of the undeformed surfaces at unknown i.
  double penetration(std::int64_t i) const {
    return u() ? u()[i] : (grid()->approach - gap()[static_cast<std::size_t>(point(i))]) / length_unit();
  }
  void coefficients(std::int64_t mx, std::int64_t my, Vector& out) const {
    out.resize(static_cast<std::size_t>(mx * my));
    check(problem_.coefficients(&problem_, mx, my, out.data()));
  }
  bool has_float() const { return problem_.apply_float != nullptr; }
  void apply(const float* x, float* y) const { check(problem_.apply_float(&problem_, x, y)); }
  void apply(const double* x, double* y) const { check(problem_.apply(&problem_, x, y)); }
  const rc_kept_steps* kept() const { return problem_.kept; }  // null: no later step starts from this answer
  // Whether a step may go on without what only makes it faster, if there is no memory for it.
  bool may_go_without() const { return kept() && kept()->may_go_without != 0; }
  const rc_team& team() const { return *problem_.team; }
  double length_unit() const { return problem_.length; }
  double pressure_unit() const { return problem_.pressure; }
  void note(const std::string& text) const { problem_.note(&problem_, text.c_str()); }
  // Call it once an iteration.
  void poll(std::int64_t iteration, double kkt) const { check(problem_.poll(&problem_, iteration, kkt)); }

  std::int64_t option_int(const char* key) const { return roughcontact::option_int(&host_, &options_, key); }
  double option_real(const char* key) const { return roughcontact::option_real(&host_, &options_, key); }
  std::string option_text(const char* key) const { return roughcontact::option_text(&host_, &options_, key); }
  [[noreturn]] void fail(const char* message) const { fail(RC_ERR_NUMERIC, message); }
  [[noreturn]] void fail(rc_status status, const char* message) const {
    throw roughcontact::Failure{host_.fail(&host_, status, message), {}};
  }

 private:
  const rc_host& host_;
  const rc_problem& problem_;
  const rc_options& options_;
};

}  // namespace rc

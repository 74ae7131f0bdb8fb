// What a solver of this source tree is written against: the problem of <roughcontact/plugin.h> in the terms of the mathematics.
#pragma once

#include <roughcontact/plugin.h>

#include <cstdint>
#include <vector>

namespace rc {

using Vector = std::vector<double>;
using Positions = std::vector<std::int64_t>;

// Leaves a solver from any depth with this status: a stop that was asked for, or a failed product.
struct Leave {
  rc_status status;
};

class Problem {
 public:
  Problem(const rc_host& host, const rc_problem& problem, const rc_options& options)
      : host_(host), problem_(problem), options_(options) {}

  std::int64_t size() const { return problem_.n; }
  bool load_control() const { return problem_.control == RC_CONTROL_LOAD; }
  const double* u() const { return problem_.u; }
  double load() const { return problem_.load; }
  double tol() const { return problem_.tol; }

  // y = H x
  void apply(const Vector& x, Vector& y) const { check(problem_.apply(&problem_, x.data(), y.data())); }
  // H[a,a] x = b
  rc_status try_subset(const Positions& a, const Vector& b, Vector& x) const {
    return problem_.subset(&problem_, static_cast<std::int64_t>(a.size()), a.data(), b.data(), x.data());
  }
  // Once an iteration.
  void poll(std::int64_t iteration, double kkt) const { check(problem_.poll(&problem_, iteration, kkt)); }

  std::int64_t option_int(const char* key) const;
  [[noreturn]] void fail(const char* message) const { throw Leave{host_.fail(&host_, RC_ERR_NUMERIC, message)}; }
  static void check(rc_status status) {
    if (status != RC_OK) throw Leave{status};
  }

 private:
  const rc_host& host_;
  const rc_problem& problem_;
  const rc_options& options_;
};

// One declaration per line of solvers.def: improves p (and, in load control, d) until problem.tol() is met.
#define RC_SOLVER(function, name, summary, needs, controls) rc_status function(const Problem& problem, Vector& p, double& d);
#include "solvers/solvers.def"
#undef RC_SOLVER

}  // namespace rc

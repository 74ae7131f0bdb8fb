// H by CHOLMOD: a factor of all entries where there is room (exact()), else conjugate gradients with a factor of the near ones.
#include "operator.h"

#include <algorithm>

#include "conjugate_gradients.h"

namespace rc_cholmod {

using rc_common::Point;
using rc_common::SymmetricMatrix;

namespace {

// The largest matrix that is kept for products [bytes].
constexpr double affordable = 512.0 * 1048576.0;
// Above this, a residual at which conjugate gradients stop is a failure.
constexpr double acceptable = 1e-11;

}  // namespace

Operator::Operator(const rc_host* host, const rc_operator_spec& spec)
    : EntryOperator(host, spec, component, memory_limit_key),
      spec_(spec),
      system_(spec.system),
      radius_(roughcontact::option_real(host, spec.options, near_field_key)),
      set_(session_) {}

void Operator::forget_factors() {
  set_.clear();
  shifted_.reset();
  near_.reset();
}

// Refuses a grid whose matrix would not fit, unless only the near field is factored: other backends serve it better.
void Operator::bind(const rc_domain& domain) {
  if (exact() && system_->op == RC_OPERATOR_HALFSPACE)
    limit_.require("the matrix", domain.n, SymmetricMatrix::bytes(static_cast<double>(domain.n)));
  if (products_.bind(domain) != rc_common::Products::Change::none) forget_factors();
}

void Operator::apply(const double* x, double* y) {
  if (SymmetricMatrix::bytes(static_cast<double>(products_.size())) <= std::min(affordable, limit_.limit())) products_.store();
  products_.apply(x, y);
}

void Operator::require_factor(std::int64_t points, std::int64_t slots) const {
  limit_.require("the Cholesky factor", points, Factor::bytes(static_cast<double>(slots)));
}

void Operator::subset(std::int64_t na, const std::int64_t* a, const double* b, double* x) {
  if (na == 0) return;
  const std::vector<Point> points = products_.points_at(std::span(a, static_cast<std::size_t>(na)));
  if (!exact()) return iterate(points, 0.0, b, x);
  shifted_.reset();
  require_factor(na, WorkingSet::slots_for(na, products_.size()));
  set_.solve(products_.entries(), points, products_.size(), b, x);
}

void Operator::shifted(double rho, const double* b, double* x) {
  if (!exact()) return iterate(products_.points(), rho, b, x);
  const std::int64_t n = products_.size();
  if (!shifted_ || rho != rho_) {
    forget_factors();
    require_factor(n, n);
    shifted_.emplace(session_, n, n, products_.source(), rho);
    rho_ = rho;
  }
  std::copy_n(b, n, x);
  shifted_->solve(x);
}

void Operator::iterate(std::span<const Point> points, double rho, const double* b, double* x) {
  const rc_common::Influence& H = products_.entries();
  if (!near_ || rho != rho_ || !std::equal(points.begin(), points.end(), near_points_.begin(), near_points_.end())) {
    near_.reset();
    near_points_.assign(points.begin(), points.end());
    near_ = near_field(session_, limit_, spec_, H, points, radius_, rho);
    rho_ = rho;
  }
  const auto n = static_cast<std::int64_t>(points.size());
  const std::vector<rc_common::Run> runs = rc_common::runs_of(points);
  const auto multiply = [&](const double* in, double* out) {
    check_for_stop(spec_);
    H.multiply(points, in, runs, out);
    for (std::int64_t i = 0; i < n; ++i) out[i] += rho * in[i];
  };
  const Conclusion reached = conjugate_gradients(
      n, multiply, [this](double* r) { session_.solve(*near_, r); }, b, x);
  if (reached.residual <= acceptable) return;
  if (!(reached.curvature > 0.0))
    fail(RC_ERR_NUMERIC, "the operator is not positive definite: t'Ht = ", reached.curvature, " on a set of ", n, " points");
  fail(RC_ERR_NUMERIC, "conjugate gradients on ", n, " points stopped at a relative residual of ", reached.residual, " after ",
       reached.iterations, " iterations; the matrix must be symmetric positive definite");
}

}  // namespace rc_cholmod

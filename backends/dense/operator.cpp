#include "operator.h"

#include <algorithm>
#include <span>

namespace rc_dense {

namespace {

// Bytes up to which matrix and factors are always kept side by side.
constexpr double always_affordable = 512.0 * 1048576.0;
// Bytes for what a stored triangle takes beside its n^2/2 numbers: the full tiles on the diagonal, vectors and tables.
constexpr double beside_a_triangle = 64.0 * 1048576.0;

}  // namespace

Operator::Operator(const rc_host* host, const rc_operator_spec& spec)
    : EntryOperator(host, spec, component, memory_limit_key),
      options_(spec.options),
      grid_(spec.system->op == RC_OPERATOR_HALFSPACE) {}

// Bytes for matrix and factors together: one triangle of the domain's size, or what is always affordable if that is more.
double Operator::budget() const {
  const auto n = static_cast<double>(products_.size());
  return std::min(limit_.limit(), std::max(always_affordable, 4.0 * n * n + beside_a_triangle));
}

// Refuses a grid whose matrix cannot be stored. A caller's matrix is in memory already.
void Operator::bind(const rc_domain& domain) {
  if (grid_) limit_.require("the matrix", domain.n, rc_common::SymmetricMatrix::bytes(static_cast<double>(domain.n)));
  const auto change = products_.bind(domain);
  if (change == rc_common::Products::Change::none) return;
  shifted_.clear();
  if (change == rc_common::Products::Change::entries || !fits(set_.bytes())) set_.clear();
}

// Stores the matrix if the factors leave room; otherwise entries come from their source. A caller's large matrix is never copied.
void Operator::apply(const double* x, double* y) {
  const double bytes = rc_common::SymmetricMatrix::bytes(static_cast<double>(products_.size()));
  if (fits(bytes + set_.bytes() + UpdatableCholesky::bytes(shifted_.size())) && (grid_ || bytes <= always_affordable))
    products_.store();
  products_.apply(x, y);
}

void Operator::subset(std::int64_t na, const std::int64_t* a, const double* b, double* x) {
  if (na == 0) return;
  const double wanted = UpdatableCholesky::bytes(na), other = UpdatableCholesky::bytes(shifted_.size());
  limit_.require("the Cholesky factor", na, wanted);
  if (!fits(wanted + other + products_.stored_bytes())) products_.forget();
  if (!fits(wanted + other)) shifted_.clear();
  set_.solve(products_.entries(), products_.points_at(std::span(a, static_cast<std::size_t>(na))), b, x);
}

void Operator::shifted(double rho, const double* b, double* x) {
  const std::int64_t n = products_.size();
  if (shifted_.size() != n || rho != rho_) factor_shifted(rho);
  std::copy_n(b, n, x);
  shifted_.solve(x);
}

void Operator::forget() {
  set_.clear();
  shifted_.clear();
}

void Operator::rest() {
  products_.rest();
  if (roughcontact::option_int(host_, options_, "resumable") != 0) return forget();  // the next step does so in any case
  set_.rest();
}

void Operator::factor_shifted(double rho) {
  shifted_.clear();
  const std::int64_t n = products_.size();
  const double wanted = UpdatableCholesky::bytes(n);
  limit_.require("the Cholesky factor", n, wanted);
  if (!fits(wanted + set_.bytes() + products_.stored_bytes())) products_.forget();
  if (!fits(wanted + set_.bytes())) set_.clear();
  const auto entries = [rho, H = products_.source()](std::int64_t first_row, std::int64_t rows, std::int64_t column,
                                                     double* out) {
    H(first_row, rows, column, out);
    if (first_row <= column && column < first_row + rows) out[column - first_row] += rho;
  };
  if (const auto bad = shifted_.append(n, entries))
    fail(RC_ERR_NUMERIC, "the matrix plus ", rho, " times the identity is not positive definite: pivot ", bad->unknown + 1,
         " of ", n, " is ", bad->value, "; the matrix must be symmetric positive semidefinite");
  rho_ = rho;
}

}  // namespace rc_dense

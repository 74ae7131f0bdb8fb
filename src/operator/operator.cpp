#include "operator/operator.h"

#include <algorithm>

#include "core/error.h"
#include "core/large_memory.h"

namespace rc {

Operator::Operator(const rc_backend& backend, const rc_host& host, const rc_system& system, const std::string& kernel,
                   const rc_options& options, const rc_team& team, double scale, const Rows& rows)
    : backend_(backend), system_(system), kernel_(kernel), scale_(scale) {
  const auto poll = [](const rc_operator_spec* spec) -> rc_status {
    const Operator& op = *static_cast<const Spec*>(spec)->op;
    return op.ask_ ? op.ask_() : RC_OK;
  };
  spec_ = {{sizeof(rc_operator_spec), &system_, kernel_.c_str(), &options, &team, poll, rows.seen(shared_)}, this};
  clear_message();
  check(backend_.create(&host, &spec_, &self_), "creating the operator");
}

Operator::~Operator() {
  if (self_ && !rows_) backend_.destroy(self_);
}

void Operator::bind(const TrialSet& trial) {
  if (bound_ && trial == trial_) return;
  if (trial.n < 1 && !shared_.of) fail(RC_ERR_INTERNAL, "the trial set is empty");  // backends would take it for the whole grid
  bound_ = false;
  if (rows_) {
    trial_ = trial;
    locate_own();
    bound_ = true;
    return;
  }
  TrialSet copy = trial;
  const rc_domain domain{sizeof(rc_domain), copy.n, copy.index.empty() ? nullptr : copy.index.data(), copy.zero_mode};
  clear_message();
  check(seen(backend_.bind(self_, &domain)), "binding the trial set");
  trial_ = std::move(copy);  // the backend keeps a pointer to the vector's storage, which moves along
  bound_ = true;
}

bool Operator::forget() {
  bound_ = false;
  return backend_.forget && !rows_ && backend_.forget(self_) == RC_OK;
}

void Operator::locate_own() {
  first_of_.clear();
  for (const std::int64_t row : rows_->shared_.of->first()) {
    const std::int64_t point = row * system_.nx;
    const auto at = std::lower_bound(trial_.index.begin(), trial_.index.end(), point);
    first_of_.push_back(trial_.index.empty() ? point : at - trial_.index.begin());
  }
}

template <class Real> Real* Operator::own_values() {
  const std::size_t bytes = 2 * sizeof(double) * static_cast<std::size_t>(rows_->trial_.n);
  if (!room_) {
    room_ = std::make_unique_for_overwrite<std::byte[]>(bytes);
    prefer_large(room_.get(), bytes);
  }
  return reinterpret_cast<Real*>(room_.get());
}

// A product exchanges without a check.
void Operator::begin_shared() const {
  if (!shared_.of) return;
  shared_.of->watch();
  ++shared_.of->counts().products;
}

// y: on this rank's rows. What fails in the product becomes known with the next checked exchange.
template <class Real> void Operator::multiply_rows(Multiply<Real> multiply, const Real* x, Real* y) {
  const Ranks& ranks = *rows_->shared_.of;
  const auto here = static_cast<std::size_t>(ranks.rank());
  const std::int64_t before = ranks.first_row() * system_.nx;
  Real* const own = own_values<Real>();
  std::fill_n(own, rows_->trial_.n, Real{0});
  for (std::int64_t i = first_of_[here]; i < first_of_[here + 1]; ++i) own[trial_.point(i) - before] = x[i];
  ranks.watch();
  ++ranks.counts().products;
  ranks.failed(seen(multiply(self_, own, y)), last_message());
}

template <class Real> void Operator::multiply_together(Multiply<Real> multiply, const Real* x, Real* y) {
  const Ranks& ranks = *rows_->shared_.of;
  const auto here = static_cast<std::size_t>(ranks.rank());
  const std::int64_t before = ranks.first_row() * system_.nx;
  std::vector<std::int64_t> bytes;
  for (std::size_t r = 0; r + 1 < first_of_.size(); ++r)
    bytes.push_back((first_of_[r + 1] - first_of_[r]) * static_cast<std::int64_t>(sizeof(Real)));
  Real *const mine = own_values<Real>(), *const rows = mine + rows_->trial_.n;
  multiply_rows(multiply, x, rows);
  for (std::int64_t i = first_of_[here]; i < first_of_[here + 1]; ++i) mine[i - first_of_[here]] = rows[trial_.point(i) - before];
  ranks.gather_unwatched(mine, bytes.data(), y);
}

template <class Real> rc_status Operator::product(Multiply<Real> multiply, const Real* x, Real* y) {
  if (ask_)
    if (const rc_status stop = ask_(); stop != RC_OK) return stop;
  ++products_;
  begin_shared();
  rc_status status = RC_OK;
  if (rows_)
    multiply_together(multiply, x, y);
  else
    status = seen(multiply(self_, x, y));
  if (scale_ != 1)
    for (std::int64_t i = 0; i < trial_.n; ++i) y[i] /= static_cast<Real>(scale_);
  return status;
}

rc_status Operator::apply(const double* x, double* y) { return product(backend_.apply, x, y); }

rc_status Operator::apply_float(const float* x, float* y) { return product(backend_.apply_float, x, y); }

void Operator::field(std::span<const double> x, std::span<double> y) {
  ++products_;
  begin_shared();
  clear_message();
  if (rows_)
    multiply_rows(backend_.field, x.data(), y.data());
  else
    check(seen(backend_.field(self_, x.data(), y.data())), "the product over all points");
  if (scale_ != 1)
    for (double& value : y) value /= scale_;
}

void Operator::screen(std::span<const double> x, rc_screen& request) {
  ++products_;
  clear_message();
  request.unit /= scale_;
  check(seen(backend_.screen(self_, x.data(), &request)), "the search for overlapping points");
  if (scale_ != 1)
    for (std::int64_t i = 0; i < trial_.n; ++i) request.y[i] /= scale_;
}

rc_status Operator::subset(std::span<const std::int64_t> a, const double* b, double* x, double tol) {
  if (a.empty()) return RC_OK;
  if (!backend_.subset) return subset_by_products(a, b, x, tol);
  const rc_status status = seen(backend_.subset(self_, static_cast<std::int64_t>(a.size()), a.data(), b, x));
  if (scale_ != 1)
    for (std::size_t i = 0; i < a.size(); ++i) x[i] *= scale_;
  return status;
}

rc_status Operator::norm(double& out) {
  const rc_status status = seen(backend_.norm(self_, &out));
  out /= scale_;
  return status;
}

}  // namespace rc

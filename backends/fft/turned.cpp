#include "turned.h"

#include <cmath>
#include <cstddef>
#include <utility>

namespace rc_fft {

namespace {

constexpr std::int64_t least_turned = 64;  // below, all sizes take next to no time
constexpr std::int64_t most_columns = 4;   // which, as lines, are split in either precision

rc_system turned(rc_system system) {
  std::swap(system.nx, system.ny);
  std::swap(system.hx, system.hy);
  return system;
}

rc_operator_spec with(rc_operator_spec spec, const rc_system& system) {
  spec.system = &system;
  return spec;
}

// Null where an older core knows none.
const rc_rows* rows_of(const rc_operator_spec& spec) {
  return spec.struct_size >= offsetof(rc_operator_spec, rows) + sizeof spec.rows ? spec.rows : nullptr;
}

bool is_narrow(const rc_system& system) {
  return system.op == RC_OPERATOR_HALFSPACE && system.nx <= most_columns && system.ny >= least_turned &&
         system.ny <= longest_axis;
}

}  // namespace

// Transforms of the doubled box, and of the doubled grid for field().
void Turned::score(const rc_facts& facts, rc_estimate& estimate) {
  const auto seconds = [](double points) { return 1e-9 * points * std::log2(4 * points + 1); };
  const auto box = static_cast<double>(facts.box), grid = static_cast<double>(facts.system->nx * facts.system->ny);
  estimate.product = seconds(box);
  estimate.field = seconds(grid);
  estimate.bytes = 28 * box + 12 * grid;
}

Turned::Turned(const rc_host* host, const rc_operator_spec& spec)
    : nx_(spec.system->nx),
      ny_(spec.system->ny),
      turned_(is_narrow(*spec.system) && !rows_of(spec)),
      system_(turned_ ? turned(*spec.system) : *spec.system),
      op_(host, with(spec, system_)) {
  if (rows_of(spec)) slabs_ = std::make_unique<Slabs>(host, spec);
}

void Turned::bind(const rc_domain& domain) {
  if (slabs_) return;
  order_.clear();
  if (!turned_ || nx_ == 1) return op_.bind(domain);
  const auto n = static_cast<std::size_t>(domain.n);
  std::vector<std::int64_t> index;
  index.reserve(domain.index ? n : 0);
  order_.reserve(n);
  for (std::int64_t x = 0; x < nx_; ++x)
    for (std::int64_t i = 0; i < domain.n; ++i) {
      const std::int64_t point = domain.index ? domain.index[i] : i;
      if (point % nx_ != x) continue;
      order_.push_back(i);
      if (domain.index) index.push_back(x * ny_ + point / nx_);
    }
  rc_domain own = domain;
  if (domain.index) own.index = index.data();
  op_.bind(own);
}

template <class Real, class Product> void Turned::reordered(const Real* x, Real* y, const Product& product) const {
  if (order_.empty()) return product(x, y);
  std::vector<Real> from(order_.size()), to(order_.size());
  for (std::size_t i = 0; i < order_.size(); ++i) from[i] = x[order_[i]];
  product(from.data(), to.data());
  for (std::size_t i = 0; i < order_.size(); ++i) y[order_[i]] = to[i];
}

void Turned::apply(const double* x, double* y) {
  if (slabs_) return slabs_->apply(x, y);
  reordered(x, y, [&](const double* from, double* to) { op_.apply(from, to); });
}

void Turned::apply_float(const float* x, float* y) {
  if (slabs_) return slabs_->apply(x, y);
  reordered(x, y, [&](const float* from, float* to) { op_.apply_float(from, to); });
}

void Turned::field(const double* x, double* y) {
  if (slabs_) return slabs_->apply(x, y);
  if (order_.empty()) return op_.field(x, y);
  std::vector<double> from(order_.size()), to(static_cast<std::size_t>(nx_ * ny_));
  for (std::size_t i = 0; i < order_.size(); ++i) from[i] = x[order_[i]];
  op_.field(from.data(), to.data());
  for (std::int64_t ix = 0; ix < nx_; ++ix)
    for (std::int64_t iy = 0; iy < ny_; ++iy) y[iy * nx_ + ix] = to[static_cast<std::size_t>(ix * ny_ + iy)];
}

}  // namespace rc_fft

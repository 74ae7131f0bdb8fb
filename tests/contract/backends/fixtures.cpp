#include "fixtures.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <numeric>
#include <random>

#include "support/callers_product.h"
#include "support/cmocka.hpp"

namespace contract {

namespace {

std::int32_t boundary_of(std::uint64_t cap) {
  return cap == RC_CAP_PERIODIC ? RC_BOUNDARY_PERIODIC : cap == RC_CAP_SEMI_PERIODIC ? RC_BOUNDARY_PERIODIC_X : RC_BOUNDARY_FREE;
}

void check(rc_status status) {
  if (status != RC_OK) fail_msg("status %d: %s", static_cast<int>(status), StandInHost::message().c_str());
}

}  // namespace

rc_system callers_matrix(const Vector& entries, std::int64_t n, std::int64_t ld) {
  rc_system system = halfspace(RC_BOUNDARY_FREE, n, 1, 1.0, 1.0);
  system.op = RC_OPERATOR_DENSE;
  system.dense = entries.data();
  system.dense_ld = ld;
  return system;
}

Problem::Problem(std::uint64_t cap, std::int64_t nx, std::int64_t ny, double hx, double hy, double zero_mode)
    : zero_mode_(zero_mode), system_(halfspace(boundary_of(cap), nx, ny, hx, hy)), matrix_(matrix_of(system_, zero_mode)) {
  if (cap == RC_CAP_DENSE_INPUT) {
    const std::int64_t n = matrix_.size(), ld = n + 7;
    rows_.assign(static_cast<std::size_t>(n * ld), std::numeric_limits<double>::quiet_NaN());
    for (std::int64_t i = 0; i < n; ++i) std::copy_n(matrix_.row(i), n, rows_.begin() + i * ld);
    system_ = callers_matrix(rows_, n, ld);
    system_.nx = nx;
    system_.ny = ny;
  } else if (cap == RC_CAP_CALLBACK) {
    system_.op = RC_OPERATOR_CALLBACK;
    system_.apply = support::multiply;
    system_.user = const_cast<double*>(matrix_.row(0));
  }
}

Index Problem::all() const { return range(0, matrix_.size()); }

Index range(std::int64_t first, std::int64_t end) {
  Index index(static_cast<std::size_t>(end - first));
  std::iota(index.begin(), index.end(), first);
  return index;
}

void for_each_problem(const rc_backend& backend, std::int64_t nx, std::int64_t ny, double hx, double hy,
                      const std::function<void(const Problem&)>& body) {
  for (std::uint64_t cap : {RC_CAP_FREE, RC_CAP_PERIODIC, RC_CAP_SEMI_PERIODIC, RC_CAP_DENSE_INPUT, RC_CAP_CALLBACK}) {
    if (!(backend.caps & cap)) continue;
    body(Problem(cap, nx, ny, hx, hy, 0.0));
    if (cap == RC_CAP_PERIODIC) body(Problem(cap, nx, ny, hx, hy, 0.7));
  }
}

Operator::Operator(const rc_backend& backend, StandInHost& host, const rc_system& system, const std::string& kernel)
    : backend_(backend),
      system_(system),
      kernel_(kernel.empty() && system.op == RC_OPERATOR_HALFSPACE ? kernel_name(system.boundary) : kernel),
      team_(host.threads()),
      spec_{sizeof(rc_operator_spec), &system_, kernel_.c_str(), host.options(), &team_, nullptr} {
  check(backend.create(&host, &spec_, &self_));
}

Operator::~Operator() { backend_.destroy(self_); }

void Operator::bind(const Index& domain, double zero_mode, bool whole) {
  domain_ = domain;
  const rc_domain bound{sizeof(rc_domain), static_cast<std::int64_t>(domain_.size()), whole ? nullptr : domain_.data(),
                        zero_mode};
  check(backend_.bind(self_, &bound));
}

void Operator::forget() { assert_int_equal(backend_.forget(self_), RC_OK); }

Vector Operator::apply(const Vector& x) {
  Vector y(domain_.size(), std::numeric_limits<double>::quiet_NaN());
  check(backend_.apply(self_, x.data(), y.data()));
  return y;
}

Vector Operator::apply_float(const Vector& x) {
  const std::vector<float> rounded(x.begin(), x.end());
  std::vector<float> y(domain_.size(), std::numeric_limits<float>::quiet_NaN());
  check(backend_.apply_float(self_, rounded.data(), y.data()));
  return {y.begin(), y.end()};
}

Vector Operator::field(const Vector& x) {
  Vector y(static_cast<std::size_t>(system_.nx * system_.ny), std::numeric_limits<double>::quiet_NaN());
  check(backend_.field(self_, x.data(), y.data()));
  return y;
}

Vector Operator::subset(const Index& positions, const Vector& b) {
  Vector x(positions.size(), std::numeric_limits<double>::quiet_NaN());
  check(backend_.subset(self_, static_cast<std::int64_t>(positions.size()), positions.data(), b.data(), x.data()));
  return x;
}

Vector Operator::shifted(double rho, const Vector& b) {
  Vector x(b.size(), std::numeric_limits<double>::quiet_NaN());
  check(backend_.shifted(self_, rho, b.data(), x.data()));
  return x;
}

double Operator::norm() {
  double norm = std::numeric_limits<double>::quiet_NaN();
  check(backend_.norm(self_, &norm));
  return norm;
}

void Operator::screen(const Vector& x, rc_screen& request) { check(backend_.screen(self_, x.data(), &request)); }

std::vector<Index> domains(std::int64_t nx, std::int64_t ny, unsigned seed) {
  std::mt19937 generator(seed);
  std::vector<Index> all;
  const auto box = [&](std::int64_t x, std::int64_t y, std::int64_t bx, std::int64_t by, unsigned keep_in_16) {
    Index index;
    for (std::int64_t iy = y; iy < std::min(y + by, ny); ++iy)
      for (std::int64_t ix = x; ix < std::min(x + bx, nx); ++ix)
        if (generator() % 16 < keep_in_16) index.push_back(iy * nx + ix);
    if (!index.empty()) all.push_back(index);
  };
  box(0, 0, nx, ny, 16);
  box(nx / 2, ny / 2, 1, 1, 16);
  box(nx - 1, ny - 1, 1, 1, 16);
  box(0, 0, (nx + 1) / 2, (ny + 2) / 3, 16);
  box(nx / 3, ny / 4, (nx + 2) / 3, ny / 2 + 1, 16);
  box(nx / 2, ny / 2, nx, ny, 10);
  box(0, 0, nx, ny, 8);
  box(0, 0, nx, ny, 1);
  all.push_back(nx * ny > 1 ? Index{0, nx * ny - 1} : Index{0});
  return all;
}

rc_operator_spec spec_of(const rc_system& system, const StandInHost& host) {
  return {sizeof(rc_operator_spec), &system, kernel_name(system.boundary), host.options(), host.alone(), nullptr};
}

Walk::Walk(const Index& domain, std::int64_t points)
    : domain_(domain), half_(domain), x_(domain.size(), 1.0), single_(domain.size(), 1.0F), product_(domain.size()) {
  const auto n = static_cast<std::int64_t>(domain.size());
  half_.resize(domain.size() / 2 + 1);
  Index fewer = range(n / 10, n / 10 + n / 2), other;
  sets_ = {fewer};
  std::erase_if(fewer, [](std::int64_t i) { return i % 20 == 0; });
  for (std::int64_t i = 0; i + 1 < n; i += 1 + n / 4) other.push_back(i);
  for (const Index& set : {fewer, range(0, n - 1), other}) sets_.push_back(set);
  std::erase_if(sets_, [](const Index& set) { return set.empty(); });
  gap_.assign(static_cast<std::size_t>(points), 0.0);
  y_ = gap_;
}

rc_status Walk::operator()(const rc_backend& backend, void* self) {
  const rc_domain all{sizeof(rc_domain), static_cast<std::int64_t>(domain_.size()), domain_.data(), 0.0},
      part{sizeof(rc_domain), static_cast<std::int64_t>(half_.size()), half_.data(), 0.0};
  const double* const x = x_.data();
  double* const y = y_.data();
  rc_status status = backend.bind(self, &all);
  if (status == RC_OK) status = backend.apply(self, x, y);
  if (status == RC_OK) status = backend.field(self, x, y);
  if (status == RC_OK && backend.apply_float) status = backend.apply_float(self, single_.data(), product_.data());
  for (const Index& set : sets_)
    if (status == RC_OK && backend.subset) status = backend.subset(self, static_cast<std::int64_t>(set.size()), set.data(), x, y);
  if (status == RC_OK && backend.shifted) status = backend.shifted(self, 0.5, x, y);
  if (status == RC_OK && backend.norm) status = backend.norm(self, y);
  if (status == RC_OK && backend.screen) {
    rc_screen request{.struct_size = sizeof(rc_screen),
                      .approach = 1.0,
                      .unit = 1.0,
                      .undeformed_gap = {gap_.data(), RC_NATIVE, 0, nullptr},
                      .y = y,
                      .room = 4,
                      .found = found_,
                      .depth = depth_};
    status = backend.screen(self, x, &request);
  }
  if (status == RC_OK) status = backend.bind(self, &part);
  if (status == RC_OK) status = backend.apply(self, x, y);
  return status;
}

rc_status Walk::from_creation(const rc_backend& backend, const rc_host& host, const rc_operator_spec& spec) {
  void* self = nullptr;
  rc_status status = backend.create(&host, &spec, &self);
  if (status != RC_OK) return status;
  status = (*this)(backend, self);
  backend.destroy(self);
  return status;
}

}  // namespace contract

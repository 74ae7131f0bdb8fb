#include "common/products.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "common/memory_limit.h"
#include "common/serial_eigen.h"

namespace rc_common {

namespace {

constexpr double most_lent = 67108864.0;  // bytes of a matrix that is lent; larger ones count against their operator's limit

}  // namespace

void estimate_matrix(const rc_facts& facts, rc_estimate& estimate, const roughcontact::Component& component, const char* key) {
  constexpr double operation = 1e-10;        // [s]
  constexpr double least_limit = 1048576.0;  // that the option can be set to
  const auto n = static_cast<double>(facts.n), points = static_cast<double>(facts.system->nx * facts.system->ny);
  if (facts.system->op == RC_OPERATOR_HALFSPACE) estimate.bytes = SymmetricMatrix::bytes(n);
  if (estimate.bytes > least_limit) {
    const rc_operator_spec spec = {sizeof spec, facts.system, "", facts.options, nullptr, nullptr};
    MemoryLimit(facts.host, spec, component, key).require("the matrix", facts.n, estimate.bytes);
  }
  // An entry takes half an operation from the first cache and four from memory.
  const double entry = std::clamp(n / 500, 0.5, 4.0);
  estimate.seconds = operation * 4 * n * n;
  estimate.product = operation * entry * n * n;
  estimate.field = operation * 0.5 * n * points;
  estimate.factor = operation * n * n * n / 81;
}

Products::Products(const rc_host* host, const rc_operator_spec& spec, const roughcontact::Component& component)
    : system_(spec.system), influence_(make_influence(host, spec, component)) {
  const std::string key = component.name + std::string(" matrices");
  pool_ = roughcontact::shared<Pool<Stored>>(host, component, key, [] { return std::make_unique<Pool<Stored>>(); });
}

bool Products::is_bound(const rc_domain& domain) const {
  if (domain.n != size()) return false;
  for (std::int64_t i = 0; i < domain.n; ++i)
    if (points_[static_cast<std::size_t>(i)] != point(domain.index ? domain.index[i] : i)) return false;
  return true;
}

// Members change only after all that can fail has succeeded.
Products::Change Products::bind(const rc_domain& domain) {
  const bool same_entries = domain.zero_mode == zero_mode_;
  if (same_entries && is_bound(domain)) return Change::none;
  std::vector<Point> points(static_cast<std::size_t>(domain.n));
  for (std::int64_t i = 0; i < domain.n; ++i) points[static_cast<std::size_t>(i)] = point(domain.index ? domain.index[i] : i);
  points_ = std::move(points);
  influence_->set_zero_mode(domain.zero_mode);
  zero_mode_ = domain.zero_mode;
  matrix_.reset();
  return same_entries ? Change::points : Change::entries;
}

std::vector<Point> Products::points_at(std::span<const std::int64_t> positions) const {
  std::vector<Point> points(positions.size());
  std::transform(positions.begin(), positions.end(), points.begin(),
                 [this](std::int64_t i) { return points_[static_cast<std::size_t>(i)]; });
  return points;
}

// Entries are needed for offsets within the domain's bounding box.
const Influence& Products::entries() {
  const auto [left, right] = std::minmax_element(points_.begin(), points_.end(), [](Point a, Point b) { return a.x < b.x; });
  influence_->prepare(right->x - left->x + 1, points_.back().y - points_.front().y + 1);
  return *influence_;
}

void Products::store() {
  if (matrix_) return;
  if (bytes() <= most_lent) {
    const auto mine = [&](const Stored& other) { return other.zero_mode == zero_mode_ && other.points == points_; };
    if (Stored found = pool_->take(mine); found.matrix && mine(found)) {
      matrix_ = std::move(found.matrix);
      return;
    }
  }
  matrix_ = std::make_unique<SymmetricMatrix>(size(), source());
}

void Products::rest() {
  if (!matrix_ || bytes() > most_lent) return;
  Stored lent{points_, zero_mode_, std::move(matrix_)};
  matrix_.reset();
  pool_->give(std::move(lent));
}

void Products::apply(const double* x, double* y) {
  if (matrix_)
    matrix_->multiply(x, y);
  else
    entries().multiply(points_, x, runs_of(points_), y);
}

void Products::field(const double* x, double* y) {
  const std::int64_t nx = system_->nx, ny = system_->ny;
  influence_->prepare(nx, ny);
  std::vector<Run> rows(static_cast<std::size_t>(ny));
  for (std::int64_t iy = 0; iy < ny; ++iy) rows[static_cast<std::size_t>(iy)] = {{iy, 0}, nx, iy * nx};
  influence_->multiply(points_, x, rows, y);
}

// Row by row of the upper triangle, so that rounding grows with one row's length and the number of rows, not with their product.
double Products::norm() {
  const ColumnSource column = source();
  std::vector<double> entries_of_row(points_.size());
  double sum = 0.0;
  for (std::int64_t j = 0; j < size(); ++j) {
    double* const h = entries_of_row.data();
    column(j, size() - j, j, h);
    sum += h[0] * h[0] + 2.0 * Eigen::Map<const Eigen::VectorXd>(h + 1, size() - j - 1).squaredNorm();
  }
  return std::sqrt(sum);
}

}  // namespace rc_common

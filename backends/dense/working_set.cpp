#include "working_set.h"

#include <algorithm>
#include <numeric>

#include "common/serial_eigen.h"
#include "failure.h"

namespace rc_dense {

void WorkingSet::clear() {
  factor_.clear();
  points_.clear();
  rotated_ = 0;
}

void WorkingSet::solve(const Influence& H, std::span<const Point> points, const double* b, double* x) {
  try {
    update(H, points);
  } catch (...) {
    clear();
    throw;
  }
  const std::vector<std::int64_t> order = ascending();
  std::vector<double> rhs(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) rhs[static_cast<std::size_t>(order[i])] = b[i];
  std::vector<double> solution = rhs;
  factor_.solve(solution.data());
  if (rotated_ > 0) refine(H, rhs, solution);
  for (std::size_t i = 0; i < points.size(); ++i) x[i] = solution[static_cast<std::size_t>(order[i])];
}

// Positions of the factor's points in ascending order of the points.
std::vector<std::int64_t> WorkingSet::ascending() const {
  std::vector<std::int64_t> order(points_.size());
  std::iota(order.begin(), order.end(), 0);
  const Point* point = points_.data();
  std::sort(order.begin(), order.end(), [point](std::int64_t i, std::int64_t j) { return point[i] < point[j]; });
  return order;
}

// Brings the factor to this set of points.
void WorkingSet::update(const Influence& H, std::span<const Point> points) {
  std::vector<std::int64_t> removed;
  std::vector<Point> added;
  auto wanted = points.begin();
  for (const std::int64_t i : ascending()) {
    const Point present = points_[static_cast<std::size_t>(i)];
    while (wanted != points.end() && *wanted < present) added.push_back(*wanted++);
    if (wanted != points.end() && *wanted == present)
      ++wanted;
    else
      removed.push_back(i);
  }
  added.insert(added.end(), wanted, points.end());
  if (!removed.empty()) {
    std::sort(removed.begin(), removed.end());
    remove(removed, added);
  }
  append(H, added);
}

// Removes points by rotations, or by cutting the factor off before the first of them. Points that are cut off but stay are put in
// front of `added`: the latest points are the likeliest to leave, which is cheap at the end. After as many rotations as unknowns
// the factor is built anew, because it has then been rounded as often as by a factorization.
void WorkingSet::remove(std::span<const std::int64_t> removed, std::vector<Point>& added) {
  const auto count = static_cast<std::int64_t>(removed.size());
  const bool worn = rotated_ + count > factor_.size();
  const bool rotations = !worn && rotations_pay(factor_.size(), removed, static_cast<std::int64_t>(added.size()));

  for (auto i = removed.rbegin(); i != removed.rend(); ++i) points_.erase(points_.begin() + *i);
  if (rotations) {
    factor_.remove(removed);
    rotated_ += count;
    return;
  }
  const std::int64_t leading = worn ? 0 : removed.front();
  added.insert(added.begin(), points_.begin() + leading, points_.end());
  points_.resize(static_cast<std::size_t>(leading));
  factor_.truncate(leading);
  if (leading == 0) rotated_ = 0;
}

void WorkingSet::append(const Influence& H, std::span<const Point> added) {
  const auto count = static_cast<std::int64_t>(added.size());
  const std::int64_t needed = factor_.size() + count;
  points_.insert(points_.end(), added.begin(), added.end());
  const std::span<const Point> points(points_);
  const auto entries = [&](std::int64_t first_row, std::int64_t rows, std::int64_t column, double* out) {
    H.column(points.subspan(static_cast<std::size_t>(first_row), static_cast<std::size_t>(rows)),
             points[static_cast<std::size_t>(column)], out);
  };
  if (const auto bad = factor_.append(count, entries))
    fail(RC_ERR_NUMERIC, "the matrix is not positive definite: pivot ", bad->unknown + 1, " of ", needed, " is ", bad->value,
         "; it must be symmetric positive definite on every set of points (a periodic one with zero mode 0 is not on all of "
         "them)");
}

// One step of iterative refinement with the exact entries: it costs about as much as the solve.
void WorkingSet::refine(const Influence& H, std::span<const double> b, std::span<double> x) const {
  const auto n = static_cast<Eigen::Index>(points_.size());
  const Eigen::Map<const Eigen::VectorXd> rhs(b.data(), n);
  Eigen::Map<Eigen::VectorXd> solution(x.data(), n);
  Eigen::VectorXd residual = rhs, lower(n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const Eigen::Index below = n - j - 1;
    const auto h = lower.tail(below + 1);
    H.column(std::span(points_).subspan(static_cast<std::size_t>(j)), points_[static_cast<std::size_t>(j)], lower.data() + j);
    residual.tail(below + 1) -= solution(j) * h;
    residual(j) -= h.tail(below).dot(solution.tail(below));
  }
  factor_.solve(residual.data());
  solution += residual;
}

}  // namespace rc_dense

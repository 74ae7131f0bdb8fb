#include "working_set.h"

#include <algorithm>
#include <cmath>

namespace rc_cholmod {

using rc_common::Influence;
using rc_common::Point;

namespace {

// Adding or deleting a row costs about as much as a solve. A new factor costs n/6 solves with the slowest BLAS, less with others.
constexpr std::int64_t changes_that_pay = 8;
// Relative residual before refinement above which the factor is built anew: its rows have been changed too often.
constexpr double too_inexact = 1e-9;

}  // namespace

void WorkingSet::clear() {
  factor_.reset();
  members_.clear();
  free_.clear();
  changes_ = 0;
}

std::int64_t WorkingSet::slots_for(std::int64_t points, std::int64_t n) { return std::min(n, points + points / 8 + 8); }

void WorkingSet::solve(const Influence& H, std::span<const Point> points, std::int64_t n, const double* b, double* x) {
  try {
    if (!update(H, points)) factor(H, points, n);
    solve_once(b, x);
    if (changes_ > 0 && !refine(H, b, x)) {
      factor(H, points, n);
      solve_once(b, x);
    }
  } catch (...) {
    clear();
    throw;
  }
}

// Brings the factor to these points by single rows. False if a new one is needed.
bool WorkingSet::update(const Influence& H, std::span<const Point> points) {
  if (!factor_) return false;
  std::vector<Member> kept, removed;
  std::vector<Point> added;
  auto wanted = points.begin();
  for (const Member& member : members_) {
    while (wanted != points.end() && *wanted < member.point) added.push_back(*wanted++);
    const bool stays = wanted != points.end() && *wanted == member.point;
    (stays ? kept : removed).push_back(member);
    if (stays) ++wanted;
  }
  added.insert(added.end(), wanted, points.end());
  const auto changes = static_cast<std::int64_t>(removed.size() + added.size());
  const auto size = static_cast<std::int64_t>(members_.size());
  const bool room = added.size() <= removed.size() + free_.size();
  if (!room || changes_that_pay * changes > size || (changes > 0 && changes_ + changes > size)) return false;

  changes_ += changes;
  for (const Member& member : removed) {
    factor_->remove(member.slot);
    free_.push_back(member.slot);
  }
  members_ = std::move(kept);
  std::sort(free_.begin(), free_.end());  // back() has the fewest rows below it, so adding it costs least
  return std::all_of(added.begin(), added.end(), [&](Point point) { return add(H, point); });
}

bool WorkingSet::add(const Influence& H, Point point) {
  const std::int64_t slot = free_.back();
  free_.pop_back();
  const auto place = std::lower_bound(members_.begin(), members_.end(), point,
                                      [](const Member& member, Point other) { return member.point < other; });
  members_.insert(place, {point, slot});
  std::vector<Member> by_slot = members_;
  std::sort(by_slot.begin(), by_slot.end(), [](const Member& a, const Member& b) { return a.slot < b.slot; });
  std::vector<Point> rows;
  std::vector<std::int64_t> slots;
  for (const Member& member : by_slot) {
    rows.push_back(member.point);
    slots.push_back(member.slot);
  }
  std::vector<double> entries(rows.size());
  H.column(rows, point, entries.data());
  return factor_->add(slot, static_cast<std::int64_t>(slots.size()), slots.data(), entries.data());
}

void WorkingSet::factor(const Influence& H, std::span<const Point> points, std::int64_t n) {
  clear();
  const auto size = static_cast<std::int64_t>(points.size());
  const std::int64_t slots = slots_for(size, n);
  const auto entries = [&](std::int64_t first_row, std::int64_t rows, std::int64_t column, double* out) {
    H.column(points.subspan(static_cast<std::size_t>(first_row), static_cast<std::size_t>(rows)),
             points[static_cast<std::size_t>(column)], out);
  };
  factor_.emplace(session_, size, slots, entries, 0.0);
  for (std::int64_t i = 0; i < size; ++i) members_.push_back({points[static_cast<std::size_t>(i)], i});
  for (std::int64_t i = size; i < slots; ++i) free_.push_back(i);
}

void WorkingSet::solve_once(const double* b, double* x) {
  std::vector<double> rhs(static_cast<std::size_t>(factor_->slots()), 0.0);
  for (std::size_t i = 0; i < members_.size(); ++i) rhs[static_cast<std::size_t>(members_[i].slot)] = b[i];
  factor_->solve(rhs.data());
  for (std::size_t i = 0; i < members_.size(); ++i) x[i] = rhs[static_cast<std::size_t>(members_[i].slot)];
}

// One step of iterative refinement with the exact entries. False if the factor has become too inexact for it.
bool WorkingSet::refine(const Influence& H, const double* b, double* x) {
  const std::size_t n = members_.size();
  std::vector<Point> points(n);
  std::transform(members_.begin(), members_.end(), points.begin(), [](const Member& member) { return member.point; });
  std::vector<double> residual(n), correction(n);
  H.multiply(points, x, rc_common::runs_of(points), residual.data());
  double largest = 0.0, scale = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    residual[i] = b[i] - residual[i];
    largest = std::max(largest, std::abs(residual[i]));
    scale = std::max(scale, std::abs(b[i]));
  }
  if (!(largest <= too_inexact * scale)) return false;
  solve_once(residual.data(), correction.data());
  for (std::size_t i = 0; i < n; ++i) x[i] += correction[i];
  return true;
}

}  // namespace rc_cholmod

// The rows of a grid that this process has: all of them, or its share if ranks share the grid. Then all ranks call the same
// functions. If the grid is not shared, each function is the plain action.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "core/ranks.h"

namespace rc {

class Rows {
 public:
  Rows() = default;
  // The ranks must outlive the rows.
  explicit Rows(const Ranks& ranks) : ranks_(std::shared_ptr<void>(), &ranks) {}
  static Rows of(const Ranks* ranks) { return ranks ? Rows(*ranks) : Rows(); }
  Rows halved() const { return Rows(std::make_shared<const Ranks>(ranks_->halved())); }  // of shared rows, on half as many

  // Then every point stays an unknown, and nothing that needs all points here is done: systems on subsets, solvers inside
  // solvers, answers that solvers keep for the next step.
  bool shared() const { return ranks_ != nullptr; }
  const Ranks* ranks() const { return ranks_.get(); }  // null: not shared
  std::int64_t first() const { return ranks_ ? ranks_->first_row() : 0; }
  std::int64_t own(std::int64_t ny) const { return ranks_ ? ranks_->rows() : ny; }
  std::int64_t all(std::int64_t ny) const { return ranks_ ? ranks_->all_rows() : ny; }

  int halvings() const { return ranks_ ? ranks_->halvings() : 0; }  // how often shared rows can be halved
  // act(first row, end) for the rows of each rank, in their order; nothing if rows are not shared.
  template <class Act> void each_share(const Act& act) const {
    for (std::int64_t rank = 0; ranks_ && rank < ranks_->size(); ++rank) {
      const auto k = static_cast<std::size_t>(rank);
      act(ranks_->first()[k], ranks_->first()[k + 1]);
    }
  }
  // Shared rows as solvers and backends see them, in a place that outlives their use; null: not shared.
  const rc_rows* seen(SharedRows& place) const { return ranks_ ? &(place = SharedRows(*ranks_)) : nullptr; }

  // The same action on all ranks, with exchanges in it; it fails on all if it fails on one.
  template <class Action> void together(const Action& action) const { ranks_ ? ranks_->together(action) : action(); }
  // An action that may throw, and fails on all ranks if it fails on one.
  template <class Action> void on_all(const Action& action) const { rc::on_all(ranks(), action); }
  bool any(bool mine) const { return ranks_ ? ranks_->any(mine) : mine; }
  template <class Value> std::vector<Value> of_each(const Value& mine) const {
    return ranks_ ? ranks_->of_each(mine) : std::vector<Value>{mine};
  }
  // The rows of all ranks, [all rows * columns], from this rank's; nothing if rows are not shared.
  template <class Value> void gather(const Value* mine, std::int64_t columns, Value* all) const {
    if (ranks_) ranks_->gather_rows(mine, columns, all);
  }
  // As many values as each rank has, in the order of their rows.
  template <class Value> std::vector<Value> joined(std::vector<Value> mine) const {
    return ranks_ ? ranks_->of_any(mine) : std::move(mine);
  }
  // The sum of one value of each rank, if the order does not matter.
  template <class Part> Part united(const Part& mine) const {
    if (!ranks_) return mine;
    Part total{};
    for (const Part& part : ranks_->of_each(mine)) total = total + part;
    return total;
  }

 private:
  explicit Rows(std::shared_ptr<const Ranks> ranks) : ranks_(std::move(ranks)) {}

  std::shared_ptr<const Ranks> ranks_;
};

}  // namespace rc

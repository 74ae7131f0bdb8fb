// With whom a process solves a contact. Alone it has every point of the grid. By rows it has the points of its share, all of them
// are unknowns, and all ranks call the same functions. Replicated: each has every point and does what the others do; they agree
// on stops. If a process is alone, each function is the plain action.
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "core/rows.h"

namespace rc {

class Company {
 public:
  Company() = default;
  explicit Company(Rows rows) : rows_(std::move(rows)) {}
  // The ranks that share rows, each working on all points.
  Company replicated() const {
    Company company;
    company.replicated_ = rows_;
    return company;
  }
  // Processes that do the same by themselves, without a word to each other.
  static Company repeated() {
    Company company;
    company.repeated_ = true;
    return company;
  }

  const Rows& rows() const { return rows_; }
  // A component that fails here may work on another rank: "auto" continues without it only if no other rank must do the same.
  bool may_pass_over() const { return !rows_.shared() && !replicated_.shared() && !repeated_; }
  // Clocks of several ranks differ: they stop together, between iterations.
  bool stops_between_products() const { return !replicated_.shared(); }

  // At the begin of a step.
  void forget_stop() const {
    if (rows_.shared()) rows_.ranks()->forget_stop();
  }
  // Once an iteration, with what this process's monitor says. Returns what holds for all.
  rc_status agreed(rc_status mine) const;
  // Before a product: the stop that all have agreed on; nothing if this process decides by itself.
  std::optional<rc_status> stop() const {
    if (rows_.shared()) return rows_.ranks()->stop();
    return stops_between_products() ? std::nullopt : std::optional<rc_status>(RC_OK);
  }

 private:
  Rows rows_, replicated_;
  bool repeated_ = false;
};

}  // namespace rc

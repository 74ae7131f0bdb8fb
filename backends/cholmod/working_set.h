// Solves with H[a,a] for sets of grid points that change a little from one call to the next.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "common/influence.h"
#include "factor.h"

namespace rc_cholmod {

class WorkingSet {
 public:
  explicit WorkingSet(Session& session) : session_(session) {}

  // H[points, points] x = b for ascending points of a domain of n. On failure the factor is dropped.
  void solve(const rc_common::Influence&, std::span<const rc_common::Point> points, std::int64_t n, const double* b, double* x);
  void clear();
  // Slots of a factor that is made for this many points.
  static std::int64_t slots_for(std::int64_t points, std::int64_t n);

 private:
  struct Member {
    rc_common::Point point;
    std::int64_t slot;
  };

  bool update(const rc_common::Influence&, std::span<const rc_common::Point> points);
  void factor(const rc_common::Influence&, std::span<const rc_common::Point> points, std::int64_t n);
  bool add(const rc_common::Influence&, rc_common::Point point);
  bool refine(const rc_common::Influence&, const double* b, double* x);
  void solve_once(const double* b, double* x);

  Session& session_;
  std::optional<Factor> factor_;
  std::vector<Member> members_;     // in the order of their points
  std::vector<std::int64_t> free_;  // slots
  std::int64_t changes_ = 0;        // rows added and deleted since the factor was made
};

}  // namespace rc_cholmod

// The coarser grids of one step: halved from the given grid down, solved from the coarsest up, each once.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "contact/answer.h"
#include "contact/coarse/level.h"
#include "contact/monitor.h"
#include "contact/problem.h"
#include "contact/target.h"

namespace rc {

class Pyramid {
 public:
  // given: the grid of the step; monitor: that of the step. Both must outlive the pyramid.
  Pyramid(const GridProblem& given, const Target& target, const Monitor& monitor)
      : given_(given), target_(target), monitor_(monitor) {}

  const Target& target() const { return target_; }
  // The coarsest level that is not solved; null: there is none. At first the given grid is halved until a side has less than 128
  // points, or nothing touches. The levels stay until they are solved, also if a solve fails.
  const Level* next();
  // The pressures of the level that was solved last, on the next one or on the given grid; nothing if they vanish.
  std::optional<Estimate> estimate() const;
  // The answer of the next level, which is dropped.
  void solved(Answer&& answer);
  // Drops the levels and what they have shown; the given grid starts without them.
  void give_up();
  // Whether levels are left to be made or solved.
  bool climbing() const { return building_ || !levels_.empty(); }

 private:
  // The answer on the level that was solved last.
  struct Reached {
    Pressures pressures;  // positive ones, on that level
    double approach;      // [length]
    int halvings;         // from the next finer grid
  };

  void build();
  // The coarsest grid that is left.
  const GridProblem& coarsest() const { return levels_.empty() ? given_ : levels_.back()->problem(); }

  const GridProblem& given_;
  const Target target_;
  const Monitor& monitor_;
  bool built_ = false, building_ = false;
  std::vector<std::unique_ptr<Level>> levels_;  // that are not solved, the finest first
  std::optional<Reached> reached_;
};

}  // namespace rc

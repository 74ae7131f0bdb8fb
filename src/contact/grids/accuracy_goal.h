// No more than the scene needs: where an accuracy of load or area is asked for, grids are solved from coarse to fine until one
// may be within the goal, which a look at the given grid then decides.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "contact/answer.h"
#include "contact/grids/grid_pyramid.h"
#include "contact/step/monitor.h"

namespace rc {

class AccuracyGoal {
 public:
  AccuracyGoal();
  ~AccuracyGoal();

  // Of a step on the given grid that has begun; some point touches. True: the result is written, within the goal or as a stop
  // left it, and result.status tells which. False: the whole grid must be solved, from the estimate if there is one.
  bool solve(GridContact& given, const rc_step& step, Monitor& monitor, rc_result& result, std::optional<Estimate>& estimate);
  // Adds what the coarser grids of this step took.
  void add_work(rc_result& result) const;

  void clear() { grids_.clear(); }
  void forget();  // earlier steps, and what operators remember of them

 private:
  struct Grid {
    HalvedGrid halved;
    rc_result result{};  // of this step
    std::vector<double> gap;
  };
  struct Found {
    std::size_t grid = 0;              // the last that was solved, if it is of use; 0: none
    rc_status status = RC_OK;          // a stop, or RC_WITHIN_GOAL: it is worth a look at the given grid
    std::optional<Estimate> estimate;  // for the whole grid
  };

  void halve(GridContact& given);
  // Grid k: each of its cells stands for 2^k x 2^k of the given grid's. 1: the finest of the coarser ones.
  static Blocks blocks_of(const Workspace& given, std::size_t k);
  rc_status solve_on(std::size_t k, const Workspace& given, const rc_step& step, const Monitor& monitor,
                     std::optional<Estimate> estimate, bool with_gap);
  Found from_coarse_to_fine(GridContact& given, const rc_step& step, const Monitor& monitor, bool with_gap);
  bool look(GridContact& given, const rc_step& step, Found& found, Monitor& monitor, rc_result& result);
  void deliver_stopped(Workspace& given, const rc_step& step, const Found& found, const Monitor& monitor, rc_result& result);

  std::vector<Grid> grids_;    // the finest first
  std::int64_t surface_ = -1;  // of the given contact's, the one that they show
};

}  // namespace rc

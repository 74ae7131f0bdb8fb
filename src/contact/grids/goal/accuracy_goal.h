// An accuracy goal of load or area: grids are solved from coarse to fine until one may be within the goal. A look at the given
// grid then decides whether it is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "contact/grids/pyramid.h"
#include "contact/step/answer.h"
#include "contact/step/monitor.h"

namespace rc {

class AccuracyGoal {
 public:
  AccuracyGoal();
  ~AccuracyGoal();

  // Solves a step that has begun on the given grid, with some point in contact. True: the result is written; result.status tells
  // whether it is within the goal or stopped. False: the whole grid must be solved, from the estimate if there is one.
  bool solve(GridContact& given, const rc_step& step, Monitor& monitor, rc_result& result, std::optional<Estimate>& estimate);
  // Adds the iterations, products and seconds of this step's coarser grids.
  void add_work(rc_result& result) const;

  void clear() { grids_.clear(); }
  void forget();  // earlier steps, also in the operators

 private:
  struct Grid {
    HalvedGrid halved;
    rc_result result{};  // of this step
    std::vector<double> gap;
  };
  struct Found {
    std::size_t grid = 0;              // the last grid that was solved, if it is of use; 0: none
    rc_status status = RC_OK;          // a stop, or RC_WITHIN_GOAL: worth a look at the given grid
    std::optional<Estimate> estimate;  // for the whole grid
  };

  void halve(GridContact& given);
  // The blocks of the given grid that are the cells of grid k, 2^k x 2^k each. k = 1 is the finest of the coarser grids.
  static Blocks blocks_of(const Workspace& given, std::size_t k);
  rc_status solve_on(std::size_t k, const Workspace& given, const rc_step& step, const Monitor& monitor,
                     std::optional<Estimate> estimate, bool with_gap);
  Found from_coarse_to_fine(GridContact& given, const rc_step& step, const Monitor& monitor, bool with_gap);
  bool look(GridContact& given, const rc_step& step, Found& found, Monitor& monitor, rc_result& result);
  void deliver_stopped(Workspace& given, const rc_step& step, const Found& found, const Monitor& monitor, rc_result& result);

  std::vector<Grid> grids_;    // the finest first
  std::int64_t surface_ = -1;  // number of the given contact's surface that the grids show
};

}  // namespace rc

// An accuracy goal of load or area: grids are solved from coarse to fine until one may be within the goal. A look at the given
// grid then decides whether it is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "contact/coarse/level.h"
#include "contact/grids/grid_contact.h"
#include "contact/surface/blocks.h"

namespace rc {

class AccuracyGoal {
 public:
  AccuracyGoal();
  ~AccuracyGoal();

  // Solves a step that has begun on the given grid, with some point in contact. The numbers' status tells whether it is within
  // the goal or stopped. Nothing: the whole grid must be solved, from the estimate if there is one.
  std::optional<Numbers> solve(GridContact& given, const Step& step, Monitor& monitor, const Outputs& outputs,
                               std::optional<Estimate>& estimate);
  // Adds the iterations, products and seconds of this step's coarser grids. monitor: of the step.
  void add_work(const Monitor& monitor, Work& work) const;

  void clear() { grids_.clear(); }
  void forget();  // earlier steps, also in the operators

 private:
  struct Grid {
    CoarseGrid surface;  // the contact borrows it
    std::unique_ptr<GridContact> contact;
    Numbers numbers = {};  // of this step
    std::vector<double> gap = {};
  };
  struct Found {
    std::size_t grid = 0;              // the last grid that was solved, if it is of use; 0: none
    rc_status status = RC_OK;          // a stop, or RC_WITHIN_GOAL: worth a look at the given grid
    std::optional<Estimate> estimate;  // for the whole grid
  };

  void halve(GridContact& given);
  // The blocks of the given grid that are the cells of grid k, 2^k x 2^k each. k = 1 is the finest of the coarser grids.
  static Blocks blocks_of(const GridProblem& given, std::size_t k);
  rc_status solve_on(std::size_t k, const GridProblem& given, const Step& step, const Monitor& monitor,
                     const std::optional<Estimate>& estimate, bool with_gap);
  Found from_coarse_to_fine(GridContact& given, const Step& step, const Monitor& monitor, bool with_gap);
  std::optional<Numbers> look(GridContact& given, const Step& step, Found& found, Monitor& monitor, const Outputs& outputs);
  Numbers stopped(const GridProblem& given, const Step& step, const Found& found, const Monitor& monitor, const Outputs& outputs);

  std::vector<Grid> grids_;    // the finest first
  std::int64_t surface_ = -1;  // number of the given contact's surface that the grids show
};

}  // namespace rc

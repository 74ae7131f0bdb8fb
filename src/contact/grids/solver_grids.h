// Solutions on coarser grids that a solver asks for. Each grid is a contact of its own and is kept for the next step.
#pragma once

#include <roughcontact/history.h>
#include <roughcontact/plugin.h>

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "contact/problem.h"

namespace rc {

class GridContact;

class SolverGrids : public CoarseGrids {
 public:
  SolverGrids();
  ~SolverGrids() override;

  rc_status solve(rc_coarse& request, const GridProblem& problem, const Attempt& attempt) override;
  // Solution i of the current step, the coarsest first. Throws Error(ARGUMENT).
  void describe(std::int64_t i, rc_level& out) const;
  std::int64_t current() const;  // how many there are

  void start_solve();  // from here on the present solutions belong to an earlier step
  void forget();       // keeps the contacts, in the state of new ones
  void clear();

 private:
  rc_status solve_shared(rc_coarse& request, const GridProblem& problem, bool warm, const rc_system& system, rc_options options);

  struct Level {
    std::unique_ptr<GridContact> contact;
    rc_level summary{};
    std::vector<double> p;
    bool current = false;  // of this step
  };
  std::map<std::int64_t, Level> levels_;  // by number of points
};

}  // namespace rc

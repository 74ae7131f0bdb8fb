// Finds and solves steps whose contact is far sparser than the grid.
#pragma once

#include <optional>

#include "contact/answer.h"
#include "contact/attempt.h"
#include "contact/coarse/pyramid.h"
#include "contact/memory/memory.h"
#include "contact/problem.h"
#include "contact/target.h"

namespace rc {

struct SparseContact {
  std::optional<Answer> answer;     // nothing if contact is not sparse, or the options leave no backend that screens
  std::optional<Estimate> instead;  // a start for the whole grid, if coarser grids have found dense contact
};

// pyramid: of this step and grid.
SparseContact sparse_contact(const GridProblem& problem, const Memory& memory, const Step& step, Pyramid& pyramid,
                             const Attempt& attempt);

}  // namespace rc

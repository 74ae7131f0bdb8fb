// Contact at few of the points. The last steps or coarser grids estimate where it is, and the tiles there become the unknowns.
// The operator screens all other points for overlap, without a product over the whole grid. Tiles that overlap are added and the
// step is solved again, so the answer is that of all points. If the operator cannot screen, as with periodic boundaries, single
// points become the unknowns, and a product over the whole grid shows all others; processes make it together, and each checks its
// rows.
#pragma once

#include <optional>

#include "contact/answer.h"
#include "contact/attempt.h"
#include "contact/coarse/pyramid.h"
#include "contact/memory/start.h"
#include "contact/problem.h"
#include "contact/target.h"

namespace rc {

struct SparseContact {
  std::optional<Answer> answer;     // nothing if contact is not sparse, or the options leave no components for it
  std::optional<Estimate> instead;  // a start for the whole grid, if coarser grids have found dense contact
};

// few: of choose_for_few; pyramid: of this step and grid.
SparseContact sparse_contact(const GridProblem& problem, const Target& target, const Start& start, const Choice& few,
                             Pyramid& pyramid, const Attempt& attempt);
// From the estimate of an accuracy goal's coarser grid.
std::optional<Answer> sparse_contact_near(const Estimate& estimate, const GridProblem& problem, const Target& target,
                                          const Choice& few, const Attempt& attempt);

}  // namespace rc

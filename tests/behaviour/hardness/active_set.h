// 1/2 p'Hp - u'p over 0 <= p <= cap by an active set on a dense matrix (Stark & Parker 1995), without the library.
#pragma once

#include "support/naive.h"

namespace pairs {

/** matrix: n x n, row by row. skip: points that carry no pressure, true or false for each. */
Field solve_in_box(const Field& matrix, const Field& u, double cap, const std::vector<bool>& skip);

/** The pressures at this approach [force/length^2]. gap: with the indentation of earlier steps. */
Field pressures_at(const Problem& problem, const Field& matrix, const Field& gap, double approach);

}  // namespace pairs

// Small linear complementarity problems of many kinds, and a solution by other means than the library's.
#pragma once

#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace pivoting {

using Field = std::vector<double>;

/** w = H p - u, p >= 0, w >= 0, p w = 0, with H symmetric positive definite. */
struct RandomProblem {
  std::string kind;
  std::int64_t n = 0;
  Field matrix, u;
  std::optional<Field> solution;  // where the problem was made from one
};

/** The number decides: its kind, size, ties, and every value. */
RandomProblem make_problem(std::uint64_t number);

/** By trying every contact set; nothing for more than 10 unknowns. */
std::optional<Field> solution_by_enumeration(const RandomProblem& problem);

struct Violation {
  double tension, overlap, complementarity;  // relative to max p and max u
};
/** In extended precision. */
Violation violation(const RandomProblem& problem, const Field& p);

}  // namespace pivoting

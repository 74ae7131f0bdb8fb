#include <algorithm>
#include <random>

#include "cases.h"
#include "fixtures.h"
#include "support/cmocka.hpp"

namespace contract {

namespace {

Index points_of(const Index& domain, const Index& positions) {
  Index points;
  for (std::int64_t position : positions) points.push_back(domain[static_cast<std::size_t>(position)]);
  return points;
}

// Some positions of a domain of n points, never all: a periodic H without zero mode is singular on all of them.
Index some_positions(std::int64_t n, std::mt19937& generator) {
  Index positions;
  for (std::int64_t i = 0; i + 1 < n; ++i)
    if (generator() % 2) positions.push_back(i);
  return positions;
}

void add_or_remove(Index& positions, std::int64_t position) {
  const auto place = std::lower_bound(positions.begin(), positions.end(), position);
  if (place != positions.end() && *place == position)
    positions.erase(place);
  else
    positions.insert(place, position);
}

void check_solution(const Problem& problem, const Index& points, const Vector& b, const Vector& x) {
  double largest = 1.0;
  for (double value : x) largest = std::max(largest, value < 0 ? -value : value);
  assert_true(largest_difference(problem.matrix().product(points, points, x), b) <= 1e-12 * problem.matrix().norm() * largest);
}

}  // namespace

void subset_solves_its_equations(const rc_backend& backend) {
  for (const auto& [nx, ny] : {std::pair{1, 5}, {4, 4}, {9, 7}, {16, 11}})
    for_each_problem(backend, nx, ny, 1.0, 0.7, [&](const Problem& problem) {
      StandInHost host(backend);
      std::mt19937 generator(11);
      Operator op(backend, host, problem.system());
      for (const Index& domain : domains(problem.system().nx, problem.system().ny, 5)) {
        op.bind(domain, problem.zero_mode());
        const Index positions = some_positions(static_cast<std::int64_t>(domain.size()), generator);
        if (positions.empty()) continue;
        const Vector b = random_vector(positions.size(), 3);
        check_solution(problem, points_of(domain, positions), b, op.subset(positions, b));
      }
    });
}

// One set after another, a few points apart, with a jump now and then and a change of domain halfway.
void subset_after_changes_equals_a_fresh_solve(const rc_backend& backend) {
  for_each_problem(backend, 12, 10, 1.0, 1.0, [&](const Problem& problem) {
    StandInHost host(backend);
    std::mt19937 generator(29);
    Operator op(backend, host, problem.system());
    Index domain = problem.all();
    op.bind(domain, problem.zero_mode());
    Index positions = some_positions(static_cast<std::int64_t>(domain.size()), generator);
    for (int round = 0; round < 60; ++round) {
      if (round == 30) {
        domain = domains(12, 10, 4)[6];
        op.bind(domain, problem.zero_mode());
      }
      const auto n = static_cast<std::int64_t>(domain.size());
      if (round % 15 == 0) positions = some_positions(n, generator);
      for (unsigned change = generator() % 6; change > 0; --change)
        add_or_remove(positions, static_cast<std::int64_t>(generator()) % (n - 1));
      if (positions.empty()) continue;
      const Vector b = random_vector(positions.size(), 40u + static_cast<unsigned>(round));
      const Vector x = op.subset(positions, b);
      check_solution(problem, points_of(domain, positions), b, x);

      Operator fresh(backend, host, problem.system());
      fresh.bind(domain, problem.zero_mode());
      const Vector expected = fresh.subset(positions, b);
      assert_true(largest_difference(x, expected) <= 1e-11 * (1.0 + largest_difference(expected, Vector(expected.size(), 0.0))));
    }
  });
}

}  // namespace contract

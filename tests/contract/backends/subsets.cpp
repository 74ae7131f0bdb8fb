#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>

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

// One set after another, a few points apart, with a jump now and then and a change of domain halfway. A factor's parts may hold a
// hundred points or more: the larger grid has sets of four hundred.
void subset_after_changes_equals_a_fresh_solve(const rc_backend& backend) {
  for (const auto& [nx, ny] : {std::pair{12, 10}, {21, 20}})
    for_each_problem(backend, nx, ny, 1.0, 1.0, [&, nx = nx, ny = ny](const Problem& problem) {
      StandInHost host(backend);
      std::mt19937 generator(29);
      Operator op(backend, host, problem.system());
      Index domain = problem.all();
      op.bind(domain, problem.zero_mode());
      Index positions = some_positions(static_cast<std::int64_t>(domain.size()), generator);
      for (int round = 0; round < 120; ++round) {
        if (round == 80) {
          domain = domains(nx, ny, 4)[6];
          op.bind(domain, problem.zero_mode());
        }
        const auto n = static_cast<std::int64_t>(domain.size());
        if (round % 40 == 0) positions = some_positions(n, generator);
        if (round % 40 == 30) positions = range(0, n - 1);
        if (round % 40 == 34) std::erase_if(positions, [n](std::int64_t i) { return i % 2 == 0 && i > n / 3; });
        for (unsigned change = generator() % 8; change > 0; --change)
          add_or_remove(positions, static_cast<std::int64_t>(generator()) % (n - 1));
        if (positions.empty()) continue;
        const Vector b = random_vector(positions.size(), 40u + static_cast<unsigned>(round));
        const Vector x = op.subset(positions, b);
        check_solution(problem, points_of(domain, positions), b, x);

        Operator fresh(backend, host, problem.system());
        fresh.bind(domain, problem.zero_mode());
        const Vector expected = fresh.subset(positions, b);
        assert_true(largest_difference(x, expected) <=
                    1e-11 * (1.0 + largest_difference(expected, Vector(expected.size(), 0.0))));
      }
    });
}

// As a whole, also one row at a time; what can be solved is solved afterwards.
void matrices_that_are_not_definite_are_reported(const rc_backend& backend) {
  constexpr std::int64_t n = 200;
  for (const char* near_field : {"0", "2"})
    for (const double bad : {0.0, -0.25, std::numeric_limits<double>::quiet_NaN()}) {
      if (!(backend.caps & RC_CAP_DENSE_INPUT)) continue;
      StandInHost host(backend);
      if (std::string(backend.name) == "cholmod") host.set("cholmod.near_field", near_field);
      Vector H(n * n, 0.0);
      for (std::size_t i = 0; i < n; ++i) H[(n + 1) * i] = i == 170 ? bad : 1.0;
      const rc_system system = callers_matrix(H, n, n);
      Operator op(backend, host, system);
      op.bind(range(0, n));
      const Vector ones(n, 1.0);
      Vector x(n);
      const auto solved = [&](std::int64_t count) {
        return backend.subset(op.handle(), count, range(0, n).data(), ones.data(), x.data());
      };
      assert_int_equal(solved(n), RC_ERR_NUMERIC);
      const std::string& message = StandInHost::message();
      assert_true(message.find(backend.name) == 0 && message.find("positive definite") != std::string::npos);
      assert_int_equal(solved(15), RC_OK);
      assert_true(std::abs(x[3] - 1.0) < 1e-14);
      assert_int_equal(solved(170), RC_OK);
      assert_int_equal(solved(171), RC_ERR_NUMERIC);
      assert_int_equal(solved(170), RC_OK);
      if (bad == -0.25 && backend.shifted) {
        assert_int_equal(backend.shifted(op.handle(), 0.125, ones.data(), x.data()), RC_ERR_NUMERIC);
        assert_int_equal(backend.shifted(op.handle(), 1.0, ones.data(), x.data()), RC_OK);
        assert_true(std::abs(x[170] - 4.0 / 3.0) < 1e-14);
      }
    }
}

}  // namespace contract

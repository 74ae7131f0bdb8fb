// Shifted systems and the norm, compared with the full matrix.
#include <algorithm>
#include <cmath>

#include "cases.h"
#include "fixtures.h"
#include "support/cmocka.hpp"

namespace contract {

namespace {

constexpr double shifts[] = {0.05, 0.05, 2.0, 0.3};

void check_shifted(const Problem& problem, Operator& op, const Index& domain, double rho) {
  const Vector b = random_vector(domain.size(), 17);
  const Vector x = op.shifted(rho, b);
  Vector left = problem.matrix().product(domain, domain, x);
  double largest = 1.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    left[i] += rho * x[i];
    largest = std::max(largest, std::abs(x[i]));
  }
  assert_true(largest_difference(left, b) <= 1e-12 * (problem.matrix().norm() + rho) * largest);
}

double frobenius(const Matrix& matrix, const Index& domain) {
  long double sum = 0;
  for (std::int64_t i : domain)
    for (std::int64_t j : domain) sum += static_cast<long double>(matrix.row(i)[j]) * matrix.row(i)[j];
  return static_cast<double>(std::sqrt(sum));
}

}  // namespace

// On every domain, the periodic grid without zero mode included: the shift makes it definite.
void shifted_solves_its_equations(const rc_backend& backend) {
  for (const auto& [nx, ny] : {std::pair{1, 1}, {1, 5}, {9, 7}, {16, 11}})
    for_each_problem(backend, nx, ny, 1.0, 0.7, [&](const Problem& problem) {
      StandInHost host(backend);
      Operator op(backend, host, problem.system());
      for (const Index& domain : domains(problem.system().nx, problem.system().ny, 5)) {
        op.bind(domain, problem.zero_mode());
        for (double rho : shifts) check_shifted(problem, op, domain, rho);
      }
    });
}

// Solves on subsets, products and other zero modes in between.
void shifted_does_not_depend_on_what_was_asked_before(const rc_backend& backend) {
  for_each_problem(backend, 9, 8, 1.0, 1.0, [&](const Problem& problem) {
    StandInHost host(backend);
    Operator op(backend, host, problem.system());
    const Index domain = domains(9, 8, 6)[5];
    op.bind(domain, problem.zero_mode() + 1.0);
    const Vector b = random_vector(domain.size(), 18);
    static_cast<void>(op.shifted(0.4, b));
    op.bind(domain, problem.zero_mode());
    check_shifted(problem, op, domain, 0.4);
    if (backend.caps & RC_CAP_SUBSET) {
      const Index some{0, 2, 3, 7};
      static_cast<void>(op.subset(some, random_vector(some.size(), 19)));
    }
    static_cast<void>(op.apply(b));
    check_shifted(problem, op, domain, 0.4);
  });
}

void norm_is_that_of_the_matrix(const rc_backend& backend) {
  for (const auto& [nx, ny] : {std::pair{1, 1}, {2, 1}, {12, 1}, {9, 7}, {16, 11}, {31, 8}})
    for (double hy : {1.0, 0.6})
      for_each_problem(backend, nx, ny, 1.0, hy, [&](const Problem& problem) {
        StandInHost host(backend);
        Operator op(backend, host, problem.system());
        for (const Index& domain : domains(problem.system().nx, problem.system().ny, 9)) {
          op.bind(domain, problem.zero_mode());
          const double expected = frobenius(problem.matrix(), domain);
          assert_true(std::abs(op.norm() - expected) <= 1e-12 * expected);
          const Vector x = random_vector(domain.size(), 20);  // the product is as before
          assert_true(largest_difference(op.apply(x), problem.matrix().product(domain, domain, x)) <=
                      1e-13 * problem.matrix().norm());
        }
      });
}

}  // namespace contract

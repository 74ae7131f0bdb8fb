#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "cases.h"
#include "fixtures.h"
#include "support/cmocka.hpp"

namespace contract {

namespace {

constexpr std::int64_t sizes[][2] = {{1, 1},  {1, 12},  {12, 1}, {2, 2},   {3, 3},  {5, 7},   {17, 17}, {6, 15},
                                     {31, 8}, {128, 3}, {72, 2}, {121, 1}, {65, 5}, {3, 128}, {1, 121}};

Vector random_for(const Index& domain, unsigned seed = 1) { return random_vector(domain.size(), seed); }

void check_products(const Problem& problem, Operator& op, const Index& domain, double tolerance) {
  Vector x = random_for(domain);
  const double scale = problem.matrix().norm();
  assert_true(largest_difference(op.field(x), problem.matrix().product(problem.all(), domain, x)) <= tolerance * scale);
  for (const std::size_t zeros : {std::size_t{0}, domain.size() - 1}) {  // none, or all but the last
    std::fill_n(x.begin(), zeros, 0.0);
    assert_true(largest_difference(op.apply(x), problem.matrix().product(domain, domain, x)) <= tolerance * scale);
  }
  assert_in_range(op.modelled(), domain.size(), problem.matrix().size());
}

}  // namespace

void products_agree_with_the_matrix(const rc_backend& backend) {
  for (const auto& [nx, ny] : sizes)
    for (double hy : {1.0, 0.6})
      for_each_problem(backend, nx, ny, 1.0, hy, [&](const Problem& problem) {
        StandInHost host(backend);
        for (const Index& domain : domains(problem.system().nx, problem.system().ny, 7)) {
          Operator op(backend, host, problem.system());
          op.bind(domain, problem.zero_mode());
          check_products(problem, op, domain, 1e-13);
        }
        Operator op(backend, host, problem.system());
        op.bind(problem.all(), problem.zero_mode(), true);
        check_products(problem, op, problem.all(), 1e-13);
      });
}

// Smaller, larger, disjoint and repeated domains, in the order in which they come.
void rebinding_equals_a_fresh_operator(const rc_backend& backend) {
  for_each_problem(backend, 31, 14, 1.0, 1.0, [&](const Problem& problem) {
    StandInHost host(backend);
    Operator op(backend, host, problem.system());
    for (unsigned seed : {1u, 2u})
      for (const Index& domain : domains(31, 14, seed)) {
        for (const double other : {0.0, 1.0, 0.0}) op.bind(domain, problem.zero_mode() + other);
        check_products(problem, op, domain, 1e-13);
      }
    // A box that grows by a point at a time, as in a loading sequence.
    for (std::int64_t size = 1; size <= 14; ++size) {
      Index domain;
      for (std::int64_t iy = 0; iy < size; ++iy)
        for (std::int64_t ix = 0; ix < size; ++ix) domain.push_back((7 - size / 2 + iy) * 31 + 15 - size / 2 + ix);
      op.bind(domain, problem.zero_mode());
      check_products(problem, op, domain, 1e-13);
    }
  });
}

void nan_is_not_hidden(const rc_backend& backend) {
  for_each_problem(backend, 6, 5, 1.0, 1.0, [&](const Problem& problem) {
    StandInHost host(backend);
    Operator op(backend, host, problem.system());
    op.bind(problem.all(), problem.zero_mode());
    Vector x(problem.all().size(), 0.0);
    x[13] = std::numeric_limits<double>::quiet_NaN();
    assert_true(std::isnan(op.apply(x)[13]));
    assert_true(std::isnan(op.field(x)[13]));
    x[13] = 1.0;
    assert_false(std::isnan(op.apply(x)[13]));
  });
}

void every_choice_of_an_option_gives_the_same_product(const rc_backend& backend) {
  for (std::int64_t i = 0; i < backend.n_options; ++i) {
    if (!backend.options[i]->choices) continue;
    const std::string key = backend.options[i]->name, choices = backend.options[i]->choices;
    for (std::size_t begin = 0, end = 0; end != std::string::npos; begin = end + 1) {
      end = choices.find('|', begin);
      const std::string choice = choices.substr(begin, end - begin);
      for_each_problem(backend, 21, 10, 1.0, 1.0, [&](const Problem& problem) {
        StandInHost host(backend);
        host.set(key, choice);
        Operator op(backend, host, problem.system());
        op.bind(problem.all(), problem.zero_mode());
        check_products(problem, op, problem.all(), choice == "single" ? 1e-6 : 1e-13);
      });
    }
  }
}

}  // namespace contract

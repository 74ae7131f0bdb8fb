// Products in single precision.
#include <cfenv>
#include <cmath>

#if __has_include(<malloc.h>)
#include <malloc.h>
#endif

#include "cases.h"
#include "fixtures.h"
#include "support/cmocka.hpp"

namespace contract {

namespace {

constexpr double tolerance = 1e-6;  // relative to the largest product that a vector of this size can have

// Values that single precision holds exactly, so that both precisions multiply the same vector.
Vector exact_vector(std::size_t n, unsigned seed, double scale = 1) {
  Vector x = random_vector(n, seed);
  for (double& value : x) value = scale * static_cast<double>(static_cast<float>(value));
  return x;
}

}  // namespace

void float_products_agree_with_double_ones(const rc_backend& backend) {
  constexpr std::int64_t sizes[][2] = {{1, 1},   {1, 12},  {12, 1}, {2, 2},   {5, 7},  {17, 17}, {6, 15}, {31, 8},
                                       {40, 21}, {128, 3}, {72, 2}, {121, 1}, {65, 5}, {3, 128}, {1, 121}};
  for (const auto& [nx, ny] : sizes)
    for_each_problem(backend, nx, ny, 1.0, 0.6, [&](const Problem& problem) {
      StandInHost host(backend);
      Operator op(backend, host, problem.system());
      const double scale = problem.matrix().norm();
      for (const Index& domain : domains(problem.system().nx, problem.system().ny, 4)) {
        op.bind(domain, problem.zero_mode());
        const Vector x = exact_vector(domain.size(), 1);
        const Vector expected = problem.matrix().product(domain, domain, x);
        assert_true(largest_difference(op.apply_float(x), expected) <= tolerance * scale);
        assert_true(largest_difference(op.apply(x), expected) <= 1e-13 * scale);
      }
      op.bind(problem.all(), problem.zero_mode(), true);
      const Vector x = exact_vector(problem.all().size(), 2);
      assert_true(largest_difference(op.apply_float(x), op.apply(x)) <= tolerance * scale);
    });
}

// Powers of two, so that scaling rounds nothing.
void float_products_keep_their_accuracy_at_any_scale(const rc_backend& backend) {
  for_each_problem(backend, 24, 30, 1.0, 1.0, [&](const Problem& problem) {
    StandInHost host(backend);
    Operator op(backend, host, problem.system());
    op.bind(problem.all(), problem.zero_mode());
    const double norm = problem.matrix().norm();
    for (const double scale : {std::ldexp(1.0, 80), std::ldexp(1.0, -80)}) {
      const Vector x = exact_vector(problem.all().size(), 3, scale);
      assert_true(largest_difference(op.apply_float(x), op.apply(x)) <= tolerance * scale * norm);
    }
  });
}

// Arrays and eigenvalues that the two share must not depend on which product was asked for first, nor on what came between.
void either_precision_may_come_first(const rc_backend& backend) {
  for_each_problem(backend, 20, 33, 1.0, 1.0, [&](const Problem& problem) {
    StandInHost host(backend);
    for (const Index& domain : domains(20, 33, 6)) {
      const Vector x = exact_vector(domain.size(), 4);
      Operator first(backend, host, problem.system()), second(backend, host, problem.system());
      first.bind(domain, problem.zero_mode());
      second.bind(domain, problem.zero_mode());
      const Vector in_float = first.apply_float(x), in_double = first.apply(x);
      assert_true(second.apply(x) == in_double);
      assert_true(second.apply_float(x) == in_float);
      second.field(x);
      assert_true(second.apply_float(x) == in_float);
      assert_true(second.apply(x) == in_double);
      assert_true(first.apply_float(x) == in_float);
    }
  });
}

// Fresh memory is filled with numbers whose products overflow.
void products_leave_alone_what_memory_holds_by_chance(const rc_backend& backend) {
#ifdef M_PERTURB
  for_each_problem(backend, 20, 33, 1.0, 1.0, [&](const Problem& problem) {
    mallopt(M_PERTURB, 0x80);
    StandInHost host(backend);
    Operator op(backend, host, problem.system());
    op.bind(problem.all(), problem.zero_mode());
    const Vector x = exact_vector(problem.all().size(), 5, 4096);
    op.apply(x);
    std::feclearexcept(FE_ALL_EXCEPT);
    op.apply_float(x);
    const int raised = std::fetestexcept(FE_OVERFLOW | FE_INVALID);
    mallopt(M_PERTURB, 0);
    assert_int_equal(raised, 0);
  });
#else
  (void)backend;
#endif
}

}  // namespace contract

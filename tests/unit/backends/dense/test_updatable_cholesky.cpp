// The factor and the tiled matrix against Eigen.
#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

#include "common/symmetric_matrix.h"
#include "support/cmocka.hpp"
#include "updatable_cholesky.h"

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Positions = std::vector<std::int64_t>;
using rc_common::SymmetricMatrix;
using rc_dense::ColumnSource;
using rc_dense::UpdatableCholesky;

VectorXd random_vector(Index n, unsigned seed) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  return VectorXd::NullaryExpr(n, [&] { return uniform(engine); });
}

MatrixXd random_symmetric(Index n, unsigned seed) {
  const VectorXd numbers = random_vector(n * n, seed);
  const MatrixXd M = Eigen::Map<const MatrixXd>(numbers.data(), n, n);
  return 0.5 * (M + M.transpose());
}

// Symmetric with eigenvalues around n, far from zero.
MatrixXd random_definite(Index n, unsigned seed) {
  return random_symmetric(n, seed) + static_cast<double>(n) * MatrixXd::Identity(n, n);
}

// Entries of A[order, order].
ColumnSource entries(const MatrixXd& A, const Positions& order) {
  return [&A, &order](std::int64_t first_row, std::int64_t rows, std::int64_t column, double* out) {
    for (std::int64_t k = 0; k < rows; ++k)
      out[k] = A(order[static_cast<std::size_t>(first_row + k)], order[static_cast<std::size_t>(column)]);
  };
}

Positions first_positions(Index n) {
  Positions order(static_cast<std::size_t>(n));
  std::iota(order.begin(), order.end(), 0);
  return order;
}

void assert_solves(const UpdatableCholesky& factor, const MatrixXd& A, const Positions& order) {
  assert_int_equal(factor.size(), order.size());
  const MatrixXd sub = A(order, order);
  const VectorXd b = random_vector(sub.rows(), 7), expected = sub.llt().solve(b);
  VectorXd x = b;
  factor.solve(x.data());
  assert_true((x - expected).cwiseAbs().maxCoeff() <= 1e-12 * expected.cwiseAbs().maxCoeff());
}

void append(UpdatableCholesky& factor, const MatrixXd& A, Positions& order, const Positions& added) {
  order.insert(order.end(), added.begin(), added.end());
  assert_false(factor.append(static_cast<std::int64_t>(added.size()), entries(A, order)).has_value());
}

void remove(UpdatableCholesky& factor, Positions& order, const Positions& removed) {
  factor.remove(removed);
  for (auto i = removed.rbegin(); i != removed.rend(); ++i) order.erase(order.begin() + *i);
}

void factorization_in_blocks_solves(void**) {
  for (const Index n : {1, 2, 95, 96, 97, 250, 400}) {
    const MatrixXd A = random_definite(n, 1);
    UpdatableCholesky factor;
    Positions order;
    append(factor, A, order, first_positions(n));
    assert_solves(factor, A, order);
  }
}

void removal_of_any_position_solves(void**) {
  const MatrixXd A = random_definite(130, 2);
  Positions all_but_one = first_positions(130);
  all_but_one.erase(all_but_one.begin() + 60);
  for (const Positions& removed :
       {Positions{0}, {129}, {64}, {0, 129}, {0, 1, 2}, {127, 128, 129}, {3, 50, 51, 90}, all_but_one}) {
    UpdatableCholesky factor;
    Positions order;
    append(factor, A, order, first_positions(130));
    remove(factor, order, removed);
    assert_solves(factor, A, order);
  }
}

void removal_of_everything_leaves_an_empty_factor(void**) {
  const MatrixXd A = random_definite(40, 3);
  UpdatableCholesky factor;
  Positions order;
  append(factor, A, order, first_positions(40));
  remove(factor, order, first_positions(40));
  assert_int_equal(factor.size(), 0);
  append(factor, A, order, {5, 3, 1});
  assert_solves(factor, A, order);
}

// Panels hold 128 rows, a batch of removed unknowns at least 16.
void removals_cross_panels(void**) {
  const MatrixXd A = random_definite(400, 11);
  for (const Positions& removed :
       {Positions{0, 127, 128, 255, 256, 399}, {126, 127, 128, 129}, {384, 385}, first_positions(272)}) {
    UpdatableCholesky factor;
    Positions order;
    append(factor, A, order, first_positions(400));
    remove(factor, order, removed);
    assert_solves(factor, A, order);
    append(factor, A, order, removed);
    assert_solves(factor, A, order);
  }
}

void growth_keeps_the_factor(void**) {
  const MatrixXd A = random_definite(200, 4);
  UpdatableCholesky factor;
  Positions order;
  for (const Index count : {1, 1, 2, 4, 5, 30, 100}) {
    Positions added = first_positions(count);
    for (auto& position : added) position += static_cast<std::int64_t>(order.size());
    append(factor, A, order, added);
    assert_solves(factor, A, order);
  }
}

void random_sequences_equal_a_fresh_factorization(void**) {
  constexpr Index n = 150;
  const MatrixXd A = random_definite(n, 5);
  std::mt19937 engine(6);
  const auto below = [&](std::size_t limit) { return static_cast<std::size_t>(engine() % limit); };
  UpdatableCholesky factor;
  Positions order;
  for (int step = 0; step < 400; ++step) {
    Positions outside;
    for (std::int64_t i = 0; i < n; ++i)
      if (std::find(order.begin(), order.end(), i) == order.end()) outside.push_back(i);
    std::shuffle(outside.begin(), outside.end(), engine);
    if (order.empty() || (!outside.empty() && engine() % 2 == 0)) {
      outside.resize(1 + below(std::min<std::size_t>(outside.size(), 12)));
      append(factor, A, order, outside);
    } else if (engine() % 8 == 0) {
      order.resize(below(order.size()));
      factor.truncate(static_cast<std::int64_t>(order.size()));
    } else {
      Positions removed = first_positions(static_cast<Index>(order.size()));
      std::shuffle(removed.begin(), removed.end(), engine);
      removed.resize(1 + below(std::min<std::size_t>(removed.size(), 9)));
      std::sort(removed.begin(), removed.end());
      remove(factor, order, removed);
    }
    if (!order.empty()) assert_solves(factor, A, order);
  }
}

void a_pivot_that_is_not_positive_is_reported(void**) {
  MatrixXd A = MatrixXd::Identity(120, 120);
  A(110, 110) = -0.5;
  UpdatableCholesky factor;
  Positions order;
  append(factor, A, order, first_positions(50));
  const Positions all = first_positions(120);
  const auto bad = factor.append(70, entries(A, all));
  assert_true(bad.has_value());
  assert_int_equal(bad->unknown, 110);
  assert_true(bad->value == -0.5);
  assert_solves(factor, A, order);
}

void singular_and_nan_matrices_are_rejected(void**) {
  const Positions all = first_positions(100);
  const MatrixXd ones = MatrixXd::Ones(100, 100);
  const MatrixXd projector = MatrixXd::Identity(100, 100) - ones / 100.0;
  MatrixXd nan = MatrixXd::Identity(100, 100);
  nan(40, 40) = std::numeric_limits<double>::quiet_NaN();
  for (const MatrixXd* A : {&ones, &projector, static_cast<const MatrixXd*>(&nan)}) {
    UpdatableCholesky factor;
    assert_true(factor.append(100, entries(*A, all)).has_value());
    assert_int_equal(factor.size(), 0);
  }
}

void rotations_are_chosen_by_counts(void**) {
  assert_true(rc_dense::rotations_pay(2000, Positions{0}, 0));
  assert_true(rc_dense::rotations_pay(2000, Positions{10, 500, 900}, 5));
  assert_false(rc_dense::rotations_pay(2000, first_positions(1500), 0));
  assert_false(rc_dense::rotations_pay(2000, Positions{1999}, 0));  // cutting off the last one costs nothing
}

void tiled_product_equals_eigens(void**) {
  for (const Index n : {1, 2, 255, 256, 257, 512, 700}) {
    const MatrixXd A = random_symmetric(n, 8);
    const SymmetricMatrix tiled(n, entries(A, first_positions(n)));
    std::vector<VectorXd> vectors = {random_vector(n, 9), VectorXd::Zero(n), VectorXd::Unit(n, n - 1), random_vector(n, 10)};
    vectors.back().head(n / 2).setZero();
    for (const VectorXd& x : vectors) {
      VectorXd y = VectorXd::Constant(n, std::numeric_limits<double>::quiet_NaN());
      tiled.multiply(x.data(), y.data());
      assert_true((y - A * x).cwiseAbs().maxCoeff() <= 1e-13 * static_cast<double>(n));
    }
  }
}

void tiles_take_half_of_the_matrix(void**) {
  assert_true(SymmetricMatrix::bytes(1) == 8.0);
  assert_true(SymmetricMatrix::bytes(256) == 8.0 * 256 * 256);
  assert_true(SymmetricMatrix::bytes(300) == 8.0 * (256 * 256 + 44 * 300));
  assert_true(SymmetricMatrix::bytes(1e8) < 4.0001e16);
}

void panels_take_half_of_a_square(void**) {
  assert_true(UpdatableCholesky::bytes(0) == 0.0);
  assert_true(UpdatableCholesky::bytes(1) == 8.0 * 128 * 128);
  assert_true(UpdatableCholesky::bytes(129) == 8.0 * 3 * 128 * 128);
  assert_true(UpdatableCholesky::bytes(20000) < 1.01 * 8 * 20000 * 10000 + 1.3e7);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(factorization_in_blocks_solves),
      cmocka_unit_test(removal_of_any_position_solves),
      cmocka_unit_test(removal_of_everything_leaves_an_empty_factor),
      cmocka_unit_test(removals_cross_panels),
      cmocka_unit_test(growth_keeps_the_factor),
      cmocka_unit_test(random_sequences_equal_a_fresh_factorization),
      cmocka_unit_test(a_pivot_that_is_not_positive_is_reported),
      cmocka_unit_test(singular_and_nan_matrices_are_rejected),
      cmocka_unit_test(rotations_are_chosen_by_counts),
      cmocka_unit_test(tiled_product_equals_eigens),
      cmocka_unit_test(tiles_take_half_of_the_matrix),
      cmocka_unit_test(panels_take_half_of_a_square),
  };
  return cmocka_run_group_tests_name("dense", tests, nullptr, nullptr);
}

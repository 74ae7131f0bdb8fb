// The backend through its function table, against matrices written out entry by entry.
#include <Eigen/Cholesky>
#include <algorithm>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "stand_in_host.h"
#include "support/cmocka.hpp"

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Indices = std::vector<std::int64_t>;

VectorXd random_vector(Index n, unsigned seed) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  return VectorXd::NullaryExpr(n, [&] { return uniform(engine); });
}

Indices range(std::int64_t n) {
  Indices index(static_cast<std::size_t>(n));
  std::iota(index.begin(), index.end(), 0);
  return index;
}

Indices picked(std::int64_t n, std::size_t count, unsigned seed) {
  Indices index = range(n);
  std::shuffle(index.begin(), index.end(), std::mt19937(seed));
  index.resize(count);
  std::sort(index.begin(), index.end());
  return index;
}

void assert_close(const VectorXd& actual, const VectorXd& expected, double tolerance) {
  assert_int_equal(actual.size(), expected.size());
  assert_true((actual - expected).cwiseAbs().maxCoeff() <= tolerance * expected.cwiseAbs().maxCoeff());
}

void assert_message_has(const char* part) {
  const std::string& message = stand_in::state().message;
  const bool found = message.find(part) != std::string::npos;
  if (!found) print_error("no \"%s\" in: %s\n", part, message.c_str());
  assert_true(found);
}

// Residual of a subset solve relative to |H| |x|.
void assert_solved(const MatrixXd& H, const Indices& a, const VectorXd& b, const VectorXd& x) {
  const MatrixXd Haa = H(a, a);
  const double scale = (Haa.cwiseAbs() * x.cwiseAbs()).maxCoeff();
  assert_true((Haa * x - b).cwiseAbs().maxCoeff() <= 1e-13 * scale);
}

// Products, fields and one solve on the domain T, against H over the whole grid.
void assert_agrees(stand_in::Operator& op, const MatrixXd& H, const Indices& T) {
  const auto n = static_cast<Index>(T.size());
  VectorXd x = random_vector(n, 1), y;
  x.head(n / 3).setZero();
  assert_int_equal(op.apply(x, y), RC_OK);
  assert_close(y, H(T, T) * x, 1e-13);
  assert_int_equal(op.field(x, y), RC_OK);
  assert_close(y, H(Eigen::all, T) * x, 1e-13);
  assert_int_equal(op.modelled(), n);

  const Indices positions = picked(n, static_cast<std::size_t>(n) / 2 + 1, 2);
  Indices a;
  for (const auto i : positions) a.push_back(T[static_cast<std::size_t>(i)]);
  const VectorXd b = random_vector(static_cast<Index>(a.size()), 3);
  assert_int_equal(op.subset(positions, b, x), RC_OK);
  assert_solved(H, a, b, x);
}

void callers_matrix_with_a_row_stride(void**) {
  constexpr Index n = 60, ld = 67;
  MatrixXd storage = MatrixXd::Constant(ld, n, std::nan(""));
  const MatrixXd M = Eigen::Map<const MatrixXd>(random_vector(n * n, 6).eval().data(), n, n);
  storage.topRows(n) = M * M.transpose() + MatrixXd::Identity(n, n);
  stand_in::Operator op(stand_in::dense(storage.data(), n, ld));
  const MatrixXd H = op.matrix();
  assert_int_equal(op.bind_all(), RC_OK);
  assert_agrees(op, H, range(n));
  const Indices some = picked(n, 33, 7);
  assert_int_equal(op.bind(some), RC_OK);
  assert_agrees(op, H, some);
}

void coefficients_are_fetched_late_and_for_the_bounding_box(void**) {
  stand_in::Operator op(stand_in::half_space(200, 100));         // of a small grid all are fetched at once
  const Indices box = {5 * 200 + 7, 5 * 200 + 12, 8 * 200 + 9};  // 6 x 4 cells
  assert_int_equal(op.bind(box), RC_OK);
  assert_int_equal(stand_in::state().requests, 0);
  VectorXd y;
  assert_int_equal(op.apply(VectorXd::Ones(3), y), RC_OK);
  assert_int_equal(stand_in::state().mx, 6);
  assert_int_equal(stand_in::state().my, 4);
  assert_int_equal(op.bind({0, 3}), RC_OK);  // fits in the table
  assert_int_equal(op.apply(VectorXd::Ones(2), y), RC_OK);
  assert_int_equal(stand_in::state().requests, 1);
  assert_int_equal(op.field(VectorXd::Ones(2), y), RC_OK);
  assert_int_equal(stand_in::state().mx, 200);
  assert_int_equal(stand_in::state().my, 100);
}

// The caller's matrix is scaled behind the operator's back: what follows it was computed anew, what does not was kept.
void a_change_of_domain_keeps_the_factor_of_the_same_points(void**) {
  constexpr Index n = 20;
  MatrixXd H = MatrixXd::Identity(n, n);
  stand_in::Operator op(stand_in::dense(H.data(), n, n));
  VectorXd x;
  const auto solution = [&](const Indices& positions) {
    assert_int_equal(op.subset(positions, VectorXd::Ones(static_cast<Index>(positions.size())), x), RC_OK);
    return x.maxCoeff();
  };
  op.bind_all();
  assert_true(solution({4, 9, 15}) == 1.0);
  H *= 0.25;
  op.bind({2, 4, 9, 11, 15});
  assert_true(solution({1, 2, 4}) == 1.0);
  assert_true(solution({1, 2, 3, 4}) == 4.0);
  op.bind({2, 4, 9, 11, 15}, 1.0);
  assert_true(solution({1, 2, 4}) == 4.0);
}

void binding_the_same_domain_keeps_the_matrix(void**) {
  constexpr Index n = 20;
  MatrixXd H = MatrixXd::Identity(n, n);
  stand_in::Operator op(stand_in::dense(H.data(), n, n));
  VectorXd y;
  op.bind(range(n));
  assert_int_equal(op.apply(VectorXd::Ones(n), y), RC_OK);
  H *= 0.25;
  op.bind_all();
  assert_int_equal(op.apply(VectorXd::Ones(n), y), RC_OK);
  assert_true(y(0) == 1.0);
  op.bind({0, 1});
  assert_int_equal(op.apply(VectorXd::Ones(2), y), RC_OK);
  assert_true(y(0) == 0.25);
}

void memory_limit_is_kept_and_explained(void**) {
  stand_in::Operator op(stand_in::half_space(60, 40), 1.0);
  assert_int_equal(op.bind_all(), RC_ERR_MEMORY);
  assert_message_has("dense: the matrix of 2400 unknowns needs 25436160 bytes, the ");
  assert_message_has("limit dense.memory_limit is 1 MiB; raise it or use a backend that stores no matrix (\"fft\")");
  assert_int_equal(op.bind(range(300)), RC_OK);
  VectorXd y;
  assert_int_equal(op.subset(range(300), VectorXd::Ones(300), y), RC_OK);  // 786432 bytes
  assert_int_equal(op.apply(VectorXd::Ones(300), y), RC_OK);               // 630 kB more would be too many: from the entries
  assert_close(y, op.matrix()(range(300), range(300)) * VectorXd::Ones(300), 1e-13);
}

// Its products need no memory; only its factor may be too large, and no other backend has a smaller one.
void memory_limit_with_a_callers_matrix(void**) {
  constexpr Index n = 600;
  MatrixXd H = MatrixXd::Constant(n, n, 0.5) + MatrixXd::Identity(n, n);
  stand_in::Operator op(stand_in::dense(H.data(), n, n), 1.0);
  assert_int_equal(op.bind_all(), RC_OK);
  VectorXd y;
  assert_int_equal(op.apply(VectorXd::Ones(n), y), RC_OK);
  assert_close(y, H * VectorXd::Ones(n), 1e-13);
  assert_int_equal(op.subset(range(n), VectorXd::Ones(n), y), RC_ERR_MEMORY);
  assert_message_has("the Cholesky factor of 600 unknowns needs 1966080 bytes");
  assert_message_has("raise it or use a solver that only multiplies");
  assert_int_equal(op.shifted(0.1, VectorXd::Ones(n), y), RC_ERR_MEMORY);
  assert_int_equal(op.subset(range(300), VectorXd::Ones(300), y), RC_OK);
}

// Matrix and both factors in turn, where only one of them fits at a time.
void results_are_the_same_without_room_for_everything(void**) {
  VectorXd products[2], solutions[2], shifted[2];
  int i = 0;
  for (const double limit : {8192.0, 1.0}) {
    stand_in::Operator op(stand_in::half_space(20, 18), limit);
    assert_int_equal(op.bind_all(), RC_OK);
    const VectorXd b = random_vector(360, 12);
    for (int repeat = 0; repeat < 3; ++repeat) {
      assert_int_equal(op.apply(b, products[i]), RC_OK);
      assert_int_equal(op.shifted(0.2, b, shifted[i]), RC_OK);
      assert_int_equal(op.subset(picked(360, 350, 13), b.head(350), solutions[i]), RC_OK);
    }
    ++i;
  }
  assert_close(products[1], products[0], 1e-13);
  assert_close(solutions[1], solutions[0], 1e-11);
  assert_close(shifted[1], shifted[0], 1e-11);
}

// Were the caller's matrix factored again, what it has become in between would show.
void the_shifted_factor_stays_as_long_as_set_and_shift(void**) {
  constexpr Index n = 20;
  MatrixXd H = MatrixXd::Identity(n, n);
  stand_in::Operator op(stand_in::dense(H.data(), n, n));
  op.bind(range(n));
  VectorXd x;
  assert_int_equal(op.shifted(3.0, VectorXd::Ones(n), x), RC_OK);
  assert_true(x(0) == 0.25);
  H *= 10.0;
  op.bind_all();
  assert_int_equal(op.subset(range(5), VectorXd::Ones(5), x), RC_OK);
  assert_int_equal(op.shifted(3.0, VectorXd::Ones(n), x), RC_OK);
  assert_true(x(0) == 0.25);
  assert_int_equal(op.shifted(6.0, VectorXd::Ones(n), x), RC_OK);
  assert_true(x(0) == 0.0625);
  op.bind({3, 4});
  assert_int_equal(op.shifted(54.0, VectorXd::Ones(2), x), RC_OK);
  assert_true(x(0) == 0.015625);
}

void too_little_shift_for_an_indefinite_matrix_is_reported(void**) {
  constexpr Index n = 30;
  MatrixXd H = MatrixXd::Identity(n, n);
  H(17, 17) = -0.25;
  stand_in::Operator op(stand_in::dense(H.data(), n, n));
  op.bind_all();
  VectorXd x;
  assert_int_equal(op.shifted(0.125, VectorXd::Ones(n), x), RC_ERR_NUMERIC);
  assert_message_has("the matrix plus 0.125 times the identity is not positive definite: pivot 18 of 30 is -0.125");
  assert_int_equal(op.shifted(0.5, VectorXd::Ones(n), x), RC_OK);
  assert_true(x(17) == 4.0);
}

void indefinite_matrix_is_reported_and_the_factor_dropped(void**) {
  constexpr Index n = 30;
  MatrixXd H = MatrixXd::Identity(n, n);
  H(17, 17) = -0.25;
  stand_in::Operator op(stand_in::dense(H.data(), n, n));
  op.bind_all();
  VectorXd x;
  assert_int_equal(op.subset(range(15), VectorXd::Ones(15), x), RC_OK);
  assert_int_equal(op.subset(range(n), VectorXd::Ones(n), x), RC_ERR_NUMERIC);
  assert_message_has("dense: the matrix is not positive definite: pivot 18 of 30 is -0.25; ");
  H *= 0.25;
  assert_int_equal(op.subset(range(15), VectorXd::Ones(15), x), RC_OK);
  assert_true(x(0) == 4.0);
}

void periodic_grid_without_zero_mode_is_singular_as_a_whole(void**) {
  stand_in::Operator op(stand_in::half_space(12, 7, RC_BOUNDARY_PERIODIC));
  op.bind_all();
  VectorXd x;
  assert_int_equal(op.subset(range(84), VectorXd::Ones(84), x), RC_ERR_NUMERIC);
  assert_int_equal(op.subset(range(80), VectorXd::Ones(80), x), RC_OK);
  assert_solved(op.matrix(), range(80), VectorXd::Ones(80), x);
}

void failures_of_the_host_pass_through(void**) {
  stand_in::Operator op(stand_in::half_space(5, 5));
  stand_in::state().coefficients_fail = true;
  op.bind_all();
  VectorXd y;
  assert_int_equal(op.apply(VectorXd::Ones(25), y), RC_ERR_INTERNAL);
  assert_message_has("no coefficients here");
  stand_in::state().coefficients_fail = false;
  assert_int_equal(op.apply(VectorXd::Ones(25), y), RC_OK);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(callers_matrix_with_a_row_stride),
      cmocka_unit_test(coefficients_are_fetched_late_and_for_the_bounding_box),
      cmocka_unit_test(a_change_of_domain_keeps_the_factor_of_the_same_points),
      cmocka_unit_test(binding_the_same_domain_keeps_the_matrix),
      cmocka_unit_test(memory_limit_is_kept_and_explained),
      cmocka_unit_test(memory_limit_with_a_callers_matrix),
      cmocka_unit_test(results_are_the_same_without_room_for_everything),
      cmocka_unit_test(the_shifted_factor_stays_as_long_as_set_and_shift),
      cmocka_unit_test(too_little_shift_for_an_indefinite_matrix_is_reported),
      cmocka_unit_test(indefinite_matrix_is_reported_and_the_factor_dropped),
      cmocka_unit_test(periodic_grid_without_zero_mode_is_singular_as_a_whole),
      cmocka_unit_test(failures_of_the_host_pass_through),
  };
  return cmocka_run_group_tests_name("dense_backend", tests, nullptr, nullptr);
}

#include "inverse_m.h"

#include <roughcontact/registry.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace failures {

namespace {

// Influence coefficients of side x side cells with centres `spacing` cells apart, for contact modulus 1.
Eigen::MatrixXd influence(const std::string& kernel, std::int64_t side, std::int64_t spacing) {
  const std::int64_t width = spacing * (side - 1) + 1, n = side * side;
  std::vector<double> table(static_cast<std::size_t>(width * width));
  if (rc_kernel_coefficients(kernel.c_str(), 1, 1, width, width, table.data()) != RC_OK)
    throw std::runtime_error(rc_last_error());
  Eigen::MatrixXd H(n, n);
  for (std::int64_t j = 0; j < n; ++j)
    for (std::int64_t i = 0; i < n; ++i) {
      const std::int64_t dx = spacing * std::abs(i % side - j % side), dy = spacing * std::abs(i / side - j / side);
      H(i, j) = table[static_cast<std::size_t>(dy * width + dx)];
    }
  return H;
}

Eigen::MatrixXd inverse_of(const Eigen::MatrixXd& H) { return H.llt().solve(Eigen::MatrixXd::Identity(H.rows(), H.cols())); }

struct Coupling {
  double value = -std::numeric_limits<double>::infinity();
  Eigen::Index j = 0, k = 0;
};

Coupling largest(const Eigen::MatrixXd& inverse) {
  Coupling found;
  for (Eigen::Index k = 0; k < inverse.cols(); ++k)
    for (Eigen::Index j = 0; j < inverse.rows(); ++j)
      if (j != k && inverse(j, k) > found.value) found = {inverse(j, k), j, k};
  return found;
}

}  // namespace

double largest_inverse_coupling(const std::string& kernel, std::int64_t side, std::int64_t spacing) {
  const Eigen::MatrixXd inverse = inverse_of(influence(kernel, side, spacing));
  return largest(inverse).value / inverse.diagonal().minCoeff();
}

std::vector<double> greedy_counterexample(const std::string& kernel, std::int64_t side) {
  constexpr double large = 10;
  const Eigen::MatrixXd H = influence(kernel, side, 1), inverse = inverse_of(H);
  const Coupling found = largest(inverse);
  if (found.value <= 0) return {};
  Eigen::VectorXd q = Eigen::VectorXd::Constant(H.rows(), large);
  q(found.k) = -1;
  q(found.j) = -found.value / (2 * inverse(found.k, found.k));
  const Eigen::VectorXd u = H * q;
  return {u.begin(), u.end()};
}

}  // namespace failures

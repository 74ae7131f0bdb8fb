// The Cholesky factor of a small matrix.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace rc {

class Cholesky {
 public:
  // L L' = the n x n matrix of these entries, row by row; only those at and below the diagonal are read.
  template <class Entry> Cholesky(std::size_t n, const Entry& entry) : n_(n), l_(n * n, 0.0) {
    for (std::size_t i = 0; i < n_ && positive_; ++i) {
      double* row = &l_[i * n_];
      for (std::size_t j = 0; j < i; ++j) row[j] = (entry(i, j) - dot(row, &l_[j * n_], j)) / l_[j * n_ + j];
      const double pivot = entry(i, i) - dot(row, row, i);
      positive_ = pivot > 0;
      row[i] = std::sqrt(pivot);
    }
  }

  bool positive() const { return positive_; }

  void solve_lower(std::vector<double>& x) const {
    for (std::size_t i = 0; i < n_; ++i) x[i] = (x[i] - dot(&l_[i * n_], x.data(), i)) / l_[i * n_ + i];
  }
  void solve(std::vector<double>& x) const {
    solve_lower(x);
    for (std::size_t i = n_; i-- > 0;) {
      x[i] /= l_[i * n_ + i];
      for (std::size_t j = 0; j < i; ++j) x[j] -= l_[i * n_ + j] * x[i];
    }
  }

  static double dot(const double* a, const double* b, std::size_t n) {
    double sum[4] = {0, 0, 0, 0};
    std::size_t i = 0;
    for (; i + 4 <= n; i += 4)
      for (std::size_t k = 0; k < 4; ++k) sum[k] += a[i + k] * b[i + k];
    for (; i < n; ++i) sum[0] += a[i] * b[i];
    return (sum[0] + sum[1]) + (sum[2] + sum[3]);
  }

 private:
  std::size_t n_;
  std::vector<double> l_;
  bool positive_ = true;
};

}  // namespace rc

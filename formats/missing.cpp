#include "formats/missing.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <string>

#include "formats/error.h"

namespace rc::formats {

namespace {

// Most points that are filled: the factor of so many unknowns takes some gigabytes.
constexpr std::size_t most_filled = std::size_t{1} << 23;

}  // namespace

std::int64_t count_missing(const Surface& surface) {
  return std::ranges::count_if(surface.heights, [](double z) { return std::isnan(z); });
}

void fill_missing(Surface& surface) {
  std::vector<double>& z = surface.heights;
  std::vector<std::size_t> missing;
  std::vector<int> unknown(z.size(), -1);  // its number, of a missing point
  for (std::size_t i = 0; i < z.size(); ++i) {
    if (!std::isnan(z[i])) continue;
    if (missing.size() == most_filled)
      throw Error("more than ", most_filled,
                  " points are missing, too many to interpolate; cut the map to where it was measured");
    unknown[i] = static_cast<int>(missing.size());
    missing.push_back(i);
  }

  // With a ratio beyond these limits, weights would round to zero and neighbouring lines would not be connected.
  const double ratio = std::clamp(*surface.hx / *surface.hy, 1e-4, 1e4);
  const double along_x = 1 / (1 + ratio * ratio), along_y = ratio * ratio / (1 + ratio * ratio);
  const auto nx = static_cast<std::size_t>(surface.nx), ny = static_cast<std::size_t>(surface.ny);
  const auto size = static_cast<Eigen::Index>(missing.size());
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd known = Eigen::VectorXd::Zero(size);
  for (int row = 0; row < static_cast<int>(missing.size()); ++row) {
    const std::size_t i = missing[static_cast<std::size_t>(row)], ix = i % nx, iy = i / nx;
    double sum = 0;
    const auto add = [&](bool there, std::size_t at, double weight) {
      if (!there) return;
      sum += weight;
      if (unknown[at] < 0) {
        known[row] += weight * z[at];
      } else if (unknown[at] < row) {
        entries.emplace_back(row, unknown[at], -weight);  // the lower triangle
      }
    };
    add(ix > 0, i - 1, along_x);
    add(ix + 1 < nx, i + 1, along_x);
    add(iy > 0, i - nx, along_y);
    add(iy + 1 < ny, i + nx, along_y);
    entries.emplace_back(row, row, sum);
  }

  Eigen::SparseMatrix<double> laplacian(size, size);
  laplacian.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(laplacian);
  if (factor.info() != Eigen::Success) throw Error("the missing points cannot be interpolated; fill them first");
  const Eigen::VectorXd filled = factor.solve(known);
  for (std::size_t k = 0; k < missing.size(); ++k) z[missing[k]] = filled[static_cast<Eigen::Index>(k)];
}

}  // namespace rc::formats

#include "formats/missing.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "choices.h"
#include "error.h"
#include "text.h"

namespace cli {

namespace {

// Most points that are filled: the factor of so many unknowns takes some gigabytes.
constexpr std::size_t most_filled = std::size_t{1} << 23;

struct Neighbour {
  std::size_t at;
  double weight;
};

struct Neighbours {
  std::array<Neighbour, 4> list;
  std::size_t count = 0;

  void add(std::size_t at, double weight) { list[count++] = {at, weight}; }
  const Neighbour* begin() const { return list.data(); }
  const Neighbour* end() const { return list.data() + count; }
};

class Grid {
 public:
  explicit Grid(const Surface& surface) : nx_(static_cast<std::size_t>(surface.nx)), ny_(static_cast<std::size_t>(surface.ny)) {
    // With a ratio beyond these limits, weights would round to zero and neighbouring lines would not be connected.
    const double ratio = std::clamp(*surface.hx / *surface.hy, 1e-4, 1e4);
    weight_x_ = 1 / (1 + ratio * ratio);
    weight_y_ = ratio * ratio / (1 + ratio * ratio);
  }

  Neighbours of(std::size_t i) const {
    Neighbours found;
    const std::size_t ix = i % nx_, iy = i / nx_;
    if (ix > 0) found.add(i - 1, weight_x_);
    if (ix + 1 < nx_) found.add(i + 1, weight_x_);
    if (iy > 0) found.add(i - nx_, weight_y_);
    if (iy + 1 < ny_) found.add(i + nx_, weight_y_);
    return found;
  }

 private:
  std::size_t nx_, ny_;
  double weight_x_, weight_y_;
};

}  // namespace

MissingRule parse_missing_rule(std::string_view name) {
  return static_cast<MissingRule>(choice("--missing", name, missing_rule_names));
}

std::int64_t count_missing(const Surface& surface) {
  return std::ranges::count_if(surface.heights, [](double z) { return std::isnan(z); });
}

void reject_missing(const Surface& surface, std::int64_t count, bool can_exclude) {
  const auto first = std::ranges::find_if(surface.heights, [](double z) { return std::isnan(z); }) - surface.heights.begin();
  throw Error(format("%lld missing value%s of %zu, first at ix=%lld, iy=%lld; give --missing fill to interpolate%s",
                     static_cast<long long>(count), count == 1 ? "" : "s", surface.heights.size(),
                     static_cast<long long>(first % surface.nx), static_cast<long long>(first / surface.nx),
                     can_exclude ? " or --missing exclude to keep them out of contact" : ""));
}

void fill_missing(Surface& surface) {
  std::vector<double>& z = surface.heights;
  std::vector<std::size_t> missing;
  std::vector<int> unknown(z.size(), -1);  // its number, of a missing point
  for (std::size_t i = 0; i < z.size(); ++i) {
    if (!std::isnan(z[i])) continue;
    if (missing.size() == most_filled)
      throw Error("more than " + std::to_string(most_filled) +
                  " points are missing, too many to interpolate; cut the map to where it was measured");
    unknown[i] = static_cast<int>(missing.size());
    missing.push_back(i);
  }

  const Grid grid{surface};
  const auto size = static_cast<Eigen::Index>(missing.size());
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd known = Eigen::VectorXd::Zero(size);
  for (int row = 0; row < static_cast<int>(missing.size()); ++row) {
    double sum = 0;
    for (const auto& [at, weight] : grid.of(missing[static_cast<std::size_t>(row)])) {
      sum += weight;
      if (unknown[at] < 0) {
        known[row] += weight * z[at];
      } else if (unknown[at] < row) {
        entries.emplace_back(row, unknown[at], -weight);  // the lower triangle
      }
    }
    entries.emplace_back(row, row, sum);
  }

  Eigen::SparseMatrix<double> laplacian(size, size);
  laplacian.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(laplacian);
  if (factor.info() != Eigen::Success) throw Error("the missing points cannot be interpolated; fill them first");
  const Eigen::VectorXd filled = factor.solve(known);
  for (std::size_t k = 0; k < missing.size(); ++k) z[missing[k]] = filled[static_cast<Eigen::Index>(k)];
}

}  // namespace cli

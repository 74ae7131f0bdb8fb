#include "grid/downsample.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace rc {

namespace {

constexpr double none = std::numeric_limits<double>::infinity();

// Collects the values of one block, in the order in which they come.
class Block {
 public:
  explicit Block(Filter filter) : filter_(filter) {}

  void add(double gap) {
    if (count_ == 0) {
      value_ = gap;
    } else if (filter_ == Filter::mean) {
      value_ += gap;
    } else if (filter_ == Filter::max) {
      value_ = std::min(value_, gap);
    }
    ++count_;
  }

  bool empty() const { return count_ == 0; }
  double value() const {
    if (empty()) return none;
    return filter_ == Filter::mean ? value_ / count_ : value_;
  }

 private:
  Filter filter_;
  int count_ = 0;
  double value_ = none;
};

// The means of whole blocks without masked points.
template <class Real> void mean_of_blocks(const Real* upper, const Real* lower, std::int64_t count, double* out) {
  const auto value = [](Real of) { return static_cast<double>(of); };
  for (std::int64_t i = 0; i < count; ++i)
    out[i] = (((value(upper[2 * i]) + value(upper[2 * i + 1])) + value(lower[2 * i])) + value(lower[2 * i + 1])) / 4;
}

}  // namespace

CoarseGrid downsample(std::int64_t nx, std::int64_t ny, const GapValues& gap, std::span<const std::uint8_t> mask, Filter filter,
                      const EachRow& each_row) {
  CoarseGrid coarse{(nx + 1) / 2, (ny + 1) / 2, {}, {}};
  const auto points = static_cast<std::size_t>(coarse.nx * coarse.ny);
  coarse.gap.resize(points);
  if (!mask.empty()) coarse.mask.resize(points);

  const auto take_row = [&](std::int64_t cy) {
    double* const out = coarse.gap.data() + cy * coarse.nx;
    std::int64_t cx = 0;
    if (filter == Filter::mean && mask.empty() && 2 * cy + 1 < ny) {
      gap.visit([&](const auto* values) { mean_of_blocks(values + 2 * cy * nx, values + (2 * cy + 1) * nx, nx / 2, out); });
      cx = nx / 2;
    }
    for (; cx < coarse.nx; ++cx) {
      Block block{filter};
      for (std::int64_t iy = 2 * cy; iy < std::min(2 * cy + 2, ny); ++iy) {
        for (std::int64_t ix = 2 * cx; ix < std::min(2 * cx + 2, nx); ++ix) {
          const auto i = static_cast<std::size_t>(iy * nx + ix);
          if (mask.empty() || mask[i] != 0) block.add(gap[i]);
        }
      }
      out[cx] = block.value();
      if (!mask.empty()) coarse.mask[static_cast<std::size_t>(cy * coarse.nx + cx)] = block.empty() ? 0 : 1;
    }
  };
  if (each_row) {
    each_row(coarse.ny, take_row);
  } else {
    for (std::int64_t cy = 0; cy < coarse.ny; ++cy) take_row(cy);
  }
  return coarse;
}

CoarseGrid downsample(std::int64_t nx, std::int64_t ny, const GapValues& gap, std::span<const std::uint8_t> mask, int halvings,
                      const EachRow& each_row) {
  if (halvings == 1) return downsample(nx, ny, gap, mask, Filter::mean, each_row);
  const std::int64_t factor = std::int64_t{1} << halvings;
  CoarseGrid coarse{(nx + factor - 1) / factor, (ny + factor - 1) / factor, {}, {}};
  const auto points = static_cast<std::size_t>(coarse.nx * coarse.ny);
  coarse.gap.resize(points);
  if (!mask.empty()) coarse.mask.resize(points);
  each_row(coarse.ny, [&](std::int64_t cy) {
    const std::int64_t rows = std::min(factor, ny - cy * factor);
    const auto first = static_cast<std::size_t>(cy * factor * nx), count = static_cast<std::size_t>(rows * nx);
    CoarseGrid band =
        downsample(nx, rows, gap.part(first, count), mask.empty() ? mask : mask.subspan(first, count), Filter::mean);
    for (int k = 1; k < halvings; ++k) band = downsample(band.nx, band.ny, band.gap, band.mask, Filter::mean);
    std::copy(band.gap.begin(), band.gap.end(), coarse.gap.begin() + cy * coarse.nx);
    std::copy(band.mask.begin(), band.mask.end(), coarse.mask.begin() + (mask.empty() ? 0 : cy * coarse.nx));
  });
  return coarse;
}

}  // namespace rc

#include "formats/despike.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "formats/readers.h"

namespace rc::formats {

namespace {

constexpr std::int64_t reach = 2;  // points to each side

// 0 .. count-1: the point that stands for one beyond an edge.
std::int64_t reflected(std::int64_t i, std::int64_t count) {
  const std::int64_t period = 2 * count;
  const std::int64_t in_period = ((i % period) + period) % period;
  return std::min(in_period, period - 1 - in_period);
}

// Changes the order of the values, of which there is one at least. Of an even number the mean of the middle two.
double median(std::vector<double>& values) {
  const auto middle = values.begin() + std::ssize(values) / 2;
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

}  // namespace

Spikes remove_spikes(double factor, Surface& surface) {
  std::vector<double>& z = surface.heights;
  std::vector<double> off(z.size(), missing_height), around, present;
  for (std::int64_t iy = 0; iy < surface.ny; ++iy)
    for (std::int64_t ix = 0; ix < surface.nx; ++ix) {
      const auto i = static_cast<std::size_t>(iy * surface.nx + ix);
      if (std::isnan(z[i])) continue;
      around.clear();
      for (std::int64_t dy = -reach; dy <= reach; ++dy)
        for (std::int64_t dx = -reach; dx <= reach; ++dx) {
          const double other =
              z[static_cast<std::size_t>(reflected(iy + dy, surface.ny) * surface.nx + reflected(ix + dx, surface.nx))];
          if (!std::isnan(other)) around.push_back(other);
        }
      off[i] = std::abs(z[i] - median(around));
      present.push_back(off[i]);
    }
  Spikes spikes;
  const double typical = present.empty() ? 0 : median(present);
  for (std::size_t i = 0; typical > 0 && i < z.size(); ++i) {
    if (!(off[i] > factor * typical)) continue;
    z[i] = missing_height;
    ++spikes.count;
    spikes.largest = std::max(spikes.largest, off[i]);
  }
  return spikes;
}

}  // namespace rc::formats

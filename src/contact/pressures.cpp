#include "contact/pressures.h"

#include <algorithm>

#include "core/large_memory.h"

namespace rc {

std::vector<double> Pressures::at(const TrialSet& other) const {
  if (on == other) return p;
  auto values = large_vector<double>(static_cast<std::size_t>(other.n));
  if (on.index.empty()) {
    for (std::size_t i = 0; i < values.size() && !p.empty(); ++i)
      values[i] = p[static_cast<std::size_t>(other.point(static_cast<std::int64_t>(i)))];
    return values;
  }
  if (other.index.empty()) {
    for (std::size_t k = 0; k < p.size(); ++k) values[static_cast<std::size_t>(on.index[k])] = p[k];
    return values;
  }
  std::size_t k = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    while (k < p.size() && on.index[k] < other.index[i]) ++k;
    if (k < p.size() && on.index[k] == other.index[i]) values[i] = p[k];
  }
  return values;
}

void Pressures::write(double* everywhere, std::int64_t points) const {
  if (!p.empty() && on.index.empty()) {
    std::copy(p.begin(), p.end(), everywhere);
    return;
  }
  std::fill_n(everywhere, points, 0.0);
  for (std::size_t k = 0; k < p.size(); ++k) everywhere[on.index[k]] = p[k];
}

Pressures Pressures::positive() const {
  Pressures result;
  const auto count = static_cast<std::size_t>(std::count_if(p.begin(), p.end(), [](double value) { return value > 0; }));
  result.on.index.reserve(count);
  result.p.reserve(count);
  for (std::size_t k = 0; k < p.size(); ++k) {
    if (!(p[k] > 0)) continue;
    result.on.index.push_back(on.point(static_cast<std::int64_t>(k)));
    result.p.push_back(p[k]);
  }
  result.on.n = static_cast<std::int64_t>(result.p.size());
  return result;
}

}  // namespace rc

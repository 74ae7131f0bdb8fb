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

void Pressures::write(const OutputArray& everywhere, std::int64_t points) const {
  const auto write_to = [&]<class Real>(Real* to) {
    if (!to) return;
    const auto rounded = [](double value) { return static_cast<Real>(value); };
    if (!p.empty() && on.index.empty()) {
      std::transform(p.begin(), p.end(), to, rounded);
      return;
    }
    std::fill_n(to, points, Real{0});
    for (std::size_t k = 0; k < p.size(); ++k) to[on.index[k]] = rounded(p[k]);
  };
  write_to(everywhere.in_double);
  write_to(everywhere.in_single);
}

Pressures Pressures::positive() const {
  Pressures result;
  const auto count = static_cast<std::size_t>(std::count_if(p.begin(), p.end(), [](double value) { return value > 0; }));
  std::vector<std::int64_t>& index = result.on.index;
  index.resize(count + 1);  // written without a branch, which would be foreseen wrongly: one place more than there are
  result.p.resize(count + 1);
  std::size_t n = 0;
  for (std::size_t k = 0; k < p.size(); ++k) {
    index[n] = on.index.empty() ? static_cast<std::int64_t>(k) : on.index[k];
    result.p[n] = p[k];
    n += p[k] > 0;
  }
  index.resize(count);
  result.p.resize(count);
  result.on.n = static_cast<std::int64_t>(count);
  return result;
}

}  // namespace rc

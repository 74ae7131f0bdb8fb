#include "contact/surface/pressures.h"

#include <algorithm>
#include <numeric>

#include "core/chunks.h"
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

void Pressures::write(const OutputArray& everywhere, std::int64_t points, const rc_team& team) const {
  if (!everywhere.wanted()) return;
  const auto write_to = [&]<class Real>(Real* to) {
    const auto rounded = [](double value) { return static_cast<Real>(value); };
    const bool all = !p.empty() && on.index.empty();
    each_chunk(points, team, [&](std::int64_t begin, std::int64_t count) {
      if (all)
        std::transform(p.begin() + begin, p.begin() + begin + count, to + begin, rounded);
      else
        std::fill_n(to + begin, count, Real{0});
    });
    if (all) return;
    each_chunk(static_cast<std::int64_t>(p.size()), team, [&](std::int64_t begin, std::int64_t count) {
      for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(begin + count); ++k)
        to[on.index[k]] = rounded(p[k]);
    });
  };
  if (everywhere.single())
    write_to(static_cast<float*>(everywhere.array.data));
  else
    write_to(static_cast<double*>(everywhere.array.data));
}

Pressures Pressures::positive(const rc_team& team) const {
  const auto n = static_cast<std::int64_t>(p.size());
  const Chunks chunks;
  std::vector<std::size_t> first(static_cast<std::size_t>(chunks.count(n)) + 1);  // of each chunk, in the result
  each_chunk(n, team, [&](std::int64_t begin, std::int64_t count) {
    first[static_cast<std::size_t>(begin / chunks.values) + 1] = static_cast<std::size_t>(
        std::count_if(p.begin() + begin, p.begin() + begin + count, [](double value) { return value > 0; }));
  });
  std::partial_sum(first.begin(), first.end(), first.begin());
  Pressures result;
  result.on.index = large_vector<std::int64_t>(first.back(), team);
  result.p = large_vector<double>(first.back(), team);
  each_chunk(n, team, [&](std::int64_t begin, std::int64_t count) {
    constexpr std::int64_t at_once = 256;
    auto at = static_cast<std::int64_t>(first[static_cast<std::size_t>(begin / chunks.values)]);
    for (std::int64_t next = begin; next < begin + count; next += at_once) {
      // No branch for each value, which would be predicted wrongly: the array has one place more than needed.
      std::int64_t index[at_once + 1];
      double value[at_once + 1];
      std::int64_t found = 0;
      for (std::int64_t i = next; i < std::min(next + at_once, begin + count); ++i) {
        const auto k = static_cast<std::size_t>(i);
        index[found] = on.index.empty() ? i : on.index[k];
        value[found] = p[k];
        found += p[k] > 0;
      }
      std::copy_n(index, found, result.on.index.begin() + at);
      std::copy_n(value, found, result.p.begin() + at);
      at += found;
    }
  });
  result.on.n = static_cast<std::int64_t>(first.back());
  return result;
}

}  // namespace rc

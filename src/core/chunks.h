// Passes over many values by all threads, in pieces of a fixed size, so that nothing depends on the number of threads. What is
// called for a piece must not throw.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <roughcontact/plugin.hpp>
#include <vector>

#include "core/rows.h"

namespace rc {

inline constexpr std::int64_t chunk_values = 8192;
inline constexpr std::int64_t least_shared_values = 4 * chunk_values;  // fewer are left to one thread

// How values are cut into chunks, and whose they are.
struct Chunks {
  std::int64_t values = chunk_values;
  const Ranks* ranks = nullptr;  // not null: the values are of this rank's rows, and a chunk is a piece of rows

  // The chunks of a grid with nx points in a row.
  static Chunks of(const Ranks* ranks, std::int64_t nx) { return ranks ? Chunks{ranks->piece_rows() * nx, ranks} : Chunks{}; }
  static Chunks of(const Rows& rows, std::int64_t nx) { return of(rows.ranks(), nx); }
  std::int64_t count(std::int64_t n) const { return (n + values - 1) / values; }
};

// act(begin, count) for all chunks of this process.
template <class Act> void each_chunk(std::int64_t n, const rc_team& team, const Act& act, const Chunks& chunks = {}) {
  roughcontact::for_each(team, chunks.count(n), n >= least_shared_values, [&](std::int64_t item, std::int64_t) {
    const std::int64_t begin = item * chunks.values;
    act(begin, std::min(chunks.values, n - begin));
  });
}

// Combines body(begin, count) of all chunks, of all ranks where there are several, in their order.
template <class Part, class Body, class Combine = std::plus<>>
Part reduce(std::int64_t n, const rc_team& team, const Body& body, Part total = {}, const Combine& combine = {},
            const Chunks& chunks = {}) {
  const auto add = [&](const Part& part) { total = combine(total, part); };
  const auto of_each = [&](const auto& put) {
    each_chunk(
        n, team,
        [&](std::int64_t begin, std::int64_t count) { put(static_cast<std::size_t>(begin / chunks.values), body(begin, count)); },
        chunks);
  };
  if (chunks.ranks) {
    of_each([&](std::size_t i, const Part& part) { chunks.ranks->put_part(i, part); });
    chunks.ranks->each_part<Part>(add);
    return total;
  }
  std::vector<Part> parts(static_cast<std::size_t>(chunks.count(n)));
  of_each([&](std::size_t i, const Part& part) { parts[i] = part; });
  std::for_each(parts.begin(), parts.end(), add);
  return total;
}

// The sum of part(0 .. n-1), one for each piece of this process's rows, over all ranks in their order. It takes no memory.
template <class Part, class Of> Part total(const Rows& rows, std::size_t n, const Of& part) {
  const Ranks* const ranks = rows.ranks();
  Part sum{};
  for (std::size_t i = 0; i < n; ++i)
    if (ranks)
      ranks->put_part(i, part(i));
    else
      sum = sum + part(i);
  if (ranks) ranks->each_part<Part>([&](const Part& each) { sum = sum + each; });
  return sum;
}

// A bit for each of n values. Chunks share no word.
class Marks {
 public:
  explicit Marks(std::int64_t n) : words_(static_cast<std::size_t>((n + 63) / 64)) {}
  void add(std::size_t i) { words_[i / together] |= std::uint64_t{1} << i % together; }
  // One word marks this many values, from a multiple of this number on.
  static constexpr std::size_t together = 64;
  void set(std::size_t first, std::uint64_t marked) { words_[first / together] = marked; }
  // The marked values in ascending order.
  std::vector<std::size_t> list() const {
    std::size_t count = 0;
    for (const std::uint64_t word : words_) count += static_cast<std::size_t>(std::popcount(word));
    std::vector<std::size_t> all;
    all.reserve(count);
    for (std::size_t k = 0; k < words_.size(); ++k)
      for (std::uint64_t rest = words_[k]; rest != 0; rest &= rest - 1)
        all.push_back(64 * k + static_cast<std::size_t>(std::countr_zero(rest)));
    return all;
  }

 private:
  std::vector<std::uint64_t> words_;
};

}  // namespace rc

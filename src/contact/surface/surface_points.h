// The points of a surface that this process has, and sums over the points of all processes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <roughcontact/plugin.hpp>
#include <span>
#include <vector>

#include "core/chunks.h"
#include "core/rows.h"

namespace rc {

class SurfacePoints {
 public:
  SurfacePoints() = default;
  // n: of this process, in rows of nx. The team must outlive them.
  SurfacePoints(std::int64_t nx, std::int64_t n, const rc_team& team, const Rows& rows = {})
      : nx_(nx), n_(n), team_(&team), rows_(rows) {}

  std::int64_t nx() const { return nx_; }
  std::int64_t count() const { return n_; }  // of this process
  const rc_team& team() const { return *team_; }
  const Rows& rows() const { return rows_; }
  Chunks chunks() const { return Chunks::of(rows_, nx_); }
  bool threaded() const { return n_ > 64 * 64; }  // with fewer points threads would cost more than they save

  // act(i) for i = 0 .. n-1, which share these points, by threads if that pays.
  template <class Act> void each(std::int64_t n, const Act& act) const {
    roughcontact::for_each(team(), n, threaded(), [&](std::int64_t i, std::int64_t) { act(i); });
  }

  // The sum of what add(part, entry) adds for entries 0 .. n-1, by pieces of a fixed size: of entries, or of rows that ranks
  // share. entry(k): its point, ascending with k.
  template <class Part, class Entry, class Add> Part sum_over(std::size_t n, const Entry& entry, const Add& add) const {
    constexpr std::int64_t entries_of_a_piece = std::int64_t{1} << 16;
    if (!rows_.shared())
      return reduce<Part>(
          static_cast<std::int64_t>(n), team(),
          [&](std::int64_t begin, std::int64_t count) {
            Part part;
            for (std::int64_t k = begin; k < begin + count; ++k) add(part, entry(static_cast<std::size_t>(k)));
            return part;
          },
          Part{}, {}, Chunks{entries_of_a_piece});
    const Chunks pieces = chunks();
    std::vector<Part> parts(static_cast<std::size_t>(pieces.count(n_)));
    for (std::size_t k = 0; k < n; ++k) add(parts[entry(k) / static_cast<std::size_t>(pieces.values)], entry(k));
    return total<Part>(rows_, parts.size(), [&](std::size_t i) { return parts[i]; });
  }
  // The same for a list of points.
  template <class Part, class Add> Part sum_over(std::span<const std::size_t> entries, const Add& add) const {
    return sum_over<Part>(
        entries.size(), [&](std::size_t k) { return entries[k]; }, add);
  }
  // Combines the entries of all processes by add(part, entry), for parts that are exact in any order: counts, extents, extremes.
  template <class Part, class Add> Part combined_over(std::span<const std::size_t> entries, const Add& add) const {
    return rows_.united(reduce<Part>(static_cast<std::int64_t>(entries.size()), team(), [&](std::int64_t begin, std::int64_t n) {
      Part part;
      for (const std::size_t entry : entries.subspan(static_cast<std::size_t>(begin), static_cast<std::size_t>(n)))
        add(part, entry);
      return part;
    }));
  }

 private:
  std::int64_t nx_ = 0, n_ = 0;
  const rc_team* team_ = nullptr;
  Rows rows_;
};

}  // namespace rc

// The points of a surface that this process has, and sums over the points of all processes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/chunks.h"
#include "core/company.h"

namespace rc {

class SurfacePoints {
 public:
  SurfacePoints() = default;
  // n: of this process, in rows of nx. The team must outlive them.
  SurfacePoints(std::int64_t nx, std::int64_t n, const rc_team& team, const Company& company = {})
      : nx_(nx), n_(n), team_(&team), company_(company) {}

  std::int64_t nx() const { return nx_; }
  std::int64_t count() const { return n_; }  // of this process
  const rc_team& team() const { return *team_; }
  const Company& company() const { return company_; }
  Chunks chunks() const { return company_.chunks(nx_); }
  bool threaded() const { return n_ > 64 * 64; }  // with fewer points threads would cost more than they save

  // The sum of what add(part, entry) adds for entries 0 .. n-1, by pieces of a fixed size. entry(k): its point, ascending with k.
  template <class Part, class Entry, class Add> Part sum_over(std::size_t n, const Entry& entry, const Add& add) const {
    return company_.sum_over<Part>(n, n_, nx_, team(), entry, add);
  }
  // The same for a list of points.
  template <class Part, class Add> Part sum_over(std::span<const std::size_t> entries, const Add& add) const {
    return sum_over<Part>(
        entries.size(), [&](std::size_t k) { return entries[k]; }, add);
  }
  // Combines the entries of all processes by add(part, entry), for parts that are exact in any order: counts, extents, extremes.
  template <class Part, class Add> Part combined_over(std::span<const std::size_t> entries, const Add& add) const {
    return company_.united(
        reduce<Part>(static_cast<std::int64_t>(entries.size()), team(), [&](std::int64_t begin, std::int64_t n) {
          Part part;
          for (const std::size_t entry : entries.subspan(static_cast<std::size_t>(begin), static_cast<std::size_t>(n)))
            add(part, entry);
          return part;
        }));
  }

 private:
  std::int64_t nx_ = 0, n_ = 0;
  const rc_team* team_ = nullptr;
  Company company_;
};

}  // namespace rc

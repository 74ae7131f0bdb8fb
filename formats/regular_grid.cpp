#include "formats/regular_grid.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>

#include "formats/error.h"
#include "formats/wording.h"

namespace rc::formats {

namespace {

constexpr double largest_offset = 0.1;  // of the pitch

// Distances between neighbours in an ordered list, without zeros, in ascending order.
std::vector<double> spacings(const std::vector<double>& sorted) {
  std::vector<double> found;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (sorted[i] > sorted[i - 1]) found.push_back(sorted[i] - sorted[i - 1]);
  }
  std::ranges::sort(found);
  return found;
}

// Possible pitches: the least spacing; the median, if a few spacings are odd; the first one after the largest jump, if
// coordinates of the same line differ by rounding. The largest comes first, because everything fits on a grid that is fine
// enough.
std::vector<double> candidates(const std::vector<double>& spacing) {
  std::size_t jump = 0;
  for (std::size_t i = 1; i < spacing.size(); ++i) {
    const bool larger = jump == 0 || spacing[i] / spacing[i - 1] > spacing[jump] / spacing[jump - 1];
    if (larger) jump = i;
  }
  std::vector<double> pitches{spacing.front(), spacing[spacing.size() / 2], spacing[jump]};
  std::ranges::sort(pitches, std::greater{});
  return pitches;
}

struct Lines {
  double first, pitch;
  std::int64_t count;
};

// Steps from line to line, so that an inexact first guess of the pitch does not add up.
std::optional<Lines> scan_lines(const std::vector<double>& sorted, double pitch, std::int64_t most_lines) {
  for (int pass = 0; pass < 3; ++pass) {
    double line = sorted.front(), count = 0;
    for (const double x : sorted) {
      const double steps = std::round((x - line) / pitch);
      if (steps < 1) continue;
      count += steps;
      line = x;
      if (!(count < static_cast<double>(most_lines))) return std::nullopt;
    }
    if (count < 1) return std::nullopt;
    pitch = (sorted.back() - sorted.front()) / count;
    if (pass == 2) return Lines{sorted.front(), pitch, static_cast<std::int64_t>(count) + 1};
  }
  return std::nullopt;
}

bool all_on_lines(const std::vector<double>& sorted, const Lines& lines) {
  return std::ranges::all_of(sorted, [&](double x) {
    const double at = (x - lines.first) / lines.pitch;
    return std::abs(at - std::round(at)) <= largest_offset;
  });
}

}  // namespace

GridAxis find_grid_axis(const std::vector<double>& coordinates, std::int64_t most_lines, std::string_view name) {
  std::vector<double> sorted = coordinates;
  std::ranges::sort(sorted);
  const auto spacing = spacings(sorted);
  if (spacing.empty()) throw Error("all points have the same ", name, ": a profile, a map is needed");

  for (const double pitch : candidates(spacing)) {
    const auto lines = scan_lines(sorted, pitch, most_lines);
    if (!lines || !all_on_lines(sorted, *lines)) continue;
    GridAxis axis{lines->pitch, lines->count, {}};
    axis.index.reserve(coordinates.size());
    for (const double x : coordinates) axis.index.push_back(std::llround((x - lines->first) / lines->pitch));
    return axis;
  }
  throw Error("the points are on no regular grid along ", name, ": neighbours are ", rc::in_digits(spacing.front(), 6), " to ",
              rc::in_digits(spacing.back(), 6), " apart; interpolate them on a grid first");
}

}  // namespace rc::formats

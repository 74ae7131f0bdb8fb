// Whether three columns are coordinates x, y and a height, or a matrix of three heights a row. Coordinates fill a regular grid,
// run along lines as scans do, or have another scale than heights. Neighbouring columns of a map are similar.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "formats/error.h"
#include "formats/readers.h"
#include "formats/regular_grid.h"

namespace rc::formats {

namespace {

using Column = std::vector<double>;

bool all_finite(const Column& values) {
  return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

// The correlation coefficient; 1 if a column is constant.
double likeness(const Column& a, const Column& b) {
  const auto count = static_cast<double>(a.size());
  double mean_a = 0, mean_b = 0, aa = 0, bb = 0, ab = 0;
  for (std::size_t i = 0; i < a.size(); ++i) mean_a += a[i] / count, mean_b += b[i] / count;
  for (std::size_t i = 0; i < a.size(); ++i) {
    aa += (a[i] - mean_a) * (a[i] - mean_a);
    bb += (b[i] - mean_b) * (b[i] - mean_b);
    ab += (a[i] - mean_a) * (b[i] - mean_b);
  }
  return aa > 0 && bb > 0 ? std::abs(ab) / std::sqrt(aa * bb) : 1;
}

// A good part of the nodes of a regular grid has a point, and few have two.
bool fill_a_grid(const Column& x, const Column& y) {
  constexpr std::int64_t few = 9;
  constexpr double least = 0.25, least_of_few = 0.85;
  const auto count = static_cast<std::int64_t>(x.size()), most_nodes = 4 * count;
  try {
    const GridAxis along_x = find_grid_axis(x, most_nodes, "x"), along_y = find_grid_axis(y, most_nodes, "y");
    if (along_y.count > most_nodes / along_x.count) return false;
    std::vector<bool> taken(static_cast<std::size_t>(along_x.count * along_y.count));
    for (std::size_t i = 0; i < x.size(); ++i)
      taken[static_cast<std::size_t>(along_y.index[i] * along_x.count + along_x.index[i])] = true;
    const std::int64_t nodes = std::ranges::count(taken, true), repeated = count - nodes;
    const double share = static_cast<double>(nodes) / static_cast<double>(taken.size());
    return share >= (count < few ? least_of_few : least) && repeated <= std::max<std::int64_t>(1, count / 5);
  } catch (const Error&) {
    return false;  // no grid
  }
}

struct ScanLine {
  double sum = 0, lowest = INFINITY, highest = -INFINITY;
  std::int64_t count = 0;

  void add(double value) {
    sum += value;
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
    ++count;
  }
  double mean() const { return sum / static_cast<double>(count); }
};

// Along each line `fast` goes one way and `slow` differs from the line's mean by less than half of the distance to the next line.
bool run_along_lines(const Column& fast, const Column& slow) {
  constexpr std::size_t fewest_lines = 3, fewest_points = 9;
  if (fast.size() < fewest_points) return false;
  std::vector<ScanLine> lines(1);
  double way = 0;
  for (std::size_t i = 0; i < fast.size(); ++i) {
    const double step = i == 0 ? 0 : fast[i] - fast[i - 1];
    if (i > 0 && (step == 0 || step * way < 0)) {
      lines.emplace_back();
      way = 0;
    } else if (lines.back().count > 0) {
      way = step;
    }
    lines.back().add(slow[i]);
  }
  if (lines.size() < fewest_lines || 2 * lines.size() > fast.size()) return false;
  const bool upwards = lines[1].mean() > lines[0].mean();
  for (std::size_t k = 1; k < lines.size(); ++k) {
    const double gap = (lines[k].mean() - lines[k - 1].mean()) * (upwards ? 1 : -1);
    if (!(gap > 0)) return false;
    for (const ScanLine& line : {lines[k - 1], lines[k]})
      if (!(std::max(line.highest - line.mean(), line.mean() - line.lowest) < gap / 2)) return false;
  }
  return true;
}

// The range of the middle half of the values that are there.
double middle_range(Column values) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  if (values.size() < 8) return 0;
  std::ranges::sort(values);
  return values[3 * values.size() / 4] - values[values.size() / 4];
}

bool has_another_scale(const Column& x, const Column& y, const Column& z) {
  constexpr double most = 20;
  const double along_x = middle_range(x), along_y = middle_range(y), of_heights = middle_range(z);
  if (!(along_x > 0 && along_y > 0 && of_heights > 0)) return false;
  return of_heights > most * std::max(along_x, along_y) || most * of_heights < std::min(along_x, along_y);
}

}  // namespace

Columns kind_of_columns(const std::vector<double>& rows) {
  constexpr std::size_t fewest = 4, fewest_to_compare = 8;  // a grid of 2 x 2
  constexpr double least_likeness = 0.5;
  const std::size_t count = rows.size() / 3;
  if (count < fewest) return Columns::heights;
  Column x, y, z;
  for (std::size_t i = 0; i + 2 < rows.size(); i += 3) {
    x.push_back(rows[i]);
    y.push_back(rows[i + 1]);
    z.push_back(rows[i + 2]);
  }
  if (!all_finite(x) || !all_finite(y)) return Columns::heights;
  const bool unlike = likeness(x, y) < least_likeness;
  const bool points =
      (unlike && fill_a_grid(x, y)) || run_along_lines(x, y) || run_along_lines(y, x) || has_another_scale(x, y, z);
  if (points) return Columns::points;
  return unlike && count >= fewest_to_compare ? Columns::unclear : Columns::heights;
}

}  // namespace rc::formats

#include <limits>
#include <string>

#include "core/chunks.h"
#include "known_answers.h"
#include "problems.h"

namespace mutants {

namespace {

// The marks as two numbers: how many there are, and a sum that changes with each of them.
void put(Figures& figures, const std::string& name, const std::vector<std::size_t>& marked) {
  double sum = 0;
  for (std::size_t k = 0; k < marked.size(); ++k) sum += static_cast<double>((marked[k] + 1) * (k + 1) % 1009);
  figures.exact(name + "_count", static_cast<double>(marked.size()));
  figures.exact(name + "_sum", sum);
}

}  // namespace

void figures_of_marks(Figures& figures) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  for (const std::int64_t ny : {1, 8, 11}) {
    Small small(16, ny);
    small.compression = 0.4;
    small.press(0.4, 0.1, 3);
    small.answer.product[5] = infinite;
    small.answer.product[9] = std::numeric_limits<double>::quiet_NaN();
    if (ny > 8) small.answer.product[100] = -infinite;
    const rc::StepSurface surface = small.surface();
    for (const double limit : {-0.1, 0.0, 0.05, 0.3, infinite}) {
      figures.section("marks/" + std::to_string(ny) + "/" + std::to_string(limit));
      const auto n = static_cast<std::int64_t>(small.points());
      rc::Marks all(n), end(n);
      mark_near(surface, small.answer.on(), small.answer.product, small.compression, limit, 0, n, all);
      put(figures, "all", all.list());
      if (n <= 64) continue;
      mark_near(surface, small.answer.on(), small.answer.product, small.compression, limit, 64, n - 64, end);
      put(figures, "end", end.list());
    }
  }
  // One near point in each place of a word.
  Small one(64, 1);
  one.compression = 0.4;
  one.press(0.4, 0.1, 3);
  const rc::StepSurface surface = one.surface();
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < one.points(); ++k) {
    std::vector<double> product(one.points(), 10);
    product[k] = 0;
    rc::Marks marks(64);
    mark_near(surface, one.answer.on(), product, one.compression, 1, 0, 64, marks);
    for (const std::size_t each : marks.list()) found.push_back(each);
  }
  figures.section("marks/one");
  put(figures, "each", found);
}

}  // namespace mutants

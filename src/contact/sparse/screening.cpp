#include "contact/sparse/screening.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "contact/operators.h"
#include "contact/proof/survey.h"
#include "core/chunks.h"
#include "core/large_memory.h"

namespace rc {

namespace {

// The largest size of a product, and where it is found first: among these points.
struct Largest {
  double size = 0;
  std::int64_t begin = 0, end = 0;
  Largest operator+(const Largest& b) const { return b.size > size ? b : *this; }
};

// H p on the trial set, and at least at the points outside it whose gap is below the margin, by a product over all points; of
// processes each checks its rows. Bounds of round-off also need the largest |H p|.
Deflected near_surface(const GridProblem& problem, const Answer& answer, double compression, double margin) {
  const StepSurface& own = problem.surface.own();
  const SurfacePoints& points_of = own.points();
  const Rows& rows = points_of.rows();
  const std::int64_t n = points_of.count(), before = rows.first() * points_of.nx();
  auto product = large_vector<double>(static_cast<std::size_t>(n));
  answer.op->field(answer.p, product);
  Marks marks(n);
  const auto body = [&](std::int64_t begin, std::int64_t count) {
    constexpr std::int64_t lanes = 4;
    double largest[lanes] = {};
    double* const of = product.data() + begin;
    const auto take = [&](std::int64_t i, std::int64_t lane) {
      of[i] *= answer.units.length;
      const double size = std::abs(of[i]);
      largest[lane] = size > largest[lane] ? size : largest[lane];
    };
    std::int64_t i = 0;
    for (; i + lanes <= count; i += lanes)
      for (std::int64_t lane = 0; lane < lanes; ++lane) take(i + lane, lane);
    for (; i < count; ++i) take(i, 0);
    mark_near(own, {}, product, compression, margin, begin, count, marks);
    return Largest{*std::max_element(largest, largest + lanes), begin, begin + count};
  };
  const Largest mine = reduce<Largest>(n, points_of.team(), body), whole = rows.united(mine);
  for (std::int64_t i = mine.begin; i < mine.end && mine.size == whole.size; ++i)
    if (std::abs(product[static_cast<std::size_t>(i)]) == whole.size) marks.add(static_cast<std::size_t>(i));
  const TrialSet& trial = answer.op->trial();
  for (std::int64_t i = 0; i < trial.n; ++i)
    if (const std::int64_t at = trial.point(i) - before; at >= 0 && at < n) marks.add(static_cast<std::size_t>(at));
  std::vector<std::int64_t> points;
  std::vector<double> products;
  for (const std::size_t i : marks.list()) {
    points.push_back(static_cast<std::int64_t>(i) + before);
    products.push_back(product[i]);
  }
  Deflected result;
  result.pressures.on.index = rows.joined(std::move(points));
  result.pressures.on.n = static_cast<std::int64_t>(result.pressures.on.index.size());
  result.product = rows.joined(std::move(products));
  problem.surface.hold_tiles_of(result.pressures.on.index);
  result.pressures.p = answer.pressures().at(result.pressures.on);
  if (result.pressures.on.n == problem.system.points()) result.pressures.on.index.clear();
  result.beyond = margin;
  return result;
}

// The entries of all processes that screen their own rows.
template <class Value> void unite(const Rows& rows, std::vector<Value>& found, std::int64_t count) {
  found.resize(static_cast<std::size_t>(count));
  found = rows.joined(std::move(found));
}

}  // namespace

bool screens(const Choice& choice) { return (choice.backend->caps & RC_CAP_SCREEN) != 0; }

Deflected screened(const GridProblem& problem, const Answer& answer, double compression, double margin) {
  if (problem.operators().multiply_by_rows() || !screens(answer.choice))
    return near_surface(problem, answer, compression, margin);
  const StepSurface& surface = problem.surface;
  const TrialSet& trial = answer.op->trial();
  Deflected result;
  std::vector<double> y(answer.p.size()), depth, far;
  std::vector<std::int64_t> found;
  rc_screen request{};
  request.struct_size = sizeof request;
  request.approach = surface.range().limit_of(compression + margin);
  const StepSurface& own = surface.own();
  request.undeformed_gap = own.gap().array();
  request.mask = own.mask().data();
  const Rows& rows = own.points().rows();
  if (surface.gathered()) {
    request.first_row = rows.first();
    request.rows = rows.own(0);
    if (request.rows == 0) {  // this process has none, and checks a row that is far away
      far.assign(static_cast<std::size_t>(surface.points().nx()), std::numeric_limits<double>::infinity());
      request.first_row = 0;
      request.rows = 1;
      request.undeformed_gap = {far.data(), RC_NATIVE, 0, nullptr};
      request.mask = nullptr;
    }
  } else {
    request.tile_lowest = surface.tiles().lowest.data();
  }
  request.y = y.data();
  request.room = std::max<std::int64_t>(1 << 16, 4 * trial.n);
  for (;;) {
    found.resize(static_cast<std::size_t>(request.room));
    depth.resize(found.size());
    request.found = found.data();
    request.depth = depth.data();
    request.unit = answer.units.length;
    answer.op->screen(answer.p, request);
    if (request.n_found <= request.room) break;
    request.room = request.n_found;
  }
  unite(rows, found, request.n_found);
  unite(rows, depth, request.n_found);
  request.n_found = static_cast<std::int64_t>(found.size());
  surface.hold_tiles_of(trial.index);
  surface.hold_tiles_of(found);
  std::vector<std::size_t> order(static_cast<std::size_t>(request.n_found));
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return found[a] < found[b]; });

  const std::size_t n = y.size() + order.size();
  result.pressures.on.n = static_cast<std::int64_t>(n);
  result.pressures.on.index.reserve(n);
  result.pressures.p.reserve(n);
  result.product.reserve(n);
  const auto put = [&](std::int64_t point, double p, double product) {
    result.pressures.on.index.push_back(point);
    result.pressures.p.push_back(p);
    result.product.push_back(product);
  };
  std::size_t next = 0;
  const auto put_found_below = [&](std::int64_t limit) {
    for (; next < order.size() && found[order[next]] < limit; ++next) {
      const std::int64_t point = found[order[next]];
      // Inverts what the backend computed, so that the approach and its round-off drop out.
      put(point, 0, request.approach - surface.gap_at(static_cast<std::size_t>(point)) - depth[order[next]]);
    }
  };
  for (std::size_t i = 0; i < y.size(); ++i) {
    const std::int64_t point = trial.point(static_cast<std::int64_t>(i));
    put_found_below(point);
    put(point, answer.p[i] * answer.units.pressure, y[i] * answer.units.length);
  }
  put_found_below(problem.system.points());
  if (result.pressures.on.n == problem.system.points()) result.pressures.on.index.clear();
  result.beyond = request.approach - surface.lowest() - compression;
  return result;
}

}  // namespace rc

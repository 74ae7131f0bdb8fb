// A step at the load whose contact has a given area: one load after the other presses the same surface.
#include <algorithm>
#include <cstddef>
#include <cstring>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "contact/calls/area_search.h"
#include "contact/calls/contact.h"
#include "contact/calls/controls.h"
#include "contact/surface/rms_slope.h"
#include "core/array.h"
#include "core/error.h"

namespace rc {

namespace {

constexpr double most_pressure = 1e3;   // over E*
constexpr double slope_if_flat = 2e-3;  // of a surface without neighbours of unequal height
constexpr double load_of_slope = 0.5;   // Persson, light loads: mean pressure over E* times the slope, per share in contact

// Room for what the loads write: the caller's arrays get the answer only.
class Room {
 public:
  Room(const Outputs& given, const GridProblem& problem) : given_(given) {
    problem.rows().on_all([&] {
      const auto n = static_cast<std::size_t>(problem.own_points());
      outputs.p = taken(given.p, n, p_);
      outputs.gap = taken(given.gap, n, gap_);
    });
  }

  void give() const {
    copy(outputs.p, given_.p, p_);
    copy(outputs.gap, given_.gap, gap_);
  }

  Outputs outputs;

 private:
  struct Bytes {
    std::unique_ptr<std::byte[]> data;
    std::size_t size = 0;
  };

  static OutputArray taken(const OutputArray& given, std::size_t n, Bytes& bytes) {
    if (!given.wanted()) return {};
    bytes.size = n * bytes_of_value(given.array, sizeof(double));
    bytes.data = std::make_unique_for_overwrite<std::byte[]>(bytes.size);
    rc_array array = given.array;
    array.data = bytes.data.get();
    return OutputArray(array);
  }
  static void copy(const OutputArray& from, const OutputArray& to, const Bytes& bytes) {
    if (from.wanted()) std::memcpy(to.array.data, bytes.data.get(), bytes.size);
  }

  const Outputs given_;
  Bytes p_, gap_;
};

// Afterwards the contact remembers one step, that of the load found, or none if no load was.
class OneStep {
 public:
  explicit OneStep(GridContact& grid) : grid_(grid), before_(grid.memory()) {}
  ~OneStep() {
    Memory after = grid_.memory();
    if (!found_) {
      after.last = before_.last;
      grid_.leave_bodies();
    }
    after.before = found_ ? before_.last : before_.before;
    grid_.recall(std::move(after));
  }
  OneStep(const OneStep&) = delete;
  OneStep& operator=(const OneStep&) = delete;

  void begin_cold() {
    Memory cold = before_;
    cold.forget();
    cold.indented = before_.indented;
    grid_.recall(std::move(cold));
  }
  void found() { found_ = true; }

 private:
  GridContact& grid_;
  const Memory before_;
  bool found_ = false;
};

struct Count {
  std::int64_t n = 0;
  Count operator+(const Count& b) const { return {n + b.n}; }
};

// The height above the lowest gap that a share of the points, of all that count, do not exceed.
double height_of_share(double share, const StepSurface& surface, std::int64_t points) {
  std::vector<double> heights;
  for (std::int64_t i = 0; i < points; ++i)
    if (const auto k = static_cast<std::size_t>(i); surface.included(k)) heights.push_back(surface.height(k));
  if (heights.empty()) return 0;
  const auto rank = static_cast<std::size_t>(share * static_cast<double>(points));
  const auto at = heights.begin() + static_cast<std::ptrdiff_t>(std::min(rank, heights.size() - 1));
  std::nth_element(heights.begin(), at, heights.end());
  return *at;
}

// The load of the last step, scaled. Without one Persson's at light loads; without a half-space the load that presses the share
// of the points from the lowest gap on flat, each by itself.
double first_load(double share, const Step& step, const GridProblem& problem, const Memory& memory) {
  const System& system = problem.system;
  const rc_system& s = system.given;
  if (const CertifiedStep& last = memory.last; step.warm && last.same_gap && last.load > 0) {
    const std::int64_t contacts = problem.rows().united(Count{memory.contact_points(0, nullptr, nullptr)}).n;
    return last.load * share / (static_cast<double>(contacts) / static_cast<double>(system.points()));
  }
  if (system.halfspace()) {
    const double slope = rms_slope(problem.surface, s.hx, s.hy);
    return s.modulus * nominal_area(system) * share * load_of_slope * (slope > 0 ? slope : slope_if_flat);
  }
  const double depth = height_of_share(share, problem.surface, system.points());
  return share * nominal_area(system) * (depth > 0 ? depth : s.hx) / system.length_per_pressure;
}

AreaSearch::Limits limits_of(const GridProblem& problem) {
  const System& system = problem.system;
  const double included = static_cast<double>(problem.surface.range().included);
  if (included == 0) return {static_cast<double>(system.points()), 0, 0};
  const double pressure = system.halfspace() ? most_pressure * system.given.modulus : std::numeric_limits<double>::infinity();
  return {static_cast<double>(system.points()), included,
          std::min(pressure * nominal_area(system), system.hardness * included * system.cell_area())};
}

}  // namespace

Numbers Contact::at_area(Step step, double share, Monitor& monitor, const Outputs& outputs) {
  const GridProblem& problem = grid_.problem();
  const double points = static_cast<double>(problem.system.points());
  const Room room(outputs, problem);
  OneStep memory(grid_);
  if (!step.warm) memory.begin_cold();
  AreaSearch search(share, first_load(share, step, problem, grid_.memory()), limits_of(problem));
  Numbers numbers;
  const auto press = [&](double load) {
    clear_message();
    grid_.start_solve();
    start_solve();
    step.target.value = load;
    numbers = at_target(step, monitor, room.outputs);
    step.p0 = {};
    step.warm = true;
    return numbers.status == RC_OK || numbers.status == RC_WITHIN_GOAL;
  };
  bool good = true;
  while (good && !search.done()) {
    good = press(search.load());
    if (good) search.add(static_cast<double>(numbers.totals.contacts) / points);
  }
  if (good && search.nearest() != step.target.value) good = press(search.nearest());
  if (good) memory.found();
  if (good && !search.found()) {
    const std::string remark = join("area: ", in_digits(100 * share, 3), " % asked, ",
                                    in_digits(100 * static_cast<double>(numbers.totals.contacts) / points, 3),
                                    " % of the grid is the nearest that a load gives");
    std::vector<std::string> remarks{remark};
    if (numbers.note[0] != '\0') remarks.emplace_back(numbers.note);
    copy_text(numbers.note, note_from(remarks, sizeof numbers.note - 1).c_str());
  }
  room.give();
  return numbers;
}

}  // namespace rc

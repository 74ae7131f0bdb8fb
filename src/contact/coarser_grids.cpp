// No more than the scene needs: where an accuracy of load or area is asked for, grids are solved from coarse to fine until one
// may be within the goal, which a look at the given grid then decides.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "contact/blocks.h"
#include "contact/bounds.h"
#include "contact/contact.h"
#include "core/error.h"

namespace rc {

namespace {

constexpr std::int64_t least_side = 16;  // of a coarser grid
constexpr std::size_t most_grids = 12;

// What a coarser grid's solver reports goes on to the caller.
std::int32_t pass_on(const rc_progress* progress, void* user) {
  const auto& monitor = *static_cast<const Monitor*>(user);
  return monitor.ask() != RC_OK || monitor.report(*progress) != 0;
}

// Halved without a remainder where the period must stay what it is.
bool can_be_halved(const rc_system& system) {
  const bool even = system.nx % 2 == 0 && system.ny % 2 == 0;
  return std::min(system.nx, system.ny) >= 2 * least_side && (even || system.boundary != RC_BOUNDARY_PERIODIC);
}

double relative(double difference, double value) {
  return value > 0 ? std::abs(difference) / value : std::numeric_limits<double>::infinity();
}

}  // namespace

// The surface on every coarser grid.
void Contact::coarsen() {
  rc_system system = system_.given;
  std::size_t k = 0;
  for (const SurfaceState* finer = &surface_; can_be_halved(system) && k < most_grids; ++k) {
    const CoarseGrid coarse = halved(*finer, system.nx, system.ny, *team_);
    system.nx = coarse.nx;
    system.ny = coarse.ny;
    system.hx *= 2;
    system.hy *= 2;
    if (models_.size() == k) {
      auto contact = std::make_unique<Contact>(system, options_, team_);
      models_.emplace_back().contact = std::move(contact);
    }
    models_[k].contact->adopt(SurfaceState({coarse.nx, coarse.ny, coarse.gap, coarse.mask, false}, *team_));
    finer = &models_[k].contact->surface_;
  }
  models_current_ = true;
}

rc_status Contact::solve_model(std::size_t k, const rc_step& step, const Monitor& monitor, std::optional<Estimate> estimate,
                               bool with_gap) {
  Model& model = models_[k - 1];
  Contact& contact = *model.contact;
  rc_options options = options_;
  const auto set = [&](const char* key, const OptionValue& value) { options.values.set(options.context->option(key), value); };
  // It tells what the next finer grid's difference of approach is in load.
  if (k > 1 && step.control == RC_CONTROL_LOAD) set(RC_OPT_STIFFNESS, std::int64_t{1});
  set(RC_OPT_BOUNDS, std::int64_t{0});
  set(RC_OPT_TIME_LIMIT, monitor.time_left());
  contact.set_options(options);
  contact.goal_ = {};
  contact.on_progress({pass_on, const_cast<Monitor*>(&monitor), 1});
  rc_step on_model = RC_STEP_INIT;
  on_model.control = step.control;
  on_model.target = step.target;
  on_model.warm_start = step.warm_start;
  model.result = {};
  model.gap.resize(with_gap ? static_cast<std::size_t>(contact.system_.points()) : 0);
  model.result.gap = with_gap ? model.gap.data() : nullptr;
  contact.begin(on_model);
  if (contact.nothing_touches(on_model)) return RC_STOP_UNCERTIFIED;
  return contact.solve_begun(on_model, model.result, std::move(estimate));
}

// Difference of an answer's load from the next coarser grid's; in load control that of the loads at their approaches.
double Contact::difference(const rc_result& fine, const rc_result& coarse, std::int32_t control) {
  if (control == RC_CONTROL_DISPLACEMENT) return relative(fine.load - coarse.load, fine.load);
  const double difference = coarse.stiffness * (fine.displacement - coarse.displacement);
  return std::isfinite(difference) ? relative(difference, fine.load) : std::numeric_limits<double>::infinity();
}

Contact::OnCoarserGrids Contact::on_coarser_grids(const rc_step& step, const Monitor& monitor, bool with_gap) {
  for (Model& model : models_) model.result = {};
  try {
    if (!models_current_) coarsen();
  } catch (const Error&) {
    return {};  // means or cells that double precision does not hold
  }
  const auto surface = [&](std::size_t k) -> const SurfaceState& { return k > 0 ? models_[k - 1].contact->surface_ : surface_; };
  const auto system = [&](std::size_t k) -> const rc_system& {
    return k > 0 ? models_[k - 1].contact->system_.given : system_.given;
  };
  OnCoarserGrids found;
  std::vector<GridLevel> levels;  // up to the coarsest that touches
  for (std::size_t k = models_.size(); k >= 1; --k) {
    Model& model = models_[k - 1];
    rc_status status = RC_STOP_UNCERTIFIED;
    try {
      status = solve_model(k, step, monitor, std::exchange(found.estimate, {}), with_gap);
    } catch (const Error&) {
      // What a coarser grid cannot do, the whole one may.
    }
    if (const rc_status asked = monitor.ask(); asked != RC_OK || status == RC_STOP_CANCELLED) {
      // The last grid that was solved is better than nothing.
      const rc_status stop = asked != RC_OK ? asked : status;
      return {levels.empty() ? 0 : k + 1, stop, {}};
    }
    if (status != RC_OK || model.result.contacts == 0) {
      levels.clear();
      continue;
    }
    const bool coarsest = levels.empty();
    if (coarsest) levels.resize(k + 1);
    if (!coarsest) levels[k].difference = difference(model.result, models_[k].result, step.control);
    const double approach = model.result.displacement;
    const auto spread_to = [&](std::size_t finer, const Blocks& blocks) {
      return Estimate{spread(model.contact->last_.pressures, blocks, surface(finer), Cut::same_pressure), approach};
    };
    found.estimate = spread_to(k - 1, {system(k - 1).nx, system(k - 1).ny, 2});
    if (k + 2 >= levels.size()) continue;
    if (levels[k + 1].texture.points == 0)
      for (std::size_t j = 0; j < levels.size(); ++j)
        levels[j].texture = texture_below(approach, approach - surface_.lowest(), surface(j), system(j));
    const GridErrors errors = guessed_errors(levels, k);
    if (errors.here <= goal_.error) return {k, RC_WITHIN_GOAL, spread_to(0, blocks_of(k))};
    if (k > 1 && !(errors.finest <= goal_.error)) return {};  // near starts that the whole grid makes for itself
  }
  return found;
}

Blocks Contact::blocks_of(std::size_t k) const { return {system_.given.nx, system_.given.ny, std::int64_t{1} << k}; }

// Adds what the coarser grids of this step took.
void Contact::count_models(rc_result& result) const {
  for (const Model& model : models_) {
    result.iterations += model.result.iterations;
    result.applications += model.result.applications;
    result.setup_seconds += model.result.setup_seconds;
  }
}

// The last coarser grid that was solved, each block with its pressure.
rc_status Contact::deliver_stopped(const rc_step& step, const OnCoarserGrids& found, const Monitor& monitor, rc_result& result) {
  Model& model = models_[found.grid - 1];
  const rc_system& coarse = model.contact->system_.given;
  const Blocks blocks = blocks_of(found.grid);
  const Pressures p = spread(model.contact->last_.pressures, blocks, surface_, Cut::same_force);
  double *const to_p = result.p, *const to_gap = result.gap;
  const std::size_t size = result.struct_size;
  result = model.result;
  result.struct_size = size;
  result.p = to_p;
  result.gap = to_gap;
  if (options_.integer(RC_OPT_STIFFNESS) == 0) result.stiffness = std::numeric_limits<double>::quiet_NaN();
  Bounds{}.write(result);
  result.points = system_.points();
  result.contacts = p.on.n;
  double sum = 0;
  for (const double value : p.p) sum += value;
  result.load = sum * system_.cell_area();
  result.mean_pressure = sum / static_cast<double>(system_.points());
  result.contact_area = static_cast<double>(p.on.n) * system_.cell_area();
  if (step.control == RC_CONTROL_LOAD) result.kkt_control = load_imbalance(result.load, step.target);
  result.levels = 0;
  result.iterations = result.applications = 0;
  result.setup_seconds = 0;
  count_models(result);
  result.seconds = std::max(0.0, monitor.seconds() - result.setup_seconds);
  result.model_nx = coarse.nx;
  result.model_ny = coarse.ny;
  result.error_estimate = result.area_estimate = std::numeric_limits<double>::quiet_NaN();
  result.left_out = left_out(p, blocks, surface_, model.contact->surface_.gap());
  result.status = found.status;
  set_message(join(rc_status_text(found.status), ": the answer is that of ", coarse.nx, "x", coarse.ny, " of ", system_.given.nx,
                   "x", system_.given.ny, " points")
                  .c_str());
  if (to_p) p.write(to_p, system_.points());
  if (to_gap)
    for (std::int64_t i = 0; i < system_.points(); ++i) to_gap[i] = model.gap[static_cast<std::size_t>(blocks.of(i))];
  return found.status;
}

}  // namespace rc

#include "goal_trial.h"

#include <algorithm>
#include <cmath>
#include <iostream>

#include "format.h"
#include "goal_surfaces.h"
#include "library.h"
#include "provenance.h"
#include "result_file.h"
#include "table.h"

namespace bench {

namespace {

constexpr double exact_tol = 1e-9;

struct Tally {
  std::int64_t runs = 0, coarser = 0, beyond = 0, area_beyond = 0;
  std::vector<double> slack, area_slack, saved;

  void add(const Tally& other) {
    runs += other.runs;
    coarser += other.coarser;
    beyond += other.beyond;
    area_beyond += other.area_beyond;
    slack.insert(slack.end(), other.slack.begin(), other.slack.end());
    area_slack.insert(area_slack.end(), other.area_slack.begin(), other.area_slack.end());
    saved.insert(saved.end(), other.saved.begin(), other.saved.end());
  }
};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0 : (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
}

Json summary(const std::string& name, const Tally& tally) {
  const double rate = tally.coarser > 0 ? 100.0 * static_cast<double>(tally.beyond) / static_cast<double>(tally.coarser) : 0;
  return {{"surface", name},
          {"runs", tally.runs},
          {"coarser", tally.coarser},
          {"beyond", tally.beyond},
          {"beyond_percent", rate},
          {"slack", median(tally.slack)},
          {"area_beyond", tally.area_beyond},
          {"area_slack", median(tally.area_slack)},
          {"saved", median(tally.saved)}};
}

const std::vector<Column> columns = {{"surface", "surface"},
                                     {"runs", "runs"},
                                     {"on a coarser grid", "coarser"},
                                     {"beyond", "beyond"},
                                     {"estimate/error", "slack", "%.1f"},
                                     {"area beyond its estimate", "area_beyond"},
                                     {"area's estimate/error", "area_slack", "%.1f"},
                                     {"whole/this s", "saved", "%.2f"}};

class Trial {
 public:
  Trial(const GoalTrialRequest& request, const GoalSurface& surface)
      : request_(request), surface_(surface), exact_(solve(RC_CONTROL_DISPLACEMENT, surface.approach, options(exact_tol))) {}

  bool touches() const { return exact_.load > 0; }

  Tally run(bool by_load, bool of_area, double goal, const std::string& name) const {
    const std::int32_t control = by_load ? RC_CONTROL_LOAD : RC_CONTROL_DISPLACEMENT;
    const double target = by_load ? exact_.load : exact_.displacement;
    Options wanted = options(exact_tol);
    wanted.set(RC_OPT_ACCURACY, goal).set(RC_OPT_ACCURACY_OF, of_area ? "area" : "load");
    const rc_result found = solve(control, target, wanted);
    Tally tally;
    tally.runs = 1;
    if (found.status != RC_WITHIN_GOAL) return tally;
    const double load = by_load ? solve(RC_CONTROL_DISPLACEMENT, found.displacement, options(exact_tol)).load : found.load;
    const double area_error = std::abs(found.contact_area / exact_.contact_area - 1);
    const double error = of_area ? area_error : std::abs(load / exact_.load - 1);
    tally.coarser = 1;
    tally.beyond = !(error <= goal);
    tally.area_beyond = !(area_error <= found.area_estimate);
    if (error > 0) tally.slack = {found.error_estimate / error};
    if (area_error > 0) tally.area_slack = {found.area_estimate / area_error};
    if (tally.beyond > 0 || tally.area_beyond > 0)
      std::cerr << name
                << formatted(
                       ": goal %g of the %s, by %s: error %.4f, estimate %.4f, of the area %.4f, %.4f, from %lld of %lld points "
                       "a side\n",
                       goal, of_area ? "area" : "load", by_load ? "load" : "approach", error, found.error_estimate, area_error,
                       found.area_estimate, static_cast<long long>(found.model_nx), static_cast<long long>(surface_.system.nx));
    if (request_.times) {
      const rc_result whole = solve(control, target, options(goal / (of_area ? 1000 : 100)));
      tally.saved = {(whole.seconds + whole.setup_seconds) / (found.seconds + found.setup_seconds)};
    }
    return tally;
  }

 private:
  Options options(double tol) const {
    Options result;
    result.set(RC_OPT_TOL, tol).set(RC_OPT_BOUNDS, 0.0).set(RC_OPT_THREADS, static_cast<double>(request_.threads));
    return result;
  }

  rc_result solve(std::int32_t control, double target, const Options& with) const {
    rc_step step = RC_STEP_INIT;
    step.control = control;
    step.target = target;
    step.gap = surface_.gap.data();
    step.mask = surface_.mask.empty() ? nullptr : surface_.mask.data();
    step.borrow = 1;
    Contact contact(surface_.system, with);
    return contact.solve(step);
  }

  const GoalTrialRequest& request_;
  const GoalSurface& surface_;
  const rc_result exact_;
};

Tally of_surface(const GoalTrialRequest& request, const std::string& name, std::uint64_t seed) {
  const GoalSurface surface = make_goal_surface(name, request.points, seed);
  const std::string label = name + ", surface " + std::to_string(seed);
  Tally tally;
  const Trial trial(request, surface);
  if (!trial.touches()) return tally;
  for (const bool by_load : {false, true})
    for (const bool of_area : {false, true})
      for (const double goal : request.goals) tally.add(trial.run(by_load, of_area, goal, label));
  return tally;
}

}  // namespace

void run_goal_trial(const GoalTrialRequest& request) {
  ResultFile file(request.file, "goal-trial", request.threads);
  Json rows = Json::array();
  Tally all;
  for (const std::string& name : request.surfaces.empty() ? goal_surface_names() : request.surfaces) {
    Tally tally;
    for (std::int64_t seed = request.first; seed <= request.last; ++seed)
      tally.add(of_surface(request, name, static_cast<std::uint64_t>(seed)));
    rows.push_back(summary(name, tally));
    all.add(tally);
    std::cerr << name
              << formatted(": %lld of %lld\n", static_cast<long long>(tally.beyond), static_cast<long long>(tally.coarser));
  }
  rows.push_back(summary("all", all));
  std::cout << table(columns, rows)
            << formatted("%lld of %lld answers on a coarser grid beyond their goal, %.2f %%\n",
                         static_cast<long long>(all.beyond), static_cast<long long>(all.coarser),
                         rows.back().at("beyond_percent").get<double>());
  file.document()["rows"] = rows;
  file.save();
}

}  // namespace bench

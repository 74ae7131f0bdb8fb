#include "goal.h"

#include <algorithm>
#include <cmath>
#include <iostream>

#include "format.h"
#include "library.h"
#include "pareto_truth.h"
#include "provenance.h"
#include "result_file.h"
#include "table.h"

namespace bench {

namespace {

constexpr double exact_tol = 1e-9;
constexpr const char* controls[] = {"displacement", "load"};
constexpr const char* quantities[] = {"load", "area"};

Options options_of(const GoalRequest& request, double tol) {
  Options options;
  options.set(RC_OPT_TOL, tol).set(RC_OPT_THREADS, static_cast<double>(request.threads));
  return options;
}

double whole_seconds(const rc_result& result) { return result.seconds + result.setup_seconds; }

// One surface pressed to one approach.
class Pressed {
 public:
  Pressed(const GoalRequest& request, const ParetoScene& scene, double contact)
      : request_(request), system_(scene.system(4 * scene.n)), gap_(scene.gap(4 * scene.n)) {
    const double approach = scene.known ? scene.known(contact).target : search_approach(scene, contact, request.threads);
    exact_ = solve(RC_CONTROL_DISPLACEMENT, approach, options_of(request_, exact_tol));
  }

  std::int64_t points() const { return system_.nx; }
  double contact() const { return static_cast<double>(exact_.contacts) / static_cast<double>(exact_.points); }

  Json run(const std::string& control, const std::string& quantity, double goal) const {
    const bool by_load = control == "load";
    const std::int32_t mode = by_load ? RC_CONTROL_LOAD : RC_CONTROL_DISPLACEMENT;
    const double target = by_load ? exact_.load : exact_.displacement;
    Options options = options_of(request_, exact_tol);
    options.set(RC_OPT_ACCURACY, goal).set(RC_OPT_ACCURACY_OF, quantity);
    const rc_result found = solve(mode, target, options), whole = solve(mode, target, options_of(request_, goal / 100));
    return {{"status", rc_status_name(found.status)},      {"model", found.model_nx},    {"estimate", found.error_estimate},
            {"error", error_of(found, by_load, quantity)}, {"left_out", found.left_out}, {"seconds", whole_seconds(found)},
            {"whole_seconds", whole_seconds(whole)}};
  }

 private:
  rc_result solve(std::int32_t control, double target, const Options& options) const {
    rc_step step = RC_STEP_INIT;
    step.control = control;
    step.target = target;
    step.gap = gap_.data();
    step.borrow = 1;
    Contact contact(system_, options);
    return contact.solve(step);
  }

  double error_of(const rc_result& found, bool by_load, const std::string& quantity) const {
    if (quantity == "area") return std::abs(found.contact_area / exact_.contact_area - 1);
    if (!by_load) return std::abs(found.load / exact_.load - 1);
    const rc_result there = solve(RC_CONTROL_DISPLACEMENT, found.displacement, options_of(request_, exact_tol));
    return std::abs(there.load / exact_.load - 1);
  }

  const GoalRequest& request_;
  const rc_system system_;
  const Field gap_;
  rc_result exact_{};
};

void measure(const GoalRequest& request, ResultFile& file, const std::string& name, std::uint64_t seed) {
  const FoundScene made = make_pareto_scene(name, request.points / 4, request.surfaces, seed);
  if (!made.scene) {
    std::cerr << name << ": left out, " << made.missing << '\n';
    return;
  }
  const ParetoScene& scene = *made.scene;
  if (scene.control == RC_CONTROL_LOAD) return;  // pressed flat, the approach tells nothing
  const std::string library = library_hash();
  std::vector<double> contacts = request.contacts;
  if (scene.full) contacts = {100};
  for (const double contact : contacts) {
    if (contact / 100 > scene.most_contact) continue;
    std::unique_ptr<Pressed> pressed;
    for (const char* const control : controls)
      for (const char* const quantity : quantities)
        for (const double goal : request.goals) {
          const Json values = {{"scene", name},      {"points", 4 * scene.n}, {"seed", seed}, {"contact", contact},
                               {"control", control}, {"quantity", quantity},  {"goal", goal}};
          Json row = values;
          row["library"] = library;
          if (file.find("rows", row)) continue;
          if (!pressed) pressed = std::make_unique<Pressed>(request, scene, contact / 100);
          row["share"] = pressed->contact();
          row.update(pressed->run(control, quantity, goal));
          file.put("rows", values, row);
        }
    std::cerr << name << formatted(", surface %llu, %g %% in contact\n", static_cast<unsigned long long>(seed), contact);
  }
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0 : (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
}

// Of the rows with these values.
Json summary_of(const Json& rows, const Json& values) {
  std::int64_t runs = 0, within = 0, coarser = 0;
  std::vector<double> saved, slack;
  for (const Json& row : rows) {
    const bool of = std::all_of(values.items().begin(), values.items().end(),
                                [&](const auto& item) { return row.at(item.key()) == item.value(); });
    if (!of) continue;
    const double error = row.at("error").get<double>();
    ++runs;
    within += error <= row.at("goal").get<double>();
    saved.push_back(row.at("whole_seconds").get<double>() / row.at("seconds").get<double>());
    if (row.at("status") != "RC_WITHIN_GOAL") continue;
    ++coarser;
    if (error > 0) slack.push_back(row.at("estimate").get<double>() / error);
  }
  Json summary = values;
  summary.update({{"runs", runs}, {"within", within}, {"coarser", coarser}});
  if (runs > 0)
    summary.update({{"within_percent", 100.0 * static_cast<double>(within) / static_cast<double>(runs)},
                    {"speedup", median(saved)},
                    {"slack", median(slack)}});
  return summary;
}

const std::vector<Column> columns = {{"scene", "scene"},
                                     {"goal", "goal", "%g"},
                                     {"runs", "runs"},
                                     {"within goal", "within"},
                                     {"%", "within_percent"},
                                     {"on a coarser grid", "coarser"},
                                     {"estimate/error", "slack", "%.1f"},
                                     {"whole/this s", "speedup", "%.2f"}};

}  // namespace

void run_goal(const GoalRequest& request) {
  ResultFile file(request.file, "goal", request.threads);
  const std::vector<std::string> scenes = request.scenes.empty() ? pareto_scene_names() : request.scenes;
  for (const std::string& scene : scenes)
    for (std::int64_t seed = 1; seed <= (is_random_scene(scene) ? request.seeds : 1); ++seed)
      measure(request, file, scene, static_cast<std::uint64_t>(seed));
  const Json rows = file.document()["rows"];
  Json summaries = Json::array();
  for (const char* const control : controls)
    for (const char* const quantity : quantities) {
      Json part = Json::array();
      for (const std::string& scene : scenes)
        for (const double goal : request.goals)
          part.push_back(summary_of(rows, {{"control", control}, {"quantity", quantity}, {"scene", scene}, {"goal", goal}}));
      for (const double goal : request.goals) {
        Json all = summary_of(rows, {{"control", control}, {"quantity", quantity}, {"goal", goal}});
        all["scene"] = "all";
        part.push_back(all);
      }
      std::cout << "accuracy of the " << quantity << ", " << control << " control\n" << table(columns, part) << '\n';
      summaries.insert(summaries.end(), part.begin(), part.end());
    }
  Json all = summary_of(rows, Json::object());
  std::cout << all.at("within").get<std::int64_t>() << " of " << all.at("runs").get<std::int64_t>()
            << " runs within their goal\n";
  file.document()["summaries"] = summaries;
  file.document()["all"] = all;
  file.save();
}

}  // namespace bench

#include "case.h"

#include <roughcontact/history.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>

#include "draw.h"
#include "support/callers_product.h"
#include "support/registry.h"

namespace scenes {

namespace {

using pairs::check;

rc_system with_pointers(const Scene& scene) {
  rc_system system = scene.system;
  if (system.op == RC_OPERATOR_DENSE) {
    system.dense = scene.matrix.data();
    system.dense_ld = static_cast<std::int64_t>(scene.points());
  }
  if (system.op == RC_OPERATOR_CALLBACK) {
    system.apply = support::multiply;
    system.user = const_cast<double*>(scene.matrix.data());
  }
  return system;
}

// The greedy method is exact for some kernels only; factors of thousands of points take seconds; split takes cells up to four
// times as long as wide.
bool able(const pairs::Pair& pair, const Scene& scene, const rc_system& system, std::int32_t control) {
  if (pair.solver == "greedy" || (scene.large() && pairs::multiplies_often(pair))) return false;
  if ((pair.backend == "dense" || pair.backend == "cholmod") && scene.points() > 1500) return false;
  if (pair.backend == "split" && std::max(system.hx, system.hy) > 4 * std::min(system.hx, system.hy)) return false;
  return pairs::obstacle(pair, system, control).empty();
}

std::int32_t control_of(const Scene& scene) {
  return scene.control == RC_CONTROL_APPROACH ? RC_CONTROL_APPROACH : RC_CONTROL_LOAD;
}

pairs::Pair draw_pair(const Scene& scene, const rc_system& system) {
  Random random(scene.seed, 100);
  const double kind = random.uniform();
  const std::int32_t control = control_of(scene);
  static const std::vector<pairs::Pair> all = pairs::all_pairs();
  const pairs::Pair main{"haar-cg", "fft"};
  if (kind < 0.35 && able(main, scene, system, control)) return main;
  if (kind < 0.6) return pairs::automatic;
  std::vector<pairs::Pair> list;
  for (const pairs::Pair& pair : all)
    if (able(pair, scene, system, control)) list.push_back(pair);
  return list.empty() ? pairs::automatic : random.one_of(list);
}

// Options of the solver, which are at their defaults in most scenes.
pairs::Settings draw_solver_options(const Scene& scene, const std::string& solver) {
  static const std::map<std::string, std::vector<pairs::Settings>> all{
      {"nnls",
       {{{"nnls.pivoting", "single"}},
        {{"warmup", "gp"}, {"warmup.iterations", "50"}},
        {{"nnls.pivoting", "single"}, {"warmup", "gp"}}}},
      {"gp", {{{"gp.lipschitz", "frobenius"}}}},
      {"admm", {{{"admm.relaxation", "1"}}, {{"admm.rho", "1"}}}},
      {"haar-cg", {{{"haar-cg.products", "double"}}, {{"haar-cg.nested", "0"}}}}};
  Random random(scene.seed, 101);
  const auto found = all.find(solver);
  return found == all.end() || scene.large() || !random.chance(0.4) ? pairs::Settings{} : random.one_of(found->second);
}

}  // namespace

std::optional<pairs::Pair> Case::only;

Case::Case(std::uint64_t seed, bool reduced)
    : scene_(draw(seed, reduced)),
      system_(with_pointers(scene_)),
      h_(scene_),
      pair_(only && able(*only, scene_, system_, control_of(scene_)) ? *only : draw_pair(scene_, system_)),
      solver_options_(draw_solver_options(scene_, pair_.solver)),
      exact_(scene_.steps.size()),
      tied_(scene_.steps.size()) {
  const bool cmr = pair_.solver == "cmr";
  if (Random random(scene_.seed, 110); cmr) {
    constexpr std::array levels{"0", "2", "3"}, filters{"subsample", "mean", "max"};
    constexpr std::array inner{"auto", "nnls", "polonsky-keer", "haar-cg"};
    scene_.settings.insert(scene_.settings.end(), {{"cmr.levels", random.one_of(levels)},
                                                   {"cmr.filter", random.one_of(filters)},
                                                   {"cmr.area", random.chance(0.5) ? "side" : "diagonal"},
                                                   {"cmr.select", random.chance(0.5) ? "gap" : "influence"},
                                                   {"cmr.radius", pairs::text(random.uniform(1, 3))},
                                                   {"cmr.inner", random.one_of(inner)}});
  } else if (system_.op != RC_OPERATOR_CALLBACK && !scene_.large() && random.chance(0.1)) {
    scene_.settings.emplace_back("certify_backend", "dense");
  }
  answers_ = solve_all(open().get());
}

std::string Case::words() const {
  std::string words = scene_.words + ", " + pair_.name();
  for (const auto& [key, value] : solver_options_) words += ", " + key + " = " + value;
  return words;
}

pairs::Options Case::options(const pairs::Settings& changed) const {
  pairs::Settings all = scene_.settings;
  const bool own = std::ranges::find(changed, "solver", &std::pair<std::string, std::string>::first) == changed.end();
  if (own) all.insert(all.end(), solver_options_.begin(), solver_options_.end());
  all.insert(all.end(), changed.begin(), changed.end());
  return pairs::make_options(pair_, scene_.kernel, all);
}

Handle Case::open(const pairs::Settings& changed) const {
  rc_contact* made = nullptr;
  check(rc_contact_create(&system_, options(changed).get(), &made) == RC_OK,
        std::string("rc_contact_create: ") + rc_last_error());
  return Handle(made);
}

rc_step Case::step(const Step& asked) const {
  const Surface& surface = scene_.surfaces[asked.surface];
  rc_step step = RC_STEP_INIT;
  step.control = scene_.control;
  step.target = asked.target;
  step.warm_start = asked.warm;
  step.undeformed_gap = RC_IN(surface.gap.data());
  step.mask = RC_IN(surface.mask.empty() ? nullptr : surface.mask.data());
  step.p0 = RC_IN(asked.p0.empty() ? nullptr : asked.p0.data());
  return step;
}

StepAnswer Case::solve(rc_contact* contact, const Step& asked) const { return solve(contact, step(asked)); }

StepAnswer Case::solve(rc_contact* contact, const rc_step& step) const {
  StepAnswer answer;
  const std::size_t n = scene_.points();
  const bool hard = scene_.hard();
  const auto said = [&](Field& indentation) {
    indentation.resize(n);
    check(rc_contact_indentation(contact, RC_OUT(indentation.data())) == RC_OK, rc_last_error());
  };
  if (hard) said(answer.indentation);
  answer.p.assign(n, -7);
  answer.gap.assign(n, -7);
  static unsigned char filling = 0;  // what a result holds before does not matter
  std::memset(static_cast<void*>(&answer.result), filling += 73, sizeof answer.result);
  answer.result.struct_size = sizeof answer.result;
  answer.result.p = RC_OUT(answer.p.data());
  answer.result.gap = RC_OUT(answer.gap.data());
  const rc_result before = answer.result;
  answer.status = rc_contact_solve(contact, &step, &answer.result);
  answer.message = rc_last_error();
  if (answer.status < 0) {
    check(std::memcmp(&answer.result, &before, sizeof before) == 0, "a refused step writes its result");
    answer.result = RC_RESULT_INIT;
  }
  answer.result.p = answer.result.gap = rc_array{};
  if (hard) said(answer.indentation_after);
  return answer;
}

std::vector<StepAnswer> Case::solve_all(rc_contact* contact) const {
  std::vector<StepAnswer> answers;
  for (std::size_t k = 0; k < scene_.steps.size(); ++k) {
    rc_step given = step(scene_.steps[k]);
    const std::uint64_t kind = (scene_.seed + k) % 3;
    if (k > 0 && kind > 0 && scene_.steps[k].surface == scene_.steps[k - 1].surface) {  // those of the step before
      given.undeformed_gap.data = nullptr;
      if (kind == 1) given.mask.data = nullptr;
    }
    answers.push_back(solve(contact, given));
    if (answers.back().status != RC_OK) break;
  }
  return answers;
}

Exact Case::exact_of(const StepAnswer& answer, const Surface& surface, bool tied) const {
  return exact_at(scene_, h_, surface, answer.indentation, answer.result.approach,
                  tied ? std::optional(answer.result.load) : std::nullopt);
}

const Exact& Case::exact(std::size_t k, bool tied) const {
  tied = tied && scene_.periodic() && scene_.control != RC_CONTROL_APPROACH;
  std::optional<Exact>& kept = tied ? tied_[k] : exact_[k];
  if (!kept) kept = exact_of(answers_[k], surface(k), tied);
  return *kept;
}

rc_state state_after(const std::vector<StepAnswer>& answers, std::size_t k, const Surface& surface, bool before) {
  rc_state state = RC_STATE_INIT;
  const StepAnswer& last = answers[k];
  state.undeformed_gap = RC_IN(surface.gap.data());
  state.mask = RC_IN(surface.mask.empty() ? nullptr : surface.mask.data());
  state.p = RC_IN(last.p.data());
  state.approach = last.result.approach;
  state.load = last.result.load;
  state.indentation = RC_IN(last.indentation_after.empty() ? nullptr : last.indentation_after.data());
  if (!before) return state;
  state.p_before = RC_IN(answers[k - 1].p.data());
  state.approach_before = answers[k - 1].result.approach;
  state.load_before = answers[k - 1].result.load;
  return state;
}

Real Case::cap() const {
  return scene_.hard() ? static_cast<Real>(scene_.system.hardness) : std::numeric_limits<Real>::infinity();
}

double load_of(const Scene& scene, double target) {
  return scene.control == RC_CONTROL_PRESSURE ? target * static_cast<double>(scene.points()) * scene.cell_area() : target;
}

Real residual_scale(const Scene& scene, const Surface& surface, const StepAnswer& answer, double target) {
  Real lowest = HUGE_VALL, sum = 0;
  bool whole = true;
  for (std::size_t i = 0; i < scene.points(); ++i) {
    whole = whole && surface.included(i);
    if (!surface.included(i)) continue;
    const Real gap =
        static_cast<Real>(surface.gap[i]) + (answer.indentation.empty() ? 0 : static_cast<Real>(answer.indentation[i]));
    lowest = std::min(lowest, gap);
    sum += gap;
  }
  const Real n = static_cast<Real>(scene.points()), approach = static_cast<Real>(answer.result.approach),
             compression = std::max<Real>(0, approach - lowest);
  if (!scene.periodic()) return compression;
  if (scene.control != RC_CONTROL_APPROACH) {
    const double load = scene.by_load() ? load_of(scene, target) : answer.result.load;
    return std::max(compression, static_cast<Real>(load / std::sqrt(scene.cell_area()) / scene.system.modulus) / n / 4);
  }
  const Real mean_gap = std::abs(sum / n - approach);
  return !whole || mean_gap == 0 ? compression : std::min(compression, mean_gap / (2 * static_cast<Real>(scene.tol)));
}

Real product_noise(const Case& c, const Surface& surface, const StepAnswer& answer) {
  Real most = 0, highest = std::abs(static_cast<Real>(answer.result.approach));
  for (std::size_t i = 0; i < answer.p.size(); ++i) {
    most = std::max(most, std::abs(static_cast<Real>(answer.p[i])));
    if (surface.included(i)) highest = std::max(highest, std::abs(static_cast<Real>(surface.gap[i])));
    if (!answer.indentation.empty()) highest = std::max(highest, static_cast<Real>(answer.indentation[i]));
  }
  const Real relative = c.pair().backend == "split" ? split_product : double_product;
  return relative * c.h().largest_row() * most + 2e-15L * highest;
}

}  // namespace scenes

// The bounds that results prove, compared with trusted and exact solutions.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

#include "comparison.h"
#include "scenes.h"
#include "support/reference_cases.h"
#include "support/surfaces.h"

namespace pairs {

namespace {

// Intervals around the reference cases' loads and counts.
void holds_on_a_case(const ReferenceCase& reference, const char* backend) {
  const Answer answer = solved(reference.problem, {"auto", backend}, {{RC_OPT_TOL, "1e-10"}});
  const rc_result& r = answer.result;
  check(r.load_lower <= reference.load * (1 + 1e-11) && reference.load * (1 - 1e-11) <= r.load_upper,
        "load " + text(reference.load) + " is not in " + text(r.load_lower) + " .. " + text(r.load_upper));
  const double area = static_cast<double>(reference.contacts) * reference.problem.cell_area();
  if (reference.count_is_robust)
    check(r.area_lower <= area * (1 + 1e-12) && area <= r.area_upper * (1 + 1e-12),
          "area " + text(area) + " is not in " + text(r.area_lower) + " .. " + text(r.area_upper));
  check(r.load_upper - r.load_lower <= 1e-5 * std::abs(r.load) + 1e-300,
        "the load interval is wide: " + text(r.load_upper - r.load_lower));
}

int scenes_wanted() {
  const char* wanted = std::getenv("RC_BOUNDS_SCENES");
  return wanted && *wanted ? std::atoi(wanted) : quick() ? 60 : 400;
}

// Loose answers in random scenes.
void nothing_is_violated() {
  const int scenes = scenes_wanted();
  int answers = 0, no_solution = 0, inexact = 0;
  std::map<int, std::vector<Tightness>> by_size;
  for (int k = 0; k < scenes; ++k) {
    std::mt19937 generator(static_cast<unsigned>(k));
    const Scene scene = random_scene(generator, k % 50 == 0 ? 40 : k % 5 == 0 ? 20 : 9);
    const Answer exact = exact_at(scene.problem, scene.problem.target);
    check(exact.status >= 0, scene.name + ": " + exact.message);
    const bool fft = scene.problem.system.op == RC_OPERATOR_HALFSPACE && k % 2 == 0;
    const Contact contact(scene.problem, {"auto", fft ? "fft" : "dense"});
    for (int repeat = 0; repeat < 4; ++repeat) {
      const int digits = 1 + static_cast<int>(generator() % 10);
      const Field p = perturbed(scene.problem, exact.p, std::pow(10, -digits), generator);
      Problem problem = scene.problem;
      if (repeat == 3) problem = at_load(problem, exact.result.load);
      const Answer answer = contact.certify(problem.step(), p);
      const std::string what = "scene " + std::to_string(k) + " (" + scene.name + "), perturbation 1e-" + std::to_string(digits);
      check(answer.status >= 0, what + ": " + answer.message);
      const Answer same_approach = repeat == 3 ? exact_at(problem, answer.result.approach) : exact;
      ++answers;
      if (same_approach.status < 0) {
        ++no_solution;
        check(answer.result.load_lower == 0 && std::isinf(answer.result.load_upper) && answer.result.proven_contacts == 0,
              what + ": proven although no solution exists");
        continue;
      }
      if (same_approach.worst_residual() > 1e-12) {
        ++inexact;
        continue;
      }
      try {
        check_proofs(problem, answer, same_approach);
      } catch (const Failure& failure) {
        throw Failure(what + ": " + failure.what());
      }
      if (same_approach.result.contacts > 0 && std::isfinite(answer.result.load_upper))
        by_size[digits].push_back(tightness(answer, same_approach));
    }
  }
  report(std::to_string(answers) + " answers in " + std::to_string(scenes) + " scenes, no violation; " +
         std::to_string(no_solution) + " without a solution at their approach, " + std::to_string(inexact) +
         " left out because their exact solution is not known to 1e-12");
  check(inexact * 100 <= answers, "too many answers are left out");
  for (auto& [digits, answers_of_size] : by_size) {
    const auto median = [&all = answers_of_size](auto member) {
      std::ranges::nth_element(all, all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2), {}, member);
      return text(all[all.size() / 2].*member);
    };
    report("perturbation 1e-" + std::to_string(digits) + ": medians of load half-width / load error " + median(&Tightness::load) +
           ", undecided / contacts " + median(&Tightness::undecided));
  }
}

void few_points_are_undecided(const Problem& problem, const Pair& pair) {
  const Answer answer = solved(problem, pair, {{RC_OPT_TOL, "1e-10"}});
  const rc_result& r = answer.result;
  report("contacts " + std::to_string(r.contacts) + " proven " + std::to_string(r.proven_contacts) + " undecided " +
         std::to_string(r.undecided) + ", load interval " + text((r.load_upper - r.load_lower) / r.load) + " of the load, gap " +
         text(r.duality_gap / std::abs(r.energy)) + " of the energy, " + r.solver + "*" + r.backend);
  check(static_cast<double>(r.undecided) <= 0.01 * static_cast<double>(r.contacts), "too many are undecided");
  check((r.load_upper - r.load_lower) <= 1e-6 * r.load, "the load interval is wide");
}

// White noise and waves: contact in many small spots.
Problem noisy(std::int64_t n, std::int32_t boundary, double share) {
  Problem problem = rough_problem(n, n, boundary);
  std::mt19937 generator(5);
  for (double& value : problem.gap) value += 0.3 * uniform(generator);
  problem.target =
      problem.lowest_gap() + share * (sum(problem.gap) / static_cast<double>(problem.points()) - problem.lowest_gap());
  return problem;
}

bool unknown(const rc_result& r) {
  return std::isnan(r.duality_gap) && std::isnan(r.load_lower) && std::isnan(r.load_upper) && std::isnan(r.area_lower) &&
         std::isnan(r.area_upper) && r.proven_contacts == -1 && r.proven_open == -1 && r.undecided == -1;
}

void unknown_where_nothing_is_proven() {
  const Problem problem = rough_problem(9, 8);
  check(unknown(solved(problem, automatic, {{RC_OPT_BOUNDS, "0"}}).result), "bounds=0");
  check(!unknown(solved(problem, automatic).result), "bounds=1");

  Problem product = problem;
  product.system.op = RC_OPERATOR_CALLBACK;
  product.system.apply = [](const double* x, double* y, std::int64_t n, void*) {
    for (std::int64_t i = 0; i < n; ++i) y[i] = (1 + static_cast<double>(i % 3)) * x[i];
    return 0;
  };
  check(unknown(solved(product, automatic).result), "a caller's product");
}

void bounds_cost_no_product() {
  for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC}) {
    const Problem problem = rough_problem(17, 16, boundary);
    const Answer with = solved(problem, {"auto", "fft"}), without = solved(problem, {"auto", "fft"}, {{RC_OPT_BOUNDS, "0"}});
    check_equal(with.result.products, without.result.products, "products");
    check_same(with.p, without.p, "pressures");
  }
}

void full_periodic_contact_has_no_upper_bound() {
  Problem problem = rough_problem(12, 10, RC_BOUNDARY_PERIODIC);
  const Answer answer = solved(at_load(problem, 1e4), automatic);
  const rc_result& r = answer.result;
  check_equal(r.contacts, r.points, "contacts");
  check(std::isnan(r.duality_gap) && r.load_lower == 0 && std::isinf(r.load_upper), "load bounds");
  check_equal(r.proven_contacts, 0, "proven_contacts");
  check_equal(r.undecided, r.points, "undecided");
  check_near(r.area_upper, r.contact_area, 1e-12 * r.contact_area, "area_upper");
}

void nothing_touches() {
  Problem problem = rough_problem(6, 5);
  problem.target = problem.lowest_gap() - 1;
  const rc_result r = solved(problem, automatic).result;
  check(r.duality_gap == 0 && r.load_lower == 0 && r.load_upper == 0 && r.area_upper == 0, "bounds");
  check_equal(r.proven_open, r.points, "proven_open");
}

std::vector<Test> all_tests() {
  std::vector<Test> tests{{"no_statement_is_violated_in_random_scenes", nothing_is_violated},
                          {"unknown_where_nothing_is_proven", unknown_where_nothing_is_proven},
                          {"bounds_cost_no_product", bounds_cost_no_product},
                          {"full_periodic_contact_has_no_upper_bound", full_periodic_contact_has_no_upper_bound},
                          {"nothing_touches", nothing_touches}};
  const std::int64_t n = quick() ? 64 : 256;
  const auto tight = [&](const std::string& name, const Problem& problem, const Pair& pair) {
    tests.push_back({"few_points_are_undecided/" + name, [=] { few_points_are_undecided(problem, pair); }});
  };
  const Pair by_transforms{"auto", "fft"};
  tight("waves", rough_problem(n, n), by_transforms);
  tight("waves_periodic", rough_problem(n, n, RC_BOUNDARY_PERIODIC), by_transforms);
  tight("noise_light", noisy(n, RC_BOUNDARY_FREE, 0.3), by_transforms);
  tight("noise_heavy", noisy(n, RC_BOUNDARY_FREE, 0.9), by_transforms);
  tight("noise_periodic_light", noisy(n, RC_BOUNDARY_PERIODIC, 0.3), by_transforms);
  tight("noise_periodic_heavy", noisy(n, RC_BOUNDARY_PERIODIC, 0.9), by_transforms);
  Problem oblong = noisy(n / 2, RC_BOUNDARY_FREE, 0.5);
  oblong.system.hy = 10;
  tight("noise_oblong_cells", oblong, by_transforms);

  const auto reference = read_reference_cases();
  for (const ReferenceCase& each : reference.cases) {
    for (const char* backend : {"dense", "fft"})
      if (each.candidates <= 3000 || std::string(backend) == "fft")
        tests.push_back({"intervals_hold/" + each.name + "/" + backend, [=] { holds_on_a_case(each, backend); }});
    if (each.name.starts_with("m02") || each.name.starts_with("m04") || each.name.starts_with("m06") ||
        each.name.starts_with("l01"))
      tight(each.name, each.problem, {"auto", "auto"});
  }
  return tests;
}

}  // namespace

}  // namespace pairs

int main(int argc, char** argv) { return pairs::run_group("bounds.intervals", pairs::all_tests(), argc, argv); }

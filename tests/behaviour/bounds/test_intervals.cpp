// The bounds that results prove: narrow, free of cost, and none where nothing is proven.
#include <algorithm>
#include <cmath>
#include <random>

#include "support/reference_cases.h"
#include "support/surfaces.h"

namespace pairs {

namespace {

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
  for (double& value : problem.gap) value += 0.3 * static_cast<double>(generator()) / 4294967296.0;
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
  std::vector<Test> tests = RC_TESTS(unknown_where_nothing_is_proven, bounds_cost_no_product,
                                     full_periodic_contact_has_no_upper_bound, nothing_touches);
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
  for (const ReferenceCase& each : reference.cases)
    if (each.name.starts_with("m02") || each.name.starts_with("m04") || each.name.starts_with("m06") ||
        each.name.starts_with("l01"))
      tight(each.name, each.problem, {"auto", "auto"});
  return tests;
}

}  // namespace

}  // namespace pairs

int main(int argc, char** argv) { return pairs::run_group("bounds.intervals", pairs::all_tests(), argc, argv); }

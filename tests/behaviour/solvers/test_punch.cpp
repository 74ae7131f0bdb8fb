// The stiffness of a flat punch on given points: against a step's own, against what is known exactly, and within its interval.
#include <roughcontact/analysis.h>

#include <cmath>
#include <random>
#include <string>

#include "support/contact.h"
#include "support/registry.h"
#include "support/surfaces.h"

namespace pairs {

namespace {

constexpr std::int32_t boundaries[] = {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC};
const Pair by_factors{"nnls", "dense"}, by_products{"haar-cg", "fft"};

struct Punch {
  double stiffness = -7, lower = -7, upper = -7;
};

Punch pressed(const Problem& problem, const std::vector<std::uint8_t>& mask, const Pair& pair, const Settings& settings = {}) {
  Punch punch;
  const rc_status status =
      rc_punch_stiffness(&problem.system, RC_IN(mask.empty() ? nullptr : mask.data()),
                         make_options(pair, problem.kernel, settings).get(), &punch.stiffness, &punch.lower, &punch.upper);
  check(status == RC_OK, rc_last_error());
  return punch;
}

std::vector<std::uint8_t> touching(const Answer& answer) {
  std::vector<std::uint8_t> mask;
  for (const double p : answer.p) mask.push_back(p > 0);
  return mask;
}

void check_interval(const Punch& punch, double exact, const std::string& what) {
  check(punch.lower <= exact * (1 + 1e-13) && exact <= punch.upper * (1 + 1e-13),
        what + ": " + text(exact) + " is not in " + text(punch.lower) + " .. " + text(punch.upper));
  check(punch.lower <= punch.stiffness && punch.stiffness <= punch.upper, what + ": the value is outside its interval");
  check(punch.upper - punch.lower <= 1e-6 * punch.upper, what + ": the interval is wide");
}

void a_contact_set_has_its_steps_stiffness() {
  for (const std::int32_t boundary : boundaries)
    for (const char* kernel : {"love", "eq9", "galerkin", "spectral"}) {
      if ((boundary == RC_BOUNDARY_PERIODIC) != (std::string(kernel) == "spectral")) continue;
      Problem problem = rough_problem(30, 26, boundary, 0.5, std::string(kernel) == "eq9" ? 0.5 : 0.75);
      problem.kernel = kernel;
      const Answer answer = solved(problem, by_factors, {{RC_OPT_STIFFNESS, "1"}});
      const double exact = answer.result.stiffness;
      for (const Pair& pair : {by_factors, by_products, automatic}) {
        const Punch punch = pressed(problem, touching(answer), pair, {{RC_OPT_TOL, "1e-9"}});
        check_near(punch.stiffness, exact, 1e-9 * exact, kernel + (", " + pair.name()));
        check_interval(punch, exact, kernel + (", " + pair.name()));
      }
    }
}

void a_hardness_does_not_count() {
  Problem problem = rough_problem(24, 20);
  const std::vector<std::uint8_t> mask = touching(solved(problem, automatic));
  const double elastic = pressed(problem, mask, automatic).stiffness;
  problem.system.hardness = 1e-9;
  check(pressed(problem, mask, automatic).stiffness == elastic, "the same bits");
}

// A ring, and points that pull: the sum of pressures of any sign.
void it_grows_with_the_set() {
  for (const std::int32_t boundary : boundaries) {
    const Problem problem = rough_problem(20, 16, boundary, 0.5, 0.75);
    std::mt19937 random(3);
    std::vector<std::uint8_t> mask(problem.points());
    double before = 0;
    for (int k = 0; k < 12; ++k) {
      for (int added = 0; added < 9; ++added) mask[random() % mask.size()] = 1;
      const Punch exact = pressed(problem, mask, by_factors), punch = pressed(problem, mask, by_products);
      check(exact.stiffness > before, "it does not grow");
      check_near(punch.stiffness, exact.stiffness, 1e-9 * exact.stiffness, "stiffness");
      check_interval(punch, exact.stiffness, "a random set");
      before = exact.stiffness;
    }
  }
}

void known_sets() {
  for (const std::int32_t boundary : boundaries)
    for (const Pair& pair : {by_factors, by_products, automatic}) {
      const Problem problem = rough_problem(24, 24, boundary);
      const bool periodic = boundary == RC_BOUNDARY_PERIODIC;
      std::vector<std::uint8_t> mask(problem.points());
      const Punch none = pressed(problem, mask, pair);
      check(none.stiffness == 0 && none.lower == 0 && none.upper == 0, "no point");
      const Punch all = pressed(problem, {}, pair);
      if (periodic) {
        check(std::isinf(all.stiffness) && std::isinf(all.lower) && std::isinf(all.upper), "all points of a period");
      } else {
        // The constant of a square flat punch is 2 a E* 1.1525..., which cells of this size miss by about 1 %.
        check_near(all.stiffness, 1.1525 * 24, 0.03 * 1.1525 * 24, "a square punch");
        const Answer pressed_flat = solved(problem, automatic, {{RC_OPT_STIFFNESS, "1"}});
        check_near(all.stiffness, pressed_flat.result.punch_stiffness, 0.03 * all.stiffness, "the whole grid's");
      }
      mask.assign(mask.size(), 1);
      mask[5] = 0;
      const Punch most = pressed(problem, mask, pair);
      check(most.stiffness > 0 && std::isfinite(most.stiffness), "all but one");
      check(periodic ? most.stiffness > 5 * 24 : most.stiffness < all.stiffness, "all but one point");
      mask.assign(mask.size(), 0);
      mask[100] = 1;
      double entry = 0;
      check(rc_kernel_coefficients("love", 1, 1, 1, 1, &entry) == RC_OK, rc_last_error());
      if (!periodic) check_near(pressed(problem, mask, pair).stiffness, 1 / entry, 1e-12 / entry, "one point");
    }
}

// The stiffness of all but few points of a period is large, and keeps the tolerance: that of punches, and of steps whose surface
// has few deep pits.
void few_points_of_a_period_are_left_out() {
  std::mt19937 random(11);
  for (const auto& [nx, ny] : {std::pair<std::int64_t, std::int64_t>{24, 17}, {38, 31}, {5, 37}})
    for (std::size_t open = 1; open <= 3; ++open) {
      Problem problem = rough_problem(nx, ny, RC_BOUNDARY_PERIODIC, 0.5, 0.75);
      problem.gap.assign(problem.points(), 0);
      std::vector<std::uint8_t> mask(problem.points(), 1);
      for (std::size_t k = 0; k < open; ++k) mask[random() % mask.size()] = 0;
      for (std::size_t i = 0; i < mask.size(); ++i) problem.gap[i] = mask[i] ? 0 : 30;
      problem.control = RC_CONTROL_LOAD;
      problem.target = problem.cell_area() * static_cast<double>(problem.points());
      const double exact = pressed(problem, mask, by_factors).stiffness;
      for (const double tol : {6e-2, 1e-3, 1e-4, 3e-5, 1e-6}) {
        const Settings settings{{RC_OPT_TOL, text(tol)}};
        const Punch punch = pressed(problem, mask, by_products, settings);
        check_near(punch.stiffness, exact, tol * exact, "a punch, tol " + text(tol));
        check(punch.lower <= exact && exact <= punch.upper, "the exact one is outside the interval of a punch");
        for (const char* wanted : {"1", "2"}) {
          Settings with = settings;
          with.emplace_back(RC_OPT_STIFFNESS, wanted);
          const Answer answer = solved(problem, by_products, with);
          check(touching(answer) == mask, "other points are open");
          check_near(answer.result.stiffness, exact, tol * exact, "a step, tol " + text(tol));
        }
      }
    }
}

void other_operators() {
  const Field H = {2, 0.5, 0.25, 0.5, 2, 0.5, 0.25, 0.5, 4};
  Problem problem;
  problem.system.op = RC_OPERATOR_DENSE;
  problem.system.nx = 3;
  problem.system.ny = 1;
  problem.system.dense = H.data();
  problem.system.dense_ld = 3;
  // The stiffness on points 0 and 2 is the sum of the entries of the inverse of (2 .25; .25 4).
  const double exact = (4 + 2 - 2 * 0.25) / (2 * 4 - 0.25 * 0.25);
  const Punch punch = pressed(problem, {1, 0, 1}, by_factors);
  check_near(punch.stiffness, exact, 1e-14, "a matrix");
  check_interval(punch, exact, "a matrix");
  problem.system.op = RC_OPERATOR_CALLBACK;
  problem.system.user = const_cast<double*>(H.data());
  problem.system.apply = [](const double* x, double* y, std::int64_t n, void* user) {
    const auto* const matrix = static_cast<const double*>(user);
    for (std::int64_t i = 0; i < n; ++i) {
      y[i] = 0;
      for (std::int64_t j = 0; j < n; ++j) y[i] += matrix[i * n + j] * x[j];
    }
    return std::int32_t{0};
  };
  check_near(pressed(problem, {1, 0, 1}, {"polonsky-keer", "callback"}).stiffness, exact, 1e-9, "a product");
}

// Nothing is written by a call that is stopped.
void a_time_limit_stops_it() {
  const Problem problem = rough_problem(256, 256);
  Punch punch;
  check_equal(
      rc_punch_stiffness(&problem.system, {}, make_options(by_products, problem.kernel, {{RC_OPT_TIME_LIMIT, "1e-9"}}).get(),
                         &punch.stiffness, &punch.lower, nullptr),
      RC_STOP_TIME, "status");
  check(punch.stiffness == -7 && punch.lower == -7, "something is written");
}

}  // namespace

}  // namespace pairs

int main(int argc, char** argv) {
  using namespace pairs;
  return run_group("solvers.punch",
                   RC_TESTS(a_contact_set_has_its_steps_stiffness, a_hardness_does_not_count, it_grows_with_the_set, known_sets,
                            few_points_of_a_period_are_left_out, other_operators, a_time_limit_stops_it),
                   argc, argv);
}

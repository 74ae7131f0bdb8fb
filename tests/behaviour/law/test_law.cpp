// Values of a law. What is refused is in the table of errors.
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <random>
#include <thread>

#include "patches.h"
#include "support/naive.h"

namespace {

using namespace laws;
using pairs::check;
using pairs::check_equal;
using pairs::text;

void slope_energy_and_inverse_belong_to_the_pressure() {
  const rc_law* const law = usual_law();
  for (const double x : overclosures(law)) {
    double p = 0, slope = 0, energy = 0, back = 0, above = 0, more = 0;
    const rc_status status = rc_law_pressure(law, x, &p, &slope, &energy);
    check_equal(status, x > describe(law).x_upper ? RC_OUTSIDE : RC_OK, "status at " + text(x));
    check(rc_law_overclosure(law, p, &back) == status, "status of the inverse");
    if (x > 0 && p > 0) check(std::abs(back / x - 1) < 1e-10, "the inverse of " + text(x) + " is " + text(back));
    const double step = 1e-6 * std::abs(x) + 1e-12;
    rc_law_pressure(law, x + step, &above, nullptr, &more);
    check(std::abs((more - energy) - step * (p + above) / 2) <= 1e-6 * step * above + 1e-15 * more, "energy at " + text(x));
    check(above >= p && slope >= 0, "p falls at " + text(x));
    const rc_law_point point = evaluate(law, x);
    check(point.p == p && point.slope == slope && point.energy == energy, "rc_law_evaluate");
    check(point.p_lower <= p * (1 + 1e-14) && p <= point.p_upper * (1 + 1e-14), "p leaves its bounds at " + text(x));
    double conductance = 0;
    check(rc_law_gap_conductance(law, p, 1, 1, &conductance) >= 0, "conductance");
    if (x > 0) check(std::abs(conductance - point.conductance / 2) <= 1e-9 * conductance, "conductance at " + text(x));
  }
  std::vector<double> xs = overclosures(law), p(xs.size()), slope(xs.size()), energy(xs.size());
  check_equal(rc_law_pressures(law, static_cast<std::int64_t>(xs.size()), RC_IN(xs.data()), RC_OUT(p.data()),
                               RC_OUT(slope.data()), RC_OUT(energy.data())),
              RC_OUTSIDE, "n");
  for (std::size_t i = 0; i < xs.size(); ++i) check(p[i] == evaluate(law, xs[i]).p, "rc_law_pressures");
}

void nodes_are_on_the_curve_and_few() {
  const LawHandle law = made(usual_patch(64));
  const rc_law_info info = describe(law.get());
  check_equal(info.bounds, RC_LAW_CONVEX, "bounds");
  check(info.nodes <= 110, std::to_string(info.nodes) + " nodes");
  check(info.width <= 1e-3 && info.energy_error < 1e-3, "width " + text(info.width) + ", energy " + text(info.energy_error));
  rc_law_point before = RC_LAW_POINT_INIT;
  for (std::int64_t i = 0; i < info.nodes; ++i) {
    rc_law_point node = RC_LAW_POINT_INIT;
    check_equal(rc_law_describe_node(law.get(), i, &node), RC_OK, "node");
    const rc_law_point point = evaluate(law.get(), node.x);
    check(std::abs(point.p - node.p) <= 1e-12 * node.p, "p of node " + std::to_string(i));
    check(i < 1 || (point.slope >= node.slope * (1 - 1e-6) && point.slope <= node.between_upper * (1 + 1e-6)),
          "slope of node " + std::to_string(i));
    check(i == 0 || (node.x > before.x && node.p > before.p && node.slope >= before.slope * (1 - 1e-6)), "order of nodes");
    before = node;
  }
  Patch few = usual_patch(16);
  few.spec.max_nodes = 10;
  const MadeLaw stopped = make(few);
  check_equal(stopped.status, RC_STOP_MAX_ITER, stopped.message);
  check(stopped.law && describe(stopped.law.get()).nodes <= 10, "the law made so far");
}

void the_conductance_is_as_exact_as_asked() {
  Patch patch = usual_patch(32);
  patch.spec.tolerance_conductance = 0.01;
  const LawHandle law = made(patch);
  int wide = 0;
  for (std::int64_t i = 1; i + 1 < describe(law.get()).nodes; ++i) {
    rc_law_point node = RC_LAW_POINT_INIT, next = RC_LAW_POINT_INIT;
    rc_law_describe_node(law.get(), i, &node), rc_law_describe_node(law.get(), i + 1, &next);
    if ((node.between_upper / node.between_lower - 1) / 2 <= 0.01) continue;
    ++wide;  // a jump: enclosed by a short interval
    check(next.x - node.x <= 1e-4 * node.x, "an interval is wide and long");
  }
  pairs::report(std::to_string(describe(law.get()).nodes) + " nodes, " + std::to_string(wide) + " jumps");
}

// Neighbours that pull give an inverse of H with positive entries: then contact sets need not grow.
void a_matrix_is_proven_by_the_signs_of_its_inverse() {
  constexpr std::int64_t side = 5, n = side * side;
  for (const bool smooth : {false, true}) {
    Patch patch = usual_patch(16);
    pairs::Problem& problem = patch.problem;
    problem.gap.resize(n);
    problem.gap[n / 2] = 0;
    problem.system.boundary = RC_BOUNDARY_FREE;
    problem.system.nx = problem.system.ny = side;
    problem.kernel = "love";
    pairs::Field matrix = pairs::influence_matrix(problem);
    for (std::int64_t i = 0; i < n && smooth; ++i)
      for (std::int64_t j = 0; j < n; ++j) {
        const auto dx = static_cast<double>(i % side - j % side), dy = static_cast<double>(i / side - j / side);
        matrix[static_cast<std::size_t>(i * n + j)] = std::exp(-(dx * dx + dy * dy) / 4) + (i == j ? 0.05 : 0);
      }
    problem.system.op = RC_OPERATOR_DENSE;
    problem.system.boundary = 0;
    problem.system.modulus = 0;
    problem.system.dense = matrix.data();
    problem.system.dense_ld = n;
    problem.kernel = "auto";
    for (const double hardness : {0.0, 0.02, HUGE_VAL}) {
      problem.system.hardness = hardness;
      const MadeLaw law = make(patch);
      check_equal(law.status, smooth ? RC_UNCERTIFIED : RC_OK, law.message);
      const bool plastic = hardness == 0.02;
      const rc_law_info info = describe(law.law.get());
      pairs::check_near(info.hardness, plastic ? hardness : 0, 0, "hardness");
      check_equal(info.bounds, smooth ? RC_LAW_MONOTONE : plastic ? RC_LAW_SLOPES : RC_LAW_CONVEX, "bounds");
    }
  }
}

// With the mean gap as overclosure: a load at which all points in contact carry the hardness, and all points.
void level_stretches_with_a_mean_gap() {
  Patch patch = usual_patch(16);
  pairs::Problem& problem = patch.problem;
  problem.system.boundary = RC_BOUNDARY_FREE;
  problem.system.nx = 5, problem.system.ny = 4;
  problem.system.hardness = 0.01;
  problem.gap.assign(20, 3);
  problem.gap[6] = 0, problem.gap[13] = 0.5;
  patch.spec.p_lower = 0.01 / 20, patch.spec.p_upper = 0.02 / 20;
  const LawHandle law = made(patch);
  check(std::abs(describe(law.get()).p_upper / patch.spec.p_upper - 1) < 1e-9, "p_upper");
  patch.spec.p_upper = 0.01;
  const MadeLaw all = make(patch);
  check_equal(all.status, RC_ERR_INFEASIBLE, all.message);
  check(all.message.find("all 20 points carry the hardness 0.01: the mean gap does not change any more; lower p_upper") !=
            std::string::npos,
        all.message);
}

constexpr int crowd = 8;

// NaN if the name stands for another law as well.
double evaluated_often(const rc_law* law) {
  double sum = 0;
  for (const double x : overclosures(law)) {
    const rc_law_point point = evaluate(law, x);
    double back = 0;
    const rc_law* same = nullptr;
    sum += rc_law_overclosure(law, point.p, &back) >= 0 ? back + point.p + point.slope + point.energy + point.area_upper : NAN;
    if (rc_law_open("of eight threads", nullptr, &same) != RC_OK || same != law) sum = NAN;
  }
  return sum;
}

void eight_threads_evaluate_one_law() {
  const LawHandle law = made(usual_patch(24));
  const std::string path =
      (std::filesystem::temp_directory_path() / ("of-eight-threads-" + std::to_string(std::random_device()()) + ".law")).string();
  pairs::check_equal(rc_law_save(law.get(), path.c_str()), RC_OK, "save");
  std::array<double, crowd> sums{};
  std::vector<std::thread> threads;
  for (double& sum : sums)
    threads.emplace_back([&sum, &path] {
      const rc_law* opened = nullptr;
      if (rc_law_open("of eight threads", path.c_str(), &opened) == RC_OK) sum = evaluated_often(opened);
    });
  for (std::thread& thread : threads) thread.join();
  std::filesystem::remove(path);
  for (const double sum : sums) check(sum > 0 && sum == sums[0], "threads disagree");
}

}  // namespace

int main(int argc, char** argv) {
  return pairs::run_group("law",
                          {{"slope, energy and inverse belong to the pressure", slope_energy_and_inverse_belong_to_the_pressure},
                           {"nodes are on the curve and few", nodes_are_on_the_curve_and_few},
                           {"the conductance is as exact as asked", the_conductance_is_as_exact_as_asked},
                           {"a matrix is proven by the signs of its inverse", a_matrix_is_proven_by_the_signs_of_its_inverse},
                           {"level stretches with a mean gap", level_stretches_with_a_mean_gap},
                           {"eight threads evaluate one law", eight_threads_evaluate_one_law}},
                          argc, argv);
}

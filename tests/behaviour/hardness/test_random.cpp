// Random scenes with a hardness: solver, backend, boundary, control, mask, cells and a history of some steps. Each answer must be
// certified, be that of a dense active set, and lie within the intervals that it proves. RC_HARDNESS_SCENES: how many (300).
#include <roughcontact/history.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

#include "active_set.h"
#include "capped_cases.h"
#include "support/registry.h"
#include "support/surfaces.h"

namespace pairs {

namespace {

constexpr double tol = 1e-9;

const double reaches[] = {1, 2, 20}, nearly_all[] = {1e-6, 0.9999, 1 - 1e-9, 1};

struct Scene {
  Problem problem;
  Pair pair;
  Field targets;
  std::string text;
};

class Draw {
 public:
  explicit Draw(std::uint64_t number) : random_(number) {}
  double real(double low, double high) { return low + (high - low) * std::generate_canonical<double, 53>(random_); }
  double logarithmic(double low, double high) { return std::exp(real(std::log(low), std::log(high))); }
  std::int64_t integer(std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(random_() % static_cast<std::uint64_t>(high - low + 1));
  }
  template <class List> auto one_of(const List& list) { return list[static_cast<std::size_t>(random_() % std::size(list))]; }

 private:
  std::mt19937_64 random_;
};

Scene scene_of(std::uint64_t number) {
  Draw draw(number);
  Scene scene;
  const bool periodic = draw.integer(0, 2) == 0;
  const std::int64_t nx = draw.integer(periodic ? 3 : 1, 9), ny = draw.integer(periodic ? 3 : 1, 9);
  const double scale = draw.logarithmic(1e-6, 1e3), aspect = draw.logarithmic(0.5, 2);
  Problem& problem = scene.problem;
  problem = rough_problem(nx, ny, periodic ? RC_BOUNDARY_PERIODIC : RC_BOUNDARY_FREE, scale, scale * aspect);
  problem.system.modulus = draw.logarithmic(1e-3, 1e12);
  const double height = scale * draw.logarithmic(1e-4, 1);
  for (double& value : problem.gap) value = height * draw.real(0, 1) * (draw.integer(0, 5) == 0 ? 0.1 : 1);
  if (draw.integer(0, 3) == 0) {
    problem.mask.assign(problem.points(), 1);
    for (std::uint8_t& each : problem.mask) each = draw.integer(0, 5) > 0;
    problem.mask[static_cast<std::size_t>(draw.integer(0, nx * ny - 1))] = 1;
  }
  double lowest = HUGE_VAL, mean = 0;
  std::int64_t included = 0;
  for (std::size_t i = 0; i < problem.points(); ++i) {
    if (!problem.included(i)) continue;
    lowest = std::min(lowest, problem.gap[i]);
    mean += problem.gap[i];
    ++included;
  }
  mean /= static_cast<double>(included);
  // The pressure that a deflection of that height needs, times a factor.
  problem.system.hardness = problem.system.modulus * height / scale * draw.logarithmic(0.03, 3);
  problem.control = draw.one_of(controls);
  const std::int64_t steps = draw.integer(1, 3);
  const double all = problem.system.hardness * problem.cell_area() * static_cast<double>(included);
  for (std::int64_t k = 0; k < steps; ++k) {
    const double most = periodic ? (draw.integer(0, 2) > 0 ? 0.9 : 3) * (mean - lowest) : draw.one_of(reaches) * height;
    const double share = draw.integer(0, 5) > 0 ? draw.real(0.01, 0.99) : draw.one_of(nearly_all);
    scene.targets.push_back(problem.control == RC_CONTROL_LOAD ? all * share : lowest + most * draw.real(0.1, 1));
  }
  scene.pair.backend = draw.one_of(std::vector<std::string>{"dense", "fft", "auto"});
  std::vector<std::string> solvers = capped_solvers(scene.pair.backend == "auto" ? "fft" : scene.pair.backend, problem.system);
  solvers.emplace_back("auto");
  scene.pair.solver = draw.one_of(solvers);
  scene.text = "scene " + std::to_string(number) + " (" + scene.pair.name() + ", " + std::to_string(nx) + " x " +
               std::to_string(ny) + (periodic ? ", periodic" : ", free") +
               (problem.control == RC_CONTROL_LOAD ? ", load" : ", approach") + ")";
  return scene;
}

struct Tally {
  std::int64_t steps = 0, yielding = 0, proven = 0;
  double worst = 0;
};

// The exact load and the exact contacts lie within what the answer proves.
void check_proofs(const Problem& problem, const Answer& answer, const Field& exact, const std::string& which) {
  const rc_result& r = answer.result;
  std::int64_t contacts = 0, capped = 0;
  double load = 0;
  for (const double p : exact) {
    contacts += p > 0;
    capped += p == problem.system.hardness;
    load += p * problem.cell_area();
  }
  const double doubt = 1e-11 * load;  // of the reference
  check(r.load_lower <= load + doubt && load - doubt <= r.load_upper,
        which + "load " + text(load) + " is not in " + text(r.load_lower) + " .. " + text(r.load_upper));
  check(r.proven_contacts <= contacts && contacts <= r.proven_contacts + r.undecided,
        which + std::to_string(contacts) + " contacts, proven " + std::to_string(r.proven_contacts) + ", undecided " +
            std::to_string(r.undecided));
  check(r.proven_capped <= capped,
        which + std::to_string(capped) + " points at the hardness, proven " + std::to_string(r.proven_capped));
  check(r.duality_gap >= 0 || std::isnan(r.duality_gap), which + "the duality gap is negative");
}

void solve_and_judge(std::uint64_t number, Tally& tally) {
  const Scene scene = scene_of(number);
  Problem problem = scene.problem;
  Field matrix = influence_matrix(problem);
  // Near full contact a periodic approach does not tell the load. A mean added to the matrix shifts the approach by a multiple of
  // the returned load: the load of that problem lies between the returned one and that at the returned approach.
  const double datum = problem.periodic() && problem.control == RC_CONTROL_LOAD ? largest(matrix) : 0;
  for (double& value : matrix) value += datum;
  const Contact contact(problem, scene.pair, {{RC_OPT_TOL, text(tol)}});
  Field gap = problem.gap, said(problem.points());
  for (std::size_t k = 0; k < scene.targets.size(); ++k) {
    const std::string which = scene.text + " step " + std::to_string(k) + ": ";
    problem.target = scene.targets[k];
    const Answer answer = contact.solve(problem);
    check_status(answer, RC_OK, which);
    const Field exact =
        pressures_at(problem, matrix, gap, answer.result.approach + datum * answer.result.load / problem.cell_area());
    double off = 0, size = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
      off = std::max(off, std::abs(answer.p[i] - exact[i]));
      size = std::max(size, exact[i]);
      check(answer.p[i] >= 0 && answer.p[i] <= problem.system.hardness, which + "a pressure is beyond its bounds");
    }
    check(off <= 1e-5 * size, which + "p is off by " + text(off / size) + " of its largest");
    tally.worst = std::max(tally.worst, size > 0 ? off / size : 0);
    check_proofs(problem, answer, exact, which);
    ++tally.steps;
    tally.yielding += answer.result.capped > 0;
    tally.proven += answer.result.undecided == 0;
    check(rc_contact_indentation(contact.handle(), RC_OUT(said.data())) == RC_OK, rc_last_error());
    for (std::size_t i = 0; i < gap.size(); ++i) {
      const double overlap = answer.p[i] == problem.system.hardness ? std::max(0.0, -answer.gap[i]) : 0;
      gap[i] += overlap;
      if (problem.included(i))
        check(std::abs(problem.gap[i] + said[i] - gap[i]) <= 1e-14 * std::abs(gap[i]), which + "the indentation is another");
      gap[i] = problem.gap[i] + said[i];
    }
  }
}

void scenes() {
  const char* value = std::getenv("RC_HARDNESS_SCENES");
  const std::uint64_t count = value && *value ? std::strtoull(value, nullptr, 10) : quick() ? 100 : 300;
  Tally tally;
  std::vector<std::string> failures;
  const auto run = [&](std::uint64_t number) {
    try {
      solve_and_judge(number, tally);
    } catch (const std::exception& failure) {
      failures.emplace_back(failure.what());
    }
  };
  for (std::uint64_t number = 1; number <= count; ++number) run(number);
  // Nearly full load, then less on a surface that has become all but flat.
  for (const std::uint64_t number : {5196, 8252, 9735, 11127, 16492}) run(number);
  // By load: every point is at an end of its pressures, then a point far below its hardness is released.
  for (const std::uint64_t number : {735, 10380, 30629}) run(number);
  report(std::to_string(count) + " scenes, " + std::to_string(tally.steps) + " steps, " + std::to_string(tally.yielding) +
         " with points at the hardness, " + std::to_string(tally.proven) + " without an undecided point, p off by at most " +
         text(tally.worst));
  for (std::size_t k = 0; k < std::min<std::size_t>(failures.size(), 20); ++k) report(failures[k]);
  check(failures.empty(), std::to_string(failures.size()) + " scenes failed");
  check(3 * tally.yielding > tally.steps, "too few steps yield");
}

}  // namespace

}  // namespace pairs

int main(int argc, char** argv) { return pairs::run_group("hardness random", {{"scenes", pairs::scenes}}, argc, argv); }

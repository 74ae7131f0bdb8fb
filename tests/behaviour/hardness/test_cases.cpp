// Every solver that keeps a hardness, on every backend, on every capped reference case. Matrices and products: tests/scenes.
#include <roughcontact/history.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "capped_cases.h"
#include "support/naive.h"
#include "support/registry.h"

namespace pairs {

namespace {

// Allowed |p - p_ref| / max p, as for elastic cases.
constexpr double exact = 1e-11, dense = 1e-9, iterative = 1e-8;

double accuracy_of(const Pair& pair, std::int32_t control) {
  if (pair.backend != "dense" && pair.backend != "cholmod") return iterative;
  return pair.solver == "nnls" && control == RC_CONTROL_APPROACH ? exact : dense;
}

void run(const CappedCase& reference, Problem problem, const Pair& pair) {
  const Contact contact(problem, pair, {{RC_OPT_TOL, "1e-12"}});
  Field indentation(problem.points(), 0.0), said(problem.points(), 0.0);
  for (std::size_t k = 0; k < reference.steps.size(); ++k) {
    const CappedStep& step = reference.steps[k];
    const std::string number = "step " + std::to_string(k + 1) + ": ";
    problem.target = step.target;
    const Answer answer = contact.solve(problem);
    check_status(answer, RC_OK, number + "status");
    const rc_result& r = answer.result;
    const double accuracy = accuracy_of(pair, problem.control);
    check_near(answer.p, step.p, accuracy, number + "p");
    check_near(r.load, step.load, dense * step.load, number + "load");
    check_near(r.approach, step.approach, dense * step.approach, number + "approach");
    check_equal(r.contacts, step.contacts, number + "contacts");
    check_equal(r.capped, step.capped, number + "points at the hardness");
    check_near(r.plastic_volume, step.plastic_volume, iterative * step.approach * problem.cell_area() * 100,
               number + "plastic volume");
    if (pair.backend == "dense") {
      Problem indented = problem;
      for (std::size_t i = 0; i < indentation.size(); ++i) indented.gap[i] += said[i];
      check_against_naive(indented, answer);
    }
    for (std::size_t i = 0; i < indentation.size(); ++i) indentation[i] += step.overlap[i];
    check(rc_contact_indentation(contact.handle(), RC_OUT(said.data())) == RC_OK, rc_last_error());
    for (std::size_t i = 0; i < said.size(); ++i)
      check_near(said[i], indentation[i], 10 * accuracy * step.approach, number + "indentation");
  }
}

// The load of points that all have the hardness, to the last bits: the deflection is far smaller than the first approach tried.
void loads_of_whole_hardnesses(const Pair& pair) {
  Problem problem;
  problem.system.nx = 18;
  problem.system.ny = 17;
  std::mt19937 generator(11);
  for (std::size_t i = 0; i < problem.points(); ++i) problem.gap.push_back(static_cast<double>(generator()) / 4294967296.0);
  problem.control = RC_CONTROL_LOAD;
  for (const double hardness : {1e-7, 1e-5, 1e-3})
    for (const int points : {1, 3})
      for (const int ulps : {-2, 0, 1, 3})
        for (const char* tol : {"1e-8", "1e-12", "1e-14"}) {
          problem.system.hardness = hardness;
          problem.target = points * hardness * problem.cell_area() * (1 + ulps * 2.3e-16);
          const Answer answer = solve(problem, pair, {{RC_OPT_TOL, tol}});
          check_status(answer, RC_OK, text(hardness) + " tol " + tol);
        }
}

// The pairs that must be able to.
void pairs_are_there() {
  for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC}) {
    rc_system system = support::unit_system();
    system.boundary = boundary;
    system.hardness = 1;
    for (const char* backend : {"dense", "fft"}) {
      const std::vector<std::string> can = capped_solvers(backend, system);
      for (const char* solver : {"nnls", "polonsky-keer", "gp", "admm", "cmr"})
        check(std::count(can.begin(), can.end(), solver) == 1,
              std::string(solver) + " on " + backend + " cannot keep a hardness");
      check(std::count(can.begin(), can.end(), "greedy") == 0, "greedy does not keep a hardness");
    }
  }
}

}  // namespace

}  // namespace pairs

int main(int argc, char** argv) {
  using namespace pairs;
  const std::vector<CappedCase> cases = read_capped_cases();
  std::vector<Test> tests = {{"pairs_are_there", pairs_are_there}, {"loads_of_whole_hardnesses", [] {
                                                                      loads_of_whole_hardnesses({"haar-cg", "fft"});
                                                                    }}};
  for (const CappedCase& reference : cases)
    for (const std::string& backend : backend_names()) {
      for (const std::string& solver : capped_solvers(backend, reference.problem.system))
        tests.push_back({solver + "*" + backend + "/" + reference.name, [&reference, solver, backend] {
                           run(reference, reference.problem, {solver, backend});
                         }});
    }
  check(cases.size() == 12, "there are 12 cases");
  return run_group("hardness cases", tests, argc, argv);
}

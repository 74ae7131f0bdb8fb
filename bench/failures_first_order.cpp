// The families gp and admm of the atlas: restarts, step lengths, penalties.
#include <algorithm>

#include "failure_run.h"
#include "failures.h"
#include "format.h"

namespace bench {

namespace {

constexpr const char* tol = "1e-8";

}  // namespace

void gradient_failures(const FailuresRequest& request, Atlas& atlas) {
  Scene scene = rough_scene(request.quick ? 5 : 6, 1);
  for (const char* kernel : {"love", "eq9"}) {
    scene.kernel = kernel;
    const Solved truth = truth_of(scene);
    const auto run = [&](const char* lipschitz, const char* restart) {
      const Solved solved = solve(scene, {{"solver", "gp"},
                                          {"backend", "dense"},
                                          {"tol", tol},
                                          {"max_iter", "100000"},
                                          {"gp.lipschitz", lipschitz},
                                          {"gp.restart", restart}});
      atlas.record("gp", {{"kernel", kernel},
                          {"lipschitz", lipschitz},
                          {"restart", std::string(restart) == "1" ? "yes" : "no"},
                          {"iterations", solved.iterations()},
                          {"products", solved.products()},
                          {"status", solved.name()},
                          {"difference", difference(solved.p, truth.p)}});
      return solved;
    };
    const Solved printed = run("frobenius", "0"), tighter = run("collatz", "0"), restarted = run("frobenius", "1"),
                 both = run("collatz", "1");
    const Solved conjugate =
        solve(scene, {{"solver", "polonsky-keer"}, {"backend", "dense"}, {"tol", tol}, {"max_iter", "100000"}});
    atlas.record("gp", {{"kernel", kernel},
                        {"lipschitz", "polonsky-keer"},
                        {"restart", ""},
                        {"iterations", conjugate.iterations()},
                        {"products", conjugate.products()},
                        {"status", conjugate.name()},
                        {"difference", difference(conjugate.p, truth.p)}});
    atlas.add(
        "gp",
        {formatted("no restart of the acceleration, step from the Frobenius norm, as printed; kernel %s", kernel),
         formatted("iterations to 1e-8: as printed %lld, tight step %lld, with restart %lld, both %lld; polonsky-keer %lld",
                   printed.iterations(), tighter.iterations(), restarted.iterations(), both.iterations(), conjugate.iterations()),
         formatted("%s, %s, %s, %s: slow, never wrong", printed.name(), tighter.name(), restarted.name(), both.name()),
         "gp.restart = 1 and gp.lipschitz = collatz are the defaults"});
  }
}

void admm_failures(const FailuresRequest& request, Atlas& atlas) {
  const Scene scene = rough_scene(request.quick ? 5 : 6, 1);
  const Solved truth = truth_of(scene);
  std::string counts, statuses;
  long long wrong = 0;
  for (const char* rho : {"1e-6", "1e-3", "1e-1", "1", "1e1", "1e3", "1e6", "0"}) {
    const Solved solved = solve(scene, {{"solver", "admm"},
                                        {"backend", "dense"},
                                        {"tol", tol},
                                        {"max_iter", request.quick ? "1000" : "5000"},
                                        {"admm.rho", rho}});
    const double error = difference(solved.p, truth.p);
    wrong += solved.status == RC_OK && error > 1e-5;
    const std::string name = std::string(rho) == "0" ? "automatic" : rho;
    atlas.record("admm", {{"rho", name},
                          {"iterations", solved.iterations()},
                          {"status", solved.name()},
                          {"residual", solved.residual()},
                          {"difference", error}});
    counts += (counts.empty() ? "" : ", ") + name + formatted(": %lld", solved.iterations());
    statuses += (statuses.empty() ? "" : ", ") + std::string(solved.name());
  }
  atlas.add("admm", {"a penalty rho far from the scale of H", "iterations, rho in units of E* and the cell: " + counts,
                     statuses + formatted("; wrong answers with status RC_OK: %lld", wrong),
                     "admm.rho = 0, the default, takes it from bounds of the eigenvalues and balances the residuals"});

  const Solved plain = solve(scene, {{"solver", "admm"}, {"backend", "dense"}, {"tol", tol}});
  double worst = 0;
  bool same = true;
  for (const double length : {1e-9, 1.0})
    for (const double pressure : {1e-9, 1e11}) {
      const Solved solved = solve(in_units(scene, length, pressure), {{"solver", "admm"}, {"backend", "dense"}, {"tol", tol}});
      const double error = difference(scaled(solved.p, 1 / pressure), truth.p);
      atlas.record("units", {{"solver", "admm"},
                             {"length", length},
                             {"pressure", pressure},
                             {"iterations", solved.iterations()},
                             {"difference", error},
                             {"status", solved.name()}});
      worst = std::max(worst, error);
      same = same && solved.iterations() == plain.iterations() && solved.status == RC_OK;
    }
  atlas.add(
      "admm",
      {"rho = 1 of the paper is a stiffness: it works only in units in which H is about 1",
       formatted("lengths times 1e-9, pressures times 1e-9 and 1e11: iterations %s, pressures differ from the exact ones by %.1e",
                 same ? "equal" : "NOT equal", worst),
       "units do not reach the solver", "rho is relative to E* and the cell"});
}

}  // namespace bench

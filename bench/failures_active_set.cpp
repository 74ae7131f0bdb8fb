// The families polonsky-keer and nnls of the atlas: tolerances, starts, units, ties, warm-ups.
#include "failure_run.h"
#include "failures.h"
#include "format.h"
#include "library.h"

namespace bench {

namespace {

Settings on_dense(const char* solver, const char* tol) { return {{"solver", solver}, {"backend", "dense"}, {"tol", tol}}; }

Settings with(Settings settings, const Settings& more) {
  settings.insert(settings.end(), more.begin(), more.end());
  return settings;
}

// What the printed stop test "w >= -eps" with eps = 1e-8 would make of lengths around `length`: 1e-8 over the compenetration.
constexpr double printed_eps = 1e-8;

}  // namespace

void polonsky_keer_failures(const FailuresRequest& request, Atlas& atlas) {
  const Scene hertz = hertz_scene(request.quick ? 32 : 96), rough = rough_scene(request.quick ? 5 : 6, 1);
  const Solved below = solve(hertz, on_dense("polonsky-keer", "1e-16"));
  atlas.record("polonsky-keer", {{"trigger", "tolerance 1e-16"},
                                 {"status", below.name()},
                                 {"iterations", below.iterations()},
                                 {"residual", below.residual()}});
  atlas.add("polonsky-keer",
            {"a tolerance below what double precision can reach: Hertz, tol 1e-16",
             formatted("the updated gap goes on shrinking while the true residual stays at %.1e", below.residual()),
             formatted("%s after %lld iterations: the residual counts only with a fresh product, and must fall by a tenth in 300 "
                       "iterations",
                       below.name(), below.iterations()),
             "the answer is delivered with its residual"});

  const Solved cold = solve(rough, on_dense("polonsky-keer", "1e-10"));
  const Solved again = solve(rough, on_dense("polonsky-keer", "1e-10"), &cold.p);
  Scene deep = rough;
  deep.approach *= 8;
  const Field heavy = solve(deep, on_dense("polonsky-keer", "1e-10")).p;
  const Solved lighter = solve(rough, on_dense("polonsky-keer", "1e-10"), &heavy);
  Scene untouched = rough;
  untouched.approach = 0;
  const Solved none = solve(untouched, on_dense("polonsky-keer", "1e-10"));
  atlas.record("polonsky-keer", {{"trigger", "starts"},
                                 {"cold", cold.products()},
                                 {"exact", again.products()},
                                 {"heavier", lighter.products()},
                                 {"exact_status", again.name()},
                                 {"heavier_status", lighter.name()},
                                 {"no_approach_status", none.name()}});
  atlas.add("polonsky-keer",
            {"an exact start, no approach at all, a start from 8 times the approach: as printed 0/0, or far from the answer",
             formatted("products: cold %lld, exact start %lld, no approach %lld, heavy start %lld", cold.products(),
                       again.products(), none.products(), lighter.products()),
             formatted("%s, %s, %s", again.name(), none.name(), lighter.name()),
             "the certificate ends an exact start at once; a start worse than none is cut to its best multiple"});
}

void nnls_failures(const FailuresRequest& request, Atlas& atlas) {
  const Scene rough = rough_scene(5, 1);
  double worst = 0;
  bool same_work = true;
  std::string statuses;
  const Solved plain = solve(rough, on_dense("nnls", "1e-10"));
  for (const double length : {1e-9, 1.0, 1e9})
    for (const double pressure : {1e-9, 1e11}) {
      const Scene changed = in_units(rough, length, pressure);
      const Solved solved = solve(changed, on_dense("nnls", "1e-10"));
      const double error = difference(scaled(solved.p, 1 / pressure), plain.p);
      worst = std::max(worst, error);
      same_work = same_work && solved.iterations() == plain.iterations() && solved.status == RC_OK;
      atlas.record("units", {{"solver", "nnls"},
                             {"length", length},
                             {"pressure", pressure},
                             {"iterations", solved.iterations()},
                             {"difference", error},
                             {"status", solved.name()}});
    }
  atlas.add("nnls",
            {"lengths times 1e-9 to 1e9, pressures times 1e-9 to 1e11",
             formatted("with the printed absolute tolerance eps = %.0e a compenetration of 1e-9 is no contact, and forces of "
                       "1e-9 may pull",
                       printed_eps),
             formatted("largest difference of the pressures %.1e, iterations %s", worst, same_work ? "equal" : "NOT equal"),
             "solvers see a dimensionless problem; all tolerances are relative"});

  const Scene ties = tied_scene(request.quick ? 8 : 16);
  const Solved block = solve(ties, on_dense("nnls", "1e-10"));
  const Solved single = solve(ties, with(on_dense("nnls", "1e-10"), {{"nnls.pivoting", "single"}}));
  const Solved other = solve(ties, on_dense("polonsky-keer", "1e-10"));
  atlas.record("ties", {{"block", block.iterations()},
                        {"single", single.iterations()},
                        {"block_contacts", block.result.contacts},
                        {"single_contacts", single.result.contacts},
                        {"polonsky_keer_contacts", other.result.contacts},
                        {"difference", std::max(difference(single.p, block.p), difference(other.p, block.p))}});
  atlas.add("nnls", {"points that touch without pressure: p = 0 and gap = 0",
                     formatted("contacts counted: block %lld, single %lld, polonsky-keer %lld; pressures differ by %.1e at most",
                               static_cast<long long>(block.result.contacts), static_cast<long long>(single.result.contacts),
                               static_cast<long long>(other.result.contacts),
                               std::max(difference(single.p, block.p), difference(other.p, block.p))),
                     formatted("%s, %s, %s: pressures, loads and gaps are certified, a count of contacts is not", block.name(),
                               single.name(), other.name()),
                     "area_lower and area_upper say what is proven"});

  const Field pulling = [&] {
    Field p(rough.gap.size(), 1e3);
    for (std::size_t i = 0; i < p.size(); i += 2) p[i] = -1e3;
    return p;
  }();
  const Solved tensile = solve(rough, on_dense("nnls", "1e-10"), &pulling);
  atlas.record("tensile", {{"status", tensile.name()}, {"difference", difference(tensile.p, plain.p)}});
  atlas.add("nnls",
            {"a start with tension", "as printed it may be returned as the answer when forces are small",
             formatted("%s, pressures differ by %.1e from the cold answer", tensile.name(), difference(tensile.p, plain.p)),
             "negative pressures of a start are taken as 0"});

  Scene warm = rough_scene(request.quick ? 6 : 7, 1);
  warm.kernel = "eq9";
  if (request.quick) warm.approach *= 1.5;
  const Settings printed = {{"gp.lipschitz", "frobenius"}, {"gp.restart", "0"}};
  const auto solves = [&](const char* pivoting, const char* warmup, const char* steps) {
    Settings settings = with(on_dense("nnls", "1e-10"), printed);
    settings = with(settings, {{"nnls.pivoting", pivoting}, {"warmup", warmup}, {"warmup.iterations", steps}});
    const Solved solved = solve(warm, with(settings, {{"max_iter", "1000000"}}));
    // The warm-up counts as iterations, too; it ends early where it has solved the problem.
    const bool none = std::string(warmup) == "none";
    const Settings alone = with(with(on_dense("gp", "1e-10"), printed), {{"max_iter", steps}});
    const long long count = solved.iterations() - (none ? 0 : solve(warm, alone).iterations());
    atlas.record("warm_up", {{"pivoting", pivoting},
                             {"warmup", warmup},
                             {"steps", none ? 0 : std::stoi(steps)},
                             {"solves", count},
                             {"candidates", solved.result.candidates},
                             {"contacts", solved.result.contacts},
                             {"status", solved.name()}});
    return count;
  };
  const long long cold = solves("single", "none", "1"), ten = solves("single", "gp", "10"), fifty = solves("single", "gp", "50"),
                  hundred = solves("single", "gp", "100"), block_cold = solves("block", "none", "1"),
                  block_ten = solves("block", "gp", "10"), block_hundred = solves("block", "gp", "100");
  atlas.add("nnls",
            {"too short a warm-up by gradient projection, one exchange per solve as printed; kernel eq9",
             formatted("linear solves: cold %lld, after 10 steps %lld, 50 steps %lld, 100 steps %lld", cold, ten, fifty, hundred),
             "no failure of the answer, only of speed: each superfluous point costs a solve",
             formatted("nnls.pivoting = block, the default, exchanges all at once: %lld cold, %lld after 10 steps, %lld "
                       "after 100",
                       block_cold, block_ten, block_hundred)});
}

}  // namespace bench

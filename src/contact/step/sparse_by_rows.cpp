#include "contact/step/sparse_by_rows.h"

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>

#include "contact/operators.h"
#include "contact/proof/plausibility.h"
#include "contact/proof/survey.h"
#include "contact/step/sparse_contact.h"

namespace rc {

namespace {

// Whether all processes have the same components for it: one may lack a plugin.
bool all_have(const std::optional<Choice>& few, const GridProblem& problem) {
  struct Names {
    char solver[64] = "", backend[64] = "";
  } mine;
  if (few) {
    std::snprintf(mine.solver, sizeof mine.solver, "%s", few->solver->name);
    std::snprintf(mine.backend, sizeof mine.backend, "%s", few->backend->name);
  }
  const std::vector<Names> all = problem.rows().of_each(mine);
  return all.front().solver[0] != 0 && std::all_of(all.begin(), all.end(), [&](const Names& each) {
           return std::string(each.solver) == all.front().solver && std::string(each.backend) == all.front().backend;
         });
}

std::int64_t contacts_of(const CertifiedStep& last, const GridProblem& problem) {
  return problem.surface.points().rows().united(last.pressures.contacts());
}

// The last step of all processes, whose pressures are few.
CertifiedStep gathered(const CertifiedStep& last, const GridProblem& problem) {
  const std::int64_t before = problem.surface.points().rows().first() * problem.system.given.nx;
  const Pressures positive = last.pressures.positive(problem.team());
  std::vector<std::int64_t> mine(positive.p.size());
  for (std::size_t k = 0; k < mine.size(); ++k) mine[k] = positive.on.point(static_cast<std::int64_t>(k)) + before;
  CertifiedStep all{{}, last.approach, last.load, last.same_gap};
  all.pressures.on.index = problem.rows().joined(std::move(mine));
  all.pressures.p = problem.rows().joined(positive.p);
  all.pressures.on.n = static_cast<std::int64_t>(all.pressures.p.size());
  return all;
}

// Calls take for the entries of this process, given the points of the whole grid in ascending order.
template <class Take> void each_own(const GridProblem& problem, std::size_t n, const auto& point, const Take& take) {
  const std::int64_t before = problem.surface.points().rows().first() * problem.system.given.nx,
                     end = before + problem.own_points();
  for (std::size_t k = 0; k < n; ++k)
    if (point(k) >= before && point(k) < end) take(point(k) - before, k);
}

// The deformed gap at all points of the rows, by one product that all make together, and its mean.
void write_gap(const GridProblem& problem, StepResult& mine, const Attempt& attempt, const Outputs& outputs) {
  std::vector<double> p;
  problem.rows().on_all([&] {
    p.resize(static_cast<std::size_t>(problem.own_points()));
    mine.pressures.write(p.data(), problem.own_points(), problem.team());
  });
  Answer by;
  Deflected found = deflection(problem, {problem.own_points(), {}}, std::move(p), by, attempt);
  const double compression = mine.numbers.approach - problem.surface.lowest();
  write_arrays(problem, found, compression, outputs);
  mine.numbers.mean_gap = mean_gap(problem, survey(problem.surface, compression, found), mine.numbers.totals.overlap);
  if (problem.keeps_deflection()) mine.deflection = std::move(found.product);
}

}  // namespace

std::optional<StepResult> sparse_by_rows(const GridProblem& problem, const Target& target, const Start& start,
                                         const std::optional<Choice>& few, const Attempt& attempt, const Outputs& outputs) {
  const Rows& rows = problem.rows();
  if (start.given() || !all_have(few, problem)) return std::nullopt;
  const rc_system& system = problem.system.given;
  const CertifiedStep& last = start.last();
  const std::int64_t contacts = contacts_of(last, problem);
  const double before = target.by_load() ? last.load : last.approach;
  const auto sparse = [&](std::int64_t n) { return are_few(n, problem.system.points(), problem.system.periodic()); };
  const bool older_sparse = sparse(contacts_of(start.before(), problem));
  if (contacts > 0 && !sparse(contacts) && last.same_gap && target.value >= before) return std::nullopt;  // denser
  std::optional<double>& tilt = problem.facts.tilt;
  if (!tilt) tilt = plane_share(problem.surface, system.nx, system.ny, problem.system.periodic());

  std::optional<StepResult> whole;
  std::unique_ptr<GridProblem> all;
  rows.together([&] {
    all = std::make_unique<GridProblem>(system, problem.options, &problem.team(), problem.company().replicated());
    all->facts.tilt = tilt;
    if (problem.system.periodic()) all->operators().multiply_by(problem.operators());
    all->surface = StepSurface(problem.surface, problem.team());
    all->compliance = problem.compliance;
    Memory known;
    if (sparse(contacts)) known.last = gathered(last, problem);
    if (older_sparse) known.before = gathered(start.before(), problem);
    Pyramid pyramid(*all, target, attempt.monitor);
    if (std::optional<Answer> answer = sparse_contact(*all, target, start.from(known), *few, pyramid, attempt).answer)
      whole = certify_and_write(*all, target, std::move(*answer), attempt, {});
  });
  if (!whole || whole->numbers.status == RC_STOP_STALLED || whole->numbers.status == RC_UNCERTIFIED) return std::nullopt;

  StepResult mine{.numbers = whole->numbers, .by = whole->by};
  rows.on_all([&] {
    const Pressures& p = whole->pressures;
    each_own(
        problem, p.p.size(), [&](std::size_t k) { return p.on.point(static_cast<std::int64_t>(k)); },
        [&](std::int64_t point, std::size_t k) {
          mine.pressures.on.index.push_back(point);
          mine.pressures.p.push_back(p.p[k]);
        });
    mine.pressures.on.n = static_cast<std::int64_t>(mine.pressures.p.size());
    if (mine.pressures.on.n == problem.own_points()) mine.pressures.on.index.clear();
    const Overlap& overlap = whole->overlap;
    each_own(
        problem, overlap.point.size(), [&](std::size_t k) { return overlap.point[k]; },
        [&](std::int64_t point, std::size_t k) {
          mine.overlap.point.push_back(point);
          mine.overlap.depth.push_back(overlap.depth[k]);
        });
  });
  if (outputs.gap.wanted() || problem.keeps_deflection())
    write_gap(problem, mine, attempt, outputs);
  else
    mine.pressures.write(outputs.p, problem.own_points(), problem.team());
  return mine;
}

}  // namespace rc

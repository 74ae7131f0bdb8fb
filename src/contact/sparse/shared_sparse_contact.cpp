#include "contact/sparse/shared_sparse_contact.h"

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>

#include "contact/proof/plausibility.h"
#include "contact/proof/survey.h"
#include "contact/sparse/sparse_contact.h"
#include "contact/step/choice.h"
#include "contact/step/trial_set.h"
#include "contact/surface/output_array.h"

namespace rc {

namespace {

// Whether all ranks have the same components for it: one may lack a plugin.
bool all_can(const Workspace& work, const rc_step& step) {
  struct Names {
    char solver[64] = "", backend[64] = "";
  } mine;
  const bool by_rows = work.system.periodic();
  if (const std::optional<Choice> choice = choose_for_few(work.options, work.system, step.control, by_rows);
      choice && (by_rows || (choice->backend->caps & RC_CAP_SCREEN_ROWS))) {
    std::snprintf(mine.solver, sizeof mine.solver, "%s", choice->solver->name);
    std::snprintf(mine.backend, sizeof mine.backend, "%s", choice->backend->name);
  }
  const std::vector<Names> all = work.ranks()->of_each(mine);
  return all.front().solver[0] != 0 && std::all_of(all.begin(), all.end(), [&](const Names& each) {
           return std::string(each.solver) == all.front().solver && std::string(each.backend) == all.front().backend;
         });
}

std::int64_t contacts_of(const CertifiedStep& last, const Workspace& work) {
  const std::vector<double>& p = last.pressures.p;
  return work.surface.united(static_cast<std::int64_t>(std::count_if(p.begin(), p.end(), [](double each) { return each > 0; })));
}

// The last step of all ranks, whose pressures are few.
CertifiedStep gathered(const CertifiedStep& last, const Workspace& work) {
  const std::int64_t before = work.surface.first_row() * work.system.given.nx;
  const Pressures positive = last.pressures.positive(work.team());
  std::vector<std::int64_t> mine(positive.p.size());
  for (std::size_t k = 0; k < mine.size(); ++k) mine[k] = positive.on.point(static_cast<std::int64_t>(k)) + before;
  CertifiedStep all{{}, last.approach, last.load, last.same_gap};
  all.pressures.on.index = work.ranks()->of_any(mine);
  all.pressures.p = work.ranks()->of_any(positive.p);
  all.pressures.on.n = static_cast<std::int64_t>(all.pressures.p.size());
  return all;
}

// What this rank has of entries at points of the whole grid, in ascending order.
template <class Take> void each_own(const Workspace& work, std::size_t n, const auto& point, const Take& take) {
  const std::int64_t before = work.surface.first_row() * work.system.given.nx, end = before + work.own_points();
  for (std::size_t k = 0; k < n; ++k)
    if (point(k) >= before && point(k) < end) take(point(k) - before, k);
}

// The deformed gap at all points of the rows and its mean, by one product of all ranks.
void write_gap(Workspace& work, const Pressures& own, double compression, rc_result& result) {
  const TrialSet rows{work.own_points(), {}};
  Answer answer = prepared(rows, RC_CONTROL_APPROACH, 1, work);
  answer.op = &work.bound_operator(*answer.choice.backend, rows);
  Deflected found;
  on_all(work.ranks(), [&] {
    answer.p.resize(static_cast<std::size_t>(work.own_points()));
    own.write(answer.p.data(), work.own_points(), work.team());
    found.product.resize(answer.p.size());
  });
  answer.op->field(answer.p, found.product);
  for (double& value : found.product) value *= work.system.length_per_pressure;
  found.pressures = {rows, std::move(answer.p)};
  result.mean_gap = mean_gap(work, survey(work.surface, compression, found), result.plastic_volume / work.system.cell_area());
  write_arrays(work, found, compression, result);
}

}  // namespace

std::optional<Finished> shared_sparse_contact(Workspace& work, const Memory& memory, const rc_step& step, Monitor& monitor,
                                              rc_result& result) {
  const Ranks* const ranks = work.ranks();
  if (!ranks || step.p0 || !all_can(work, step)) return std::nullopt;
  const std::int64_t contacts = step.warm_start ? contacts_of(memory.last, work) : 0;
  const double before = step.control == RC_CONTROL_LOAD ? memory.last.load : memory.last.approach;
  const auto sparse = [&](std::int64_t n) { return few(n, work.system.points(), work.system.periodic()); };
  const bool older_sparse = step.warm_start && sparse(contacts_of(memory.before, work));
  if (contacts > 0 && !sparse(contacts) && memory.last.same_gap && step.target >= before) return std::nullopt;  // it grows denser
  if (!work.facts.tilt)
    work.facts.tilt = plane_share(work.surface, work.system.given.nx, work.system.given.ny, work.system.periodic());

  rc_result told = result;
  told.p = told.gap = nullptr;
  told.p_single = told.gap_single = nullptr;
  std::optional<Finished> finished;
  std::unique_ptr<Workspace> all;
  ranks->alike([&] {
    all = std::make_unique<Workspace>(work.system.given, work.options, &work.team());
    all->facts.tilt = work.facts.tilt;
    if (work.system.periodic()) all->multiply_by(&work);
    all->record.warm = work.record.warm;
    all->surface = StepSurface(work.surface, work.team());
    Memory known;
    if (sparse(contacts)) known.last = gathered(memory.last, work);
    if (older_sparse) known.before = gathered(memory.before, work);
    std::optional<Estimate> none;
    if (std::optional<Answer> answer = sparse_contact(*all, known, step, monitor, none))
      finished = certified_result(*all, step, std::move(*answer), monitor, told);
  });
  if (!finished || finished->status == RC_STOP_STALLED || finished->status == RC_UNCERTIFIED) return std::nullopt;

  Finished mine{finished->status, {}, {}};
  on_all(ranks, [&] {
    const Pressures& p = finished->pressures;
    each_own(
        work, p.p.size(), [&](std::size_t k) { return p.on.point(static_cast<std::int64_t>(k)); },
        [&](std::int64_t point, std::size_t k) {
          mine.pressures.on.index.push_back(point);
          mine.pressures.p.push_back(p.p[k]);
        });
    mine.pressures.on.n = static_cast<std::int64_t>(mine.pressures.p.size());
    if (mine.pressures.on.n == work.own_points()) mine.pressures.on.index.clear();
    const Overlap& overlap = finished->overlap;
    each_own(
        work, overlap.point.size(), [&](std::size_t k) { return overlap.point[k]; },
        [&](std::int64_t point, std::size_t k) {
          mine.overlap.point.push_back(point);
          mine.overlap.depth.push_back(overlap.depth[k]);
        });
  });
  work.record.choice = all->record.choice;
  work.record.accuracy = all->record.accuracy;
  told.p = result.p;
  told.p_single = result.p_single;
  told.gap = result.gap;
  told.gap_single = result.gap_single;
  result = told;
  if (gap_of(result).wanted())
    write_gap(work, mine.pressures, result.approach - work.surface.lowest(), result);
  else
    mine.pressures.write(pressures_of(result), work.own_points(), work.team());
  return mine;
}

}  // namespace rc

#include "contact/coarse/pyramid.h"

#include <algorithm>
#include <utility>

#include "contact/operators.h"
#include "contact/surface/blocks.h"

namespace rc {

namespace {

// The largest grids are halved several times at once, until little memory is needed.
int halvings_of(const GridProblem& finer) {
  constexpr std::int64_t largest = 8192 * 8192;  // points of the finest level
  int halvings = 1;
  while (!finer.surface.gathered() && finer.system.points() >> (2 * halvings) > largest) ++halvings;
  return halvings;
}

}  // namespace

void Pyramid::build() {
  constexpr double tol = 1e-2;  // spreading the pressures to the finer grid loses further digits
  constexpr std::int64_t least_side = 64;
  if (std::exchange(built_, true)) return;
  building_ = true;
  rc_options options = coarse_options(given_.options, monitor_);
  options.set(RC_OPT_TOL, std::max(tol, given_.options.real(RC_OPT_TOL)));
  for (;;) {
    const GridProblem& finer = coarsest();
    const rc_system& system = finer.system.given;
    if (std::min(system.nx, system.ny) < 2 * least_side) break;
    auto level = std::make_unique<Level>(finer, options, halvings_of(finer));
    if (!target_.touches(level->problem().surface)) break;
    levels_.push_back(std::move(level));
  }
  building_ = false;
}

const Level* Pyramid::next() {
  build();
  return levels_.empty() ? nullptr : levels_.back().get();
}

std::optional<Estimate> Pyramid::estimate() const {
  if (!reached_) return std::nullopt;
  const GridProblem& on = coarsest();
  const Blocks blocks{on.system.given.nx, on.system.given.ny, std::int64_t{1} << reached_->halvings};
  if (on.surface.gathered()) on.surface.hold_tiles_of(blocks.points_under(reached_->pressures));
  const bool sparse =
      are_few(reached_->pressures.contacts(), blocks.coarse_nx() * blocks.coarse_ny(), on.operators().multiply_by_rows());
  return Estimate{spread(reached_->pressures, blocks, on.surface, Cut::same_pressure), reached_->approach, !sparse};
}

void Pyramid::solved(Answer&& answer) {
  const Level& level = *levels_.back();
  const double approach = level.problem().surface.lowest() + answer.compression;
  Pressures found = answer.take_pressures(given_.team()).positive(given_.team());
  reached_.reset();
  if (!found.empty()) reached_ = {std::move(found), approach, level.halvings()};
  levels_.pop_back();
}

void Pyramid::give_up() {
  built_ = true;
  building_ = false;
  levels_.clear();
  reached_.reset();
}

}  // namespace rc

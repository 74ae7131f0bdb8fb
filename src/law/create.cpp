#include "law/create.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>

#include "core/error.h"
#include "core/limits.h"
#include "law/nodes.h"

namespace rc {

namespace {

constexpr std::int64_t usual_most = 10000;
constexpr double least_step = 1e-12;  // between nodes, relative: what double precision tells apart
constexpr double jump_width = 1e-4;   // an interval this short, relative, encloses a jump of the slope
constexpr int most_parts = 8;         // of an interval at a time

void check_spec(const rc_system& system, const rc_law_spec& spec) {
  const auto positive = [](double value) { return value > 0 && std::isfinite(value); };
  if (!spec.undeformed_gap.data) fail(RC_ERR_ARGUMENT, "rc_law_spec.undeformed_gap is null");
  if (!positive(spec.p_lower) || !(spec.p_lower < spec.p_upper) || !positive(spec.p_upper))
    fail(RC_ERR_ARGUMENT, "rc_law_spec.p_lower = ", spec.p_lower, ", p_upper = ", spec.p_upper,
         ": must be 0 < p_lower < p_upper, finite");
  if (!(spec.tolerance >= 1e-6 && spec.tolerance <= 0.1))
    fail(RC_ERR_ARGUMENT, "rc_law_spec.tolerance = ", spec.tolerance,
         " must be 1e-6 .. 0.1; double precision does not prove less");
  const double conductance = spec.tolerance_conductance;
  if (conductance != 0 && !(conductance >= 1e-4 && conductance <= 1))
    fail(RC_ERR_ARGUMENT, "rc_law_spec.tolerance_conductance = ", conductance, " must be 0 or 1e-4 .. 1");
  if (spec.bulk < RC_LAW_BULK_AUTO || spec.bulk > RC_LAW_BULK_MEAN)
    fail(RC_ERR_ARGUMENT, "rc_law_spec.bulk = ", spec.bulk, " is none of RC_LAW_BULK_*");
  if (spec.bulk == RC_LAW_BULK_MEAN && !takes_mean_gap(system))
    fail(RC_ERR_INCOMPATIBLE,
         "rc_law_spec.bulk = RC_LAW_BULK_MEAN is for a half-space with free or semi-periodic boundaries; take RC_LAW_BULK_AUTO");
  if (spec.bulk == RC_LAW_BULK_GIVEN ? !positive(spec.bulk_stiffness) : spec.bulk_stiffness != 0)
    fail(RC_ERR_ARGUMENT, "rc_law_spec.bulk_stiffness = ", spec.bulk_stiffness,
         " must be positive and finite with RC_LAW_BULK_GIVEN, and 0 otherwise");
  if (spec.area != 0 && !positive(spec.area)) fail(RC_ERR_ARGUMENT, "rc_law_spec.area = ", spec.area, " must be positive, or 0");
  if (spec.max_nodes != 0 && spec.max_nodes < 3)
    fail(RC_ERR_ARGUMENT, "rc_law_spec.max_nodes = ", spec.max_nodes, " must be 0, or at least 3");
}

class LawMaker {
 public:
  LawMaker(const rc_system& system, const rc_options* options, const rc_law_spec& spec)
      : spec_(spec), patch_(system, options, spec), nodes_(patch_) {}

  std::unique_ptr<rc_law> made(const rc_system& system) {
    nodes_.add({patch_.at_load(spec_.p_lower * patch_.area()), patch_.at_load(spec_.p_upper * patch_.area())});
    if (spec_.tolerance_conductance != 0 && !patch_.homogeneous())
      fail(RC_ERR_ARGUMENT, "rc_law_spec.tolerance_conductance = ", spec_.tolerance_conductance, ": ", no_conductance);
    if (nodes_.size() < 3) fail(RC_ERR_ARGUMENT, "p_lower and p_upper are the same to double precision");
    auto law = std::make_unique<rc_law>();
    const auto most = static_cast<std::size_t>(spec_.max_nodes > 0 ? spec_.max_nodes : usual_most);
    for (;;) {
      const std::vector<double> approaches = wanted();
      if (approaches.empty()) break;
      if (nodes_.size() + approaches.size() > most) {
        law->status = RC_STOP_MAX_ITER;
        law->remark = join("more than rc_law_spec.max_nodes = ", most, " nodes are needed");
        break;
      }
      std::vector<LawSample> fresh;
      for (const double approach : approaches) fresh.push_back(patch_.at_approach(approach));
      const std::size_t before = nodes_.size();
      nodes_.add(std::move(fresh));
      if (nodes_.size() == before) break;
    }
    thin();
    fill(*law, system);
    return law;
  }

 private:
  // How many times too wide an interval is, in its bounds or, without any, in how far its chord is from its tangents; and at
  // which share of it.
  struct Need {
    double times, at;
  };
  Need need(const rc_law_point& node, const rc_law_point& next) const {
    double most = 0, at = 0.5;
    if (node.bounds == RC_LAW_MONOTONE) {
      const double h = next.x - node.x, chord = (next.p - node.p) / h;
      most = std::max(std::abs(chord - node.slope), std::abs(next.slope - chord)) * h / (8 * node.p) / spec_.tolerance;
    } else {
      const LawWidth width = widest(node, next, patch_.bulk_yield());
      most = width.half / spec_.tolerance;
      at = std::clamp(width.at, 0.05, 0.95);
    }
    if (spec_.tolerance_conductance > 0 && node.bounds != RC_LAW_MONOTONE && next.x - node.x > jump_width * node.x) {
      const double times = (node.between_upper / std::max(0.0, node.between_lower) - 1) / 2 / spec_.tolerance_conductance;
      most =
          std::max(most, times > 1 ? times * times : 0);  // the width of slopes falls with the length, that of p with its square
    }
    return {most, at};
  }

  // Leaves out nodes that the tolerance does not need: with a hardness, halving leaves many short intervals between kinks of both
  // signs.
  void thin() {
    if (!patch_.plastic()) return;
    for (std::size_t i = 2; i + 1 < nodes_.size();) {
      LawSample before = nodes_.skipping(i);
      if (before.node.bounds != RC_LAW_MONOTONE && need(before.node, nodes_[i + 1].node).times <= 1)
        nodes_.leave_out(i, std::move(before));
      else
        ++i;
    }
  }

  // Approaches of further nodes, in ascending order.
  std::vector<double> wanted() const {
    std::vector<double> approaches;
    for (std::size_t i = 1; i + 1 < nodes_.size(); ++i) {
      const LawSample &sample = nodes_[i], &next = nodes_[i + 1];
      const auto [times, at] = need(sample.node, next.node);
      const double d = sample.approach, h = next.approach - d;
      if (!(times > 1) || !(h > least_step * next.approach)) continue;
      const int parts = static_cast<int>(std::min<double>(most_parts, std::ceil(1.05 * std::sqrt(times))));
      if (parts <= 2) {
        approaches.push_back(d + h * at);
        continue;
      }
      const double ratio = std::pow(next.approach / d, 1.0 / parts);
      for (int part = 1; part < parts; ++part) approaches.push_back(d * std::pow(ratio, part));
    }
    return approaches;
  }

  void fill(Law& law, const rc_system& system) const {
    law.tolerance = spec_.tolerance;
    law.tolerance_conductance = spec_.tolerance_conductance;
    law.info.solves = patch_.solves();
    law.info.bulk = patch_.bulk();
    law.info.modulus = patch_.homogeneous() ? system.modulus : 0;
    law.info.hardness = patch_.plastic() ? system.hardness : 0;
    law.info.area = patch_.area();
    law.info.bulk_stiffness = spec_.bulk_stiffness;
    law.info.mean_gap = patch_.mean_gap();
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      law.nodes.push_back(nodes_[i].node);
      if (i > 1 && patch_.bulk() == RC_LAW_BULK_MEAN) law.nodes.back().energy = nan;
    }
    rc_law_point& last = law.nodes.back();  // beyond it, the bounds of the last interval continue
    last.bounds = law.nodes[law.nodes.size() - 2].bounds;
    last.between_lower = last.bounds == RC_LAW_CONVEX && !patch_.plastic() ? last.slope_lower : 0;
    last.between_upper = HUGE_VAL;
    law.finish();
  }

  const rc_law_spec& spec_;
  LawPatch patch_;
  LawNodes nodes_;
};

}  // namespace

std::unique_ptr<rc_law> create_law(const rc_system& system, const rc_options* options, const rc_law_spec& spec) {
  check_spec(system, spec);
  const auto start = std::chrono::steady_clock::now();
  auto law = LawMaker(system, options, spec).made(system);
  law->info.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return law;
}

}  // namespace rc

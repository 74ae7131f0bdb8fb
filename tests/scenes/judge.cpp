// Judges the answer of one step.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>

#include "property.h"

namespace scenes {

namespace {

constexpr Real whole_tol = 1 + 1e-6L;

std::string at_point(std::size_t i) { return " at point " + std::to_string(i); }

Reals gap_of(const Case& c, const Surface& surface, const StepAnswer& answer) {
  Reals gap = c.h().times(Reals(answer.p.begin(), answer.p.end()));
  for (std::size_t i = 0; i < gap.size(); ++i)
    gap[i] += static_cast<Real>(surface.gap[i]) + (answer.indentation.empty() ? 0 : static_cast<Real>(answer.indentation[i])) -
              static_cast<Real>(answer.result.approach);
  return gap;
}

struct Sums {
  Real p = 0, most = 0, overlap = 0;
  std::int64_t contacts = 0, capped = 0;
};

Sums sums_of(const Case& c, const Surface& surface, const StepAnswer& answer) {
  Sums sums;
  for (std::size_t i = 0; i < answer.p.size(); ++i) {
    const Real p = answer.p[i];
    need(std::isfinite(answer.p[i]), "a pressure is not finite" + at_point(i));
    need(surface.included(i) || p == 0, "pressure under the mask" + at_point(i));
    need(p >= 0 && p <= c.cap(), "the pressure " + number(p) + " is beyond its ends" + at_point(i));
    sums.p += p;
    sums.most = std::max(sums.most, p);
    sums.contacts += p > 0;
    if (p < c.cap() || !surface.included(i)) continue;
    ++sums.capped;
    sums.overlap += std::max<Real>(0, -static_cast<Real>(answer.gap[i]));
  }
  return sums;
}

void near(Real value, Real wanted, Real allowed, const char* what) {
  need(std::abs(value - wanted) <= allowed, std::string(what) + " " + number(value) + " instead of " + number(wanted));
}

void judge_names(const Case& c, const rc_result& r) {
  const Scene& scene = c.scene();
  const std::string solver = c.pair().solver, backend = c.pair().backend;
  if (r.contacts > 0)
    need((solver == "auto" || solver == r.solver) && (backend == "auto" || backend == r.backend), "another pair");
  const std::string kernel = !scene.halfspace()       ? ""
                             : scene.kernel != "auto" ? scene.kernel
                             : scene.periodic()       ? "spectral"
                                                      : "love";
  need(r.kernel == kernel, std::string("the kernel is ") + r.kernel);
  need(r.contacts == 0 || (r.contacts <= r.candidates && r.candidates <= r.modelled && r.modelled <= r.points),
       "contacts <= candidates <= modelled <= points");
  need(r.model_nx == scene.system.nx && r.model_ny == scene.system.ny && r.left_out == 0, "the answer is of another grid");
  need(r.seconds >= 0 && r.seconds < 1e4 && r.setup_seconds >= 0 && r.setup_seconds < 1e4, "times");
  for (const auto& [key, value] : scene.settings)
    if (key == "stiffness") need(value != "0" || std::isnan(r.stiffness), "a stiffness that was not asked for");
}

void judge_sums(const Case& c, const StepAnswer& answer, const Sums& sums, double target) {
  const Scene& scene = c.scene();
  const rc_result& r = answer.result;
  judge_names(c, r);
  const Real cell = scene.cell_area(), load = cell * sums.p, n = static_cast<Real>(scene.points());
  near(r.load, load, 1e-12L * load, "load");
  near(r.mean_pressure, sums.p / n, 1e-12L * sums.p / n, "mean_pressure");
  near(r.max_pressure, sums.most, 0, "max_pressure");
  near(r.contacts, sums.contacts, 0, "contacts");
  near(r.contact_area, static_cast<Real>(sums.contacts) * cell, 1e-12L * n * cell, "contact_area");
  near(r.area_fraction, static_cast<Real>(sums.contacts) / n, 1e-15L, "area_fraction");
  near(r.points, n, 0, "points");
  const bool hard = scene.hard();
  near(r.capped, hard ? sums.capped : 0, 0, "capped");
  near(r.plastic_volume, hard ? cell * sums.overlap : 0, 1e-12L * cell * sums.overlap, "plastic_volume");
  near(r.tolerance, scene.tol, 1e-6L * static_cast<Real>(scene.tol), "tolerance");  // the option is a text of 12 digits
  for (const double residual : {r.kkt_primal, r.kkt_dual, r.kkt_complementarity, r.kkt_control})
    need(residual >= 0 && residual <= r.tolerance, "a residual of a certified answer is " + number(residual));
  if (scene.control == RC_CONTROL_APPROACH) near(r.approach, target, 0, "approach");
  if (scene.by_load()) {
    const Real wanted = load_of(scene, target);
    near(load, wanted, (static_cast<Real>(r.tolerance) * whole_tol + 1e-12L) * wanted, "load for its target");
  }
  if (scene.control == RC_CONTROL_AREA && std::string(r.note).find("area") == std::string::npos)
    near(r.contact_area, target, std::max<Real>(1e-3L * static_cast<Real>(target), cell * 0.5000001L), "area for its target");
}

}  // namespace

void judge_certified(const Case& c, const Surface& surface, const StepAnswer& answer, double target) {
  const Scene& scene = c.scene();
  const rc_result& r = answer.result;
  const Sums sums = sums_of(c, surface, answer);
  judge_sums(c, answer, sums, target);
  const Reals gap = gap_of(c, surface, answer);
  const Real noise = product_noise(c, surface, answer), tol = r.tolerance,
             allowed = tol * whole_tol * residual_scale(scene, surface, answer, target) + noise, cap = c.cap();
  Real gaps = 0, energy = 0, size = 0, included = 0;
  for (std::size_t i = 0; i < gap.size(); ++i) {
    if (!surface.included(i)) continue;
    const Real p = answer.p[i];
    near(answer.gap[i], gap[i], noise, ("the gap" + at_point(i) + " is").c_str());
    need(gap[i] >= -allowed || p >= cap * (1 - tol * whole_tol), "overlap " + number(gap[i]) + at_point(i));
    need(p <= tol * whole_tol * sums.most || gap[i] <= allowed, "pressure across the gap " + number(gap[i]) + at_point(i));
    gaps += p >= cap ? std::max<Real>(0, gap[i]) : gap[i];
    ++included;
    // 1/2 p'Hp - (d - h)'p, by g = H p + h - d.
    const Real below = static_cast<Real>(r.approach) - static_cast<Real>(surface.gap[i]) -
                       (answer.indentation.empty() ? 0 : static_cast<Real>(answer.indentation[i]));
    energy += p * (gap[i] - below) / 2;
    size += p * (std::abs(gap[i]) + std::abs(below));
  }
  near(r.mean_gap, gaps / included, 2 * noise, "mean_gap");
  const Real cell = scene.cell_area();
  near(r.energy, energy * cell, cell * (1e-12L * size + noise * sums.p), "energy");
}

void judge_residuals(const Case& c, const Surface& surface, const StepAnswer& answer, double target) {
  const Reals gap = gap_of(c, surface, answer);
  const Real scale = residual_scale(c.scene(), surface, answer, target), noise = product_noise(c, surface, answer), cap = c.cap(),
             most = pairs::largest(answer.p);
  if (!(scale > 0)) return;
  Real dual = 0, both = 0, primal = 0, sum = 0;
  for (std::size_t i = 0; i < gap.size(); ++i) {
    if (!surface.included(i)) continue;
    near(answer.gap[i], gap[i], noise, ("the gap" + at_point(i) + " is").c_str());
    const Real p = answer.p[i], room = gap[i] < 0 && cap < HUGE_VALL ? 1 - p / cap : HUGE_VALL;
    sum += p;
    primal = std::max({primal, p < 0 ? -p / most : 0, p / cap - 1});
    if (gap[i] < 0) dual = std::max(dual, std::min(room, -gap[i] / scale));
    if (p > 0) both = std::max(both, std::min({p / most, room, std::abs(gap[i]) / scale}));
  }
  const Real allowed = 2 * noise / scale + 1e-12L;
  near(answer.result.kkt_dual, dual, allowed + 1e-9L * dual, "kkt_dual");
  near(answer.result.kkt_complementarity, both, allowed + 1e-9L * both, "kkt_complementarity");
  near(answer.result.kkt_primal, primal, 1e-14L, "kkt_primal");
  const Real load = static_cast<Real>(c.scene().cell_area()) * sum;
  if (c.scene().by_load() && target > 0) {
    const Real wanted = load_of(c.scene(), target);
    near(answer.result.kkt_control, std::abs(load - wanted) / wanted, 1e-11L * (1 + load / wanted), "kkt_control");
  }
  const rc_result& r = answer.result;
  const double worst = std::max({r.kkt_primal, r.kkt_dual, r.kkt_complementarity, r.kkt_control});
  need(worst <= r.tolerance ? answer.status != RC_UNCERTIFIED : answer.status != RC_OK,
       std::string("residuals of ") + number(worst) + " with " + rc_status_name(answer.status));
}

void need_same_answer(const StepAnswer& found, const StepAnswer& wanted, const std::string& what) {
  need(found.status == wanted.status, what + ": " + rc_status_name(found.status));
  if (found.status < 0) return;
  pairs::check_same(found.p, wanted.p, what + ": p");
  pairs::check_same(found.gap, wanted.gap, what + ": gap");
  rc_result a = found.result;
  const rc_result& b = wanted.result;
  a.seconds = b.seconds;
  a.setup_seconds = b.setup_seconds;
  need(std::memcmp(&a, &b, offsetof(rc_result, solver)) == 0, what + ": a number of the result differs");
  need(std::string(a.solver) == b.solver && std::string(a.backend) == b.backend && std::string(a.kernel) == b.kernel &&
           std::string(a.note) == b.note,
       what + ": a text of the result differs");
}

Verdict judge_exact(const Case& c, const Surface& surface, const StepAnswer& answer, const Exact& exact, double target) {
  if (exact.worth == Worth::unknown) return Verdict::undecidable;
  const Scene& scene = c.scene();
  const Real tol = answer.result.tolerance, noise = product_noise(c, surface, answer),
             allowed = tol * whole_tol * residual_scale(scene, surface, answer, target) + noise, cap = c.cap();
  const Real most = *std::ranges::max_element(answer.p), exact_most = *std::ranges::max_element(exact.p);
  // e = p - p*: e'He = e'(w - w*) is a sum over points, of which tol bounds each.
  const std::size_t n = answer.p.size();
  const bool tied = scene.periodic() && scene.control != RC_CONTROL_APPROACH;
  const Real datum = tied ? c.h()(0, 0) : 0;
  Reals e(n);
  Real total = 0, bound = 0, off = 0;
  bool same = exact.worth == Worth::exact;
  std::vector<bool> loose(n);
  for (const std::size_t i : exact.loose) loose[i] = true;
  for (std::size_t i = 0; i < n; ++i) {
    if (!surface.included(i)) continue;
    const Real p = answer.p[i], w = std::abs(static_cast<Real>(answer.gap[i])) + noise;
    e[i] = p - exact.p[i];
    total += e[i];
    off = std::max(off, std::abs(e[i]));
    // p w, p* w, and with a hardness (c - p) w, each at most what the certificate lets through.
    bound += std::max(std::min(w, allowed) * (p + exact.p[i]), tol * whole_tol * most * w) + noise * (p + exact.p[i]);
    if (cap < HUGE_VALL) bound += allowed * cap + tol * whole_tol * cap * w;
    same = same && loose[i] == (p > 0 && p < cap) && (loose[i] || (p > 0) == (exact.p[i] > 0));
    same = same && (!loose[i] || (p > tol * whole_tol * most && p < cap * (1 - tol * whole_tol)));
  }
  const Reals he = c.h().times(e);
  Real energy = datum * total * total;
  for (std::size_t i = 0; i < n; ++i) energy += e[i] * he[i];
  need(energy <= 2 * bound, "the error's energy is " + number(energy) + ", at most " + number(2 * bound) + " by the tolerance");
  if (exact.worth != Worth::exact || !same) return exact.worth == Worth::soft ? Verdict::undecidable : Verdict::held;
  const Real sharp = exact.inverse * allowed + exact.error;
  need(off <= sharp,
       "p is off by " + number(off) + " of " + number(exact_most) + ", at most " + number(sharp) + " by the tolerance");
  if (!tied && std::isfinite(answer.result.stiffness)) {
    const Real stiffness = exact.stiffness * static_cast<Real>(scene.cell_area());
    near(answer.result.stiffness, stiffness, (tol + 1e-6L) * stiffness, "stiffness");
  }
  return Verdict::held;
}

Verdict judge_intervals(const Case& c, const Surface& surface, const StepAnswer& answer, const Exact& exact) {
  const rc_result& r = answer.result;
  const Scene& scene = c.scene();
  if (std::isnan(r.load_lower)) {
    need(std::isnan(r.load_upper) && std::isnan(r.duality_gap) && r.proven_contacts == -1 && r.proven_open == -1 &&
             r.undecided == -1,
         "nothing is proven, but not all members say so");
    return Verdict::undecidable;
  }
  const Real cell = scene.cell_area();
  near(r.proven_contacts + r.proven_open + r.undecided, static_cast<Real>(r.points), 0, "proven and undecided points");
  near(r.area_lower, static_cast<Real>(r.proven_contacts) * cell, 1e-12L * static_cast<Real>(r.points) * cell, "area_lower");
  near(r.area_upper, static_cast<Real>(r.points - r.proven_open) * cell, 1e-12L * static_cast<Real>(r.points) * cell,
       "area_upper");
  if (!exact.usable()) return Verdict::undecidable;
  const Real load = exact.sum * cell, doubt = 1e-11L * load + static_cast<Real>(exact.p.size()) * exact.error * cell * 1e-3L;
  need(r.load_lower <= load + doubt && load - doubt <= r.load_upper,
       "the load " + number(load) + " is not in " + number(r.load_lower) + " .. " + number(r.load_upper));
  need(r.proven_contacts <= exact.contacts_possible && exact.contacts <= r.proven_contacts + r.undecided,
       std::to_string(exact.contacts) + " contacts, proven " + std::to_string(r.proven_contacts) + ", undecided " +
           std::to_string(r.undecided));
  need(r.proven_capped <= exact.capped_possible,
       std::to_string(exact.capped_possible) + " points at the hardness, proven " + std::to_string(r.proven_capped));
  for (std::size_t i = 0; !std::isnan(r.gap_error) && i < exact.w.size(); ++i) {
    const Real off = std::abs(static_cast<Real>(answer.gap[i]) - exact.w[i]);
    need(!surface.included(i) || off <= static_cast<Real>(r.gap_error) + 2 * product_noise(c, surface, answer),
         "the gap is off by " + number(off) + ", proven are " + number(r.gap_error));
  }
  if (!std::isnan(r.duality_gap)) {
    const bool feasible = *std::ranges::min_element(answer.p) >= 0;
    const Real least = exact.functional * cell, noise = product_noise(c, surface, answer) * static_cast<Real>(r.load),
               room = noise + 1e-12L * std::abs(least) + 1e-9L * static_cast<Real>(r.duality_gap);
    need(!feasible || static_cast<Real>(r.energy) >= least - room,
         "the energy " + number(r.energy) + " is below the least, " + number(least));
    need(static_cast<Real>(r.energy) - least <= static_cast<Real>(r.duality_gap) + room,
         "the energy is " + number(static_cast<Real>(r.energy) - least) + " above the least, duality gap " +
             number(r.duality_gap));
  }
  if (!std::isnan(r.stiffness_lower) && exact.worth == Worth::exact) {
    const Real stiffness = exact.stiffness * cell, rounding = 1e-9L * stiffness;
    need(r.stiffness_lower <= stiffness + rounding && stiffness - rounding <= r.stiffness_upper,
         "the stiffness " + number(stiffness) + " is not in " + number(r.stiffness_lower) + " .. " + number(r.stiffness_upper));
  }
  return Verdict::held;
}

}  // namespace scenes

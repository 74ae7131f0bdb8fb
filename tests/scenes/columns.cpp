#include "columns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>

#include "property.h"

namespace scenes {

namespace {

constexpr std::array names{"load",       "approach",   "contact_area", "mean_gap",   "energy",          "stiffness",
                           "load_lower", "load_upper", "area_lower",   "area_upper", "stiffness_lower", "stiffness_upper",
                           "certificate"};

constexpr std::size_t stiffness = 5, load_lower = 6, stiffness_lower = 10, stiffness_upper = 11;

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0 || (std::isnan(a) && std::isnan(b)); }

}  // namespace

Columns::Columns(std::size_t steps)
    : wanted(names.size(), true),
      reals(names.size(), Field(steps, -7)),
      iterations(steps, -7),
      products(steps, -7),
      status(steps, -7) {}

void Columns::leave_out(Random& random) {
  const bool alone = random.chance(0.5);
  const auto only = static_cast<std::size_t>(random.below(static_cast<std::int64_t>(wanted.size())));
  for (std::size_t i = 0; i < wanted.size(); ++i) wanted[i] = alone ? i == only : random.chance(0.5);
  // With its interval a stiffness is computed to more digits.
  if (wanted[stiffness] && !wanted[stiffness_upper]) wanted[stiffness_lower] = true;
}

pairs::Settings Columns::options(const Scene& scene) const {
  const auto given = [&](const char* name) {
    return std::ranges::find(scene.settings, name, &std::pair<std::string, std::string>::first)->second;
  };
  const bool interval = wanted[stiffness_lower] || wanted[stiffness_upper];
  const bool bounds = interval || std::any_of(wanted.begin() + load_lower, wanted.begin() + stiffness_lower, std::identity());
  const std::string least = interval ? "2" : wanted[stiffness] ? "1" : "0";
  return {{"stiffness", std::max(least, given("stiffness"))}, {"bounds", bounds ? "1" : given("bounds")}};
}

rc_columns Columns::request(std::size_t first) {
  rc_columns columns{};
  rc_array* const all[] = {&columns.load,       &columns.approach,   &columns.contact_area,    &columns.mean_gap,
                           &columns.energy,     &columns.stiffness,  &columns.load_lower,      &columns.load_upper,
                           &columns.area_lower, &columns.area_upper, &columns.stiffness_lower, &columns.stiffness_upper,
                           &columns.certificate};
  for (std::size_t i = 0; i < reals.size(); ++i)
    if (wanted[i]) *all[i] = RC_OUT(reals[i].data() + first);
  columns.iterations = RC_OUT(iterations.data() + first);
  columns.products = RC_OUT(products.data() + first);
  columns.status = RC_OUT(status.data() + first);
  return columns;
}

void Columns::take(std::size_t k, const StepAnswer& answer) {
  const rc_result& r = answer.result;
  const double certificate = std::max({r.kkt_primal, r.kkt_dual, r.kkt_complementarity, r.kkt_control});
  const double values[] = {r.load,       r.approach,   r.contact_area, r.mean_gap,   r.energy,          r.stiffness,
                           r.load_lower, r.load_upper, r.area_lower,   r.area_upper, r.stiffness_lower, r.stiffness_upper,
                           certificate};
  for (std::size_t i = 0; i < reals.size(); ++i) reals[i][k] = values[i];
  iterations[k] = r.iterations;
  products[k] = r.products;
  status[k] = answer.status;
}

void Columns::need_same(const Columns& all, std::size_t first, const std::string& what) const {
  const bool whole = std::ranges::all_of(all.wanted, [](bool each) { return each; });
  for (std::size_t k = 0; k < status.size(); ++k) {
    const std::string step = what + ", step " + std::to_string(k) + ": ";
    const auto same = [&](std::int64_t a, std::int64_t b, const char* name) {
      need(a == b, step + name + " " + std::to_string(b) + " instead of " + std::to_string(a));
    };
    same(status[k], all.status[first + k], "status");
    for (std::size_t i = 0; i < reals.size(); ++i) {
      const double found = all.reals[i][first + k], expected = all.wanted[i] ? reals[i][k] : -7;
      // Other columns that are wanted decide which product computes the gap, and so its rounding.
      const bool rounds = i == mean_gap && !whole && std::abs(found - expected) <= 1e-13 * std::abs(reals[approach][k]);
      need(same_bits(expected, found) || rounds,
           step + names[i] + " " + pairs::text(found) + " differs by " + pairs::text(found - expected));
    }
    same(iterations[k], all.iterations[first + k], "iterations");
    // Intervals of stiffnesses take products.
    if (whole) same(products[k], all.products[first + k], "products");
  }
}

namespace {

// Keeps what it sees, and asks for the points in contact.
std::int32_t keep(std::int64_t step, const rc_result* result, void* user) {
  Pressures& kept = *static_cast<Pressures*>(user);
  const double *const p = static_cast<const double*>(result->p.data), *const gap = static_cast<const double*>(result->gap.data);
  kept.steps.emplace_back(p, p + kept.points);
  kept.gaps.emplace_back(gap, gap + kept.points);
  kept.results.push_back(*result);
  std::vector<std::int64_t> index(kept.points);
  Field pressure(kept.points);
  std::int64_t n = -1;
  const auto room = static_cast<std::int64_t>(kept.points);
  if (rc_contact_points(kept.contact, room, RC_OUT(index.data()), RC_OUT(pressure.data()), &n) != RC_OK) n = 0;
  for (std::int64_t k = 0; k < n; ++k)
    if (!(pressure[static_cast<std::size_t>(k)] > 0) ||
        p[index[static_cast<std::size_t>(k)]] != pressure[static_cast<std::size_t>(k)])
      n = 0;
  kept.results.back().points = n;
  return kept.end > 0 && step + 1 == static_cast<std::int64_t>(kept.end);
}

}  // namespace

rc_status follow(const Case& c, rc_contact* contact, const Field& targets, const Surface& surface, Columns& columns,
                 Pressures& pressures, std::size_t cut, bool virgin) {
  rc_history history = RC_HISTORY_INIT;
  history.control = c.scene().control;
  history.warm_start = c.scene().steps.front().warm;
  history.virgin = virgin;
  history.n = static_cast<std::int64_t>(targets.size());
  history.targets = RC_IN(targets.data());
  history.undeformed_gap = RC_IN(surface.gap.data());
  history.mask = RC_IN(surface.mask.empty() ? nullptr : surface.mask.data());
  history.fn = keep;
  history.user = &pressures;
  history.columns = columns.request();
  pressures.contact = contact;
  pressures.end = cut;
  const rc_status status = rc_contact_solve_history(contact, &history);
  if (cut == 0) return status;
  need(status == RC_STOP_CANCELLED && history.completed == static_cast<std::int64_t>(cut), "fn does not end the history");
  need(std::ranges::all_of(columns.status.begin() + history.completed, columns.status.end(), [](rc_status s) { return s == -7; }),
       "a history that fn ends has written what comes after");
  pressures.end = 0;
  history.n -= history.completed;
  history.targets = RC_IN(targets.data() + cut);
  history.undeformed_gap = history.mask = {};
  history.columns = columns.request(cut);
  return rc_contact_solve_history(contact, &history);
}

}  // namespace scenes

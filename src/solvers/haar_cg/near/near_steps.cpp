#include "solvers/haar_cg/near/near_steps.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <utility>
#include <vector>

#include "core/sums.h"
#include "solvers/haar_cg/near/matrix_loops.h"
#include "solvers/haar_cg/threads/pass_loops.h"

namespace rc {

namespace {

constexpr int most_near_rounds = 6;
constexpr double fall = 0.5;                  // of the residual in a round, at least
constexpr double admission = 0.1;             // of the residual: points that overlap by more join the contact set
constexpr std::size_t share = 16;             // the part of the contact set that may change at once
constexpr std::size_t few_changes = 4;        // points that may change in any case
constexpr std::int64_t most_cells = 1 << 14;  // of the grid: products of larger ones cost more than the contact set
constexpr int near_first = 12;                // steps near each other after which an inverse is made
constexpr std::size_t room = 5;               // the part of the contact set by which it may grow before memory is taken anew

std::size_t contacts_of(std::span<const double> p) {
  return static_cast<std::size_t>(std::count_if(p.begin(), p.end(), [](double value) { return value > 0; }));
}

std::size_t points_of(const Problem& problem) {
  const rc_grid& grid = *problem.grid();
  const bool served = problem.kept() && !problem.ranks() && grid.boundary == RC_BOUNDARY_FREE &&
                      problem.cap() == std::numeric_limits<double>::infinity() && grid.nx * grid.ny <= most_cells &&
                      problem.option_int("resumable") == 0;
  return served ? static_cast<std::size_t>(problem.option_int("haar-cg.inverse")) : 0;
}

double highest_of(const std::vector<double>& u) {
  double lane[8];
  std::fill_n(lane, 8, u.front());
  std::size_t i = 0;
  for (; i + 8 <= u.size(); i += 8)
    for (std::size_t k = 0; k < 8; ++k) lane[k] = lane[k] < u[i + k] ? u[i + k] : lane[k];
  return std::max(*std::max_element(lane, lane + 8), *std::max_element(u.begin() + static_cast<std::ptrdiff_t>(i) - 1, u.end()));
}

void penetrations(const Problem& problem, std::vector<double>& u) {
  const rc_grid& grid = *problem.grid();
  if (!problem.u() && !grid.index && problem.gap().in_double()) {
    best_haar_loops<float, double>().compenetrate(problem.size(), problem.gap().in_double(), grid.approach,
                                                  1 / problem.length_unit(), u.data());
    return;
  }
  for (std::size_t i = 0; i < u.size(); ++i) u[i] = problem.penetration(static_cast<std::int64_t>(i));
}

}  // namespace

// At the present pressures.
struct NearSteps::State {
  std::vector<double> u, w;            // w = H p - u; the gap is that less the datum
  std::vector<std::int64_t> touching;  // unknowns with a pressure, or that overlap
  double datum = 0, residual = 0, load = 0;
  double limit = 0;  // points with a smaller w join the contact set

  // w becomes H p - u. Where the load is prescribed the mean of the gap, weighted by the pressures, vanishes.
  void measure(const std::vector<double>& product, bool by_load, double wanted, double highest, std::span<const double> p) {
    const std::size_t n = p.size();
    for (std::size_t i = 0; i < n; ++i) w[i] = product[i] - u[i];
    const auto list = [&](double below) {
      touching.resize(n);
      touching.resize(best_matrix_loops().list(n, p.data(), w.data(), below, touching.data()));
    };
    const auto sum = [&](const auto& term) {
      return sum_of(touching.size(), [&](std::size_t k) { return term(static_cast<std::size_t>(touching[k])); });
    };
    if (by_load) {
      list(-std::numeric_limits<double>::infinity());
      load = sum([&](std::size_t i) { return p[i]; });
      datum = sum([&](std::size_t i) { return p[i] * w[i]; }) / load;
    }
    list(datum);
    double worst = 0;
    for (const std::int64_t k : touching) worst = std::max(worst, std::abs(w[static_cast<std::size_t>(k)] - datum));
    residual = by_load
                   ? std::max(worst / std::max(datum + highest, std::numeric_limits<double>::min()), std::abs(load / wanted - 1))
                   : worst;
    limit = datum - admission * worst;
  }
  // Whether a point with pressure p remains in contact: its gap reduces the pressure by less than p.
  bool stays(std::size_t i, double p, double stiff) const { return p > stiff * (w[i] - datum); }
};

NearSteps::NearSteps(const Problem& problem) : problem_(problem), most_(points_of(problem)) {
  if (most_ == 0 || !problem.kept()->last) return;
  Kept& last = *static_cast<Kept*>(problem.kept()->last);
  kept_ = {last.contacts, last.near, std::move(last.inverse), {}, {}};
}

void NearSteps::keep(std::span<const double> p) {
  if (most_ == 0) return;
  const std::size_t n = contacts_of(p), changed = std::max(n, kept_.contacts) - std::min(n, kept_.contacts);
  kept_.near = n > 0 && n <= most_ && changed * share <= n ? kept_.near + 1 : 0;
  kept_.contacts = n;
  if (kept_.near == 0) kept_.inverse.reset();
  if (!product_.empty() && !problem_.grid()->index) {
    kept_.p.assign(p.begin(), p.end());
    for (double& value : kept_.p) value *= problem_.pressure_unit();
    kept_.product = std::move(product_);
    for (double& value : kept_.product) value *= problem_.length_unit();
  }
  problem_.kept()->keep(problem_.kept(), new Kept(std::move(kept_)), [](void* object) { delete static_cast<Kept*>(object); });
}

// H p of a start that is made of two steps, whose products are known. Pressures that would have been negative are not.
bool NearSteps::know_product(std::span<const double> p, std::vector<double>& product) const {
  const rc_kept_steps& history = *problem_.kept();
  if (!history.last || !history.before) return false;
  const Kept &last = *static_cast<const Kept*>(history.last), &before = *static_cast<const Kept*>(history.before);
  if (last.p.size() != p.size() || before.p.size() != p.size() || problem_.grid()->index) return false;
  const double ahead = history.ahead, per_pressure = 1 / problem_.pressure_unit(), per_length = 1 / problem_.length_unit();
  std::size_t raised = 0;
  for (std::size_t i = 0; i < p.size(); ++i) raised += last.p[i] + ahead * (last.p[i] - before.p[i]) < 0 ? 1 : 0;
  if (raised > few_changes) return false;
  for (std::size_t i = 0; i < p.size(); ++i)
    product[i] = (last.product[i] + ahead * (last.product[i] - before.product[i])) * per_length;
  for (std::size_t i = 0; i < p.size() && raised > 0; ++i) {
    const double given = last.p[i] + ahead * (last.p[i] - before.p[i]);
    if (!(given < 0)) continue;
    --raised;
    kept_.inverse->add_column(static_cast<std::int64_t>(i), -given * per_pressure, product);
  }
  return true;
}

// False if there are too many points, or no memory and the step may go on without.
bool NearSteps::make_inverse(std::span<const double> p) {
  try {
    return inverse_made(p);
  } catch (const std::bad_alloc&) {
    if (!problem_.may_go_without()) throw;
  } catch (const roughcontact::Failure& failure) {
    if (failure.code != RC_ERR_MEMORY || !problem_.may_go_without()) throw;
  }
  return false;
}

bool NearSteps::inverse_made(std::span<const double> p) {
  const rc_grid& grid = *problem_.grid();
  const std::size_t n = contacts_of(p);
  if (n == 0 || n > most_) return false;
  Vector coupling;
  problem_.coefficients(grid.nx, grid.ny, coupling);
  kept_.inverse = std::make_unique<ContactInverse>(grid.nx, grid.ny, coupling, n + n / room + few_changes);
  for (std::size_t i = 0; i < p.size(); ++i)
    if (p[i] > 0 && !kept_.inverse->add(problem_.point(static_cast<std::int64_t>(i)))) return false;
  return true;
}

// Gives the inverse the contact set and takes the pressure from the points that leave it, with which the gaps change. False where
// the set changes by too much.
bool NearSteps::change_set(State& state, std::span<double> p) {
  ContactInverse& inverse = *kept_.inverse;
  const double stiff = 1 / inverse.coupling(0, 0);
  std::vector<std::int64_t> joining, leaving, contact;
  std::vector<std::pair<std::int64_t, double>> released;
  std::vector<std::uint8_t> stays(inverse.size());
  for (const std::int64_t k : state.touching) {
    const auto i = static_cast<std::size_t>(k);
    const std::int64_t point = problem_.point(k);
    const bool had = inverse.has(point), in = p[i] > 0 ? had || state.stays(i, p[i], stiff) : state.w[i] < state.limit;
    if (!in) {
      if (p[i] > 0) released.emplace_back(point, std::exchange(p[i], 0.0));
      continue;
    }
    contact.push_back(k);
    if (had)
      stays[inverse.place(point)] = 1;
    else
      joining.push_back(point);
  }
  for (std::size_t k = 0; k < stays.size(); ++k)
    if (!stays[k]) leaving.push_back(inverse.point(k));
  if (joining.size() + leaving.size() > few_changes + inverse.size() / share) return false;
  for (const std::int64_t point : leaving) inverse.remove(point);
  state.touching = std::move(contact);
  for (const auto& [point, pressure] : released) {
    state.load -= pressure;
    for (const std::int64_t k : state.touching)
      state.w[static_cast<std::size_t>(k)] -= inverse.coupling(point, problem_.point(k)) * pressure;
  }
  return std::all_of(joining.begin(), joining.end(), [&](std::int64_t point) { return inverse.add(point); });
}

// By load the datum becomes the one at which the pressures have the load wanted.
void NearSteps::correct(const State& state, std::span<double> p) {
  const ContactInverse& inverse = *kept_.inverse;
  const bool by_load = problem_.load_control();
  const std::size_t n = inverse.size();
  std::vector<float> gap(inverse.padded()), change(inverse.padded()), one(by_load ? inverse.padded() : 0), rate(one.size());
  for (const std::int64_t k : state.touching)
    gap[inverse.place(problem_.point(k))] = static_cast<float>(state.datum - state.w[static_cast<std::size_t>(k)]);
  std::fill_n(one.begin(), by_load ? n : 0, 1.0F);
  inverse.multiply(gap, change, by_load ? &one : nullptr, &rate);
  if (by_load) {
    const auto sum = [&](const std::vector<float>& x) {
      return sum_of(n, [&](std::size_t i) { return static_cast<double>(x[i]); });
    };
    const auto rise = static_cast<float>((problem_.load() - state.load - sum(change)) / sum(rate));
    for (std::size_t k = 0; k < n; ++k) change[k] += rise * rate[k];
  }
  for (const std::int64_t k : state.touching) {
    const auto i = static_cast<std::size_t>(k);
    p[i] = std::max(0.0, p[i] + static_cast<double>(change[inverse.place(problem_.point(k))]));
  }
}

bool NearSteps::solve(std::span<double> p, double& d) {
  if (most_ == 0 || kept_.near < near_first) return false;
  const bool by_load = problem_.load_control();
  if (!kept_.inverse && !make_inverse(p)) return kept_.near = 0, kept_.inverse.reset(), false;
  State state;
  state.u.resize(p.size());
  state.w.resize(p.size());
  product_.resize(p.size());
  penetrations(problem_, state.u);
  const double highest = by_load ? highest_of(state.u) : 0;
  bool known = know_product(p, product_);
  const double given = d;
  double before = std::numeric_limits<double>::infinity();
  for (int round = 0; round <= most_near_rounds; ++round) {
    if (round > 0) problem_.poll(round, state.residual);
    if (!known) problem_.apply(p.data(), product_.data());
    state.measure(product_, by_load, problem_.load(), highest, p);
    d = state.datum;
    if (state.residual <= problem_.tol()) {
      if (known) product_ = {};  // the next step would add to its errors
      return true;
    }
    known = false;
    if (!(state.residual < fall * before) || !change_set(state, p)) break;
    correct(state, p);
    if (round > 0) before = state.residual;
  }
  d = given;  // there is none if no pressure is left
  kept_.near = 0;
  kept_.inverse.reset();
  product_ = {};
  return false;
}

}  // namespace rc

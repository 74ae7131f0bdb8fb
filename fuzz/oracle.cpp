#include "oracle.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "exact.h"
#include "require.h"

namespace fuzz {

namespace {

constexpr std::uint64_t pattern = 0x7ff8dead0badf00d;  // a NaN of our own
constexpr Real least_double = 5e-324L;
constexpr Real epsilon = std::numeric_limits<double>::epsilon();

bool documented(rc_status status) {
  switch (status) {
    case RC_OK:
    case RC_STOP_MAX_ITER:
    case RC_STOP_TIME:
    case RC_STOP_CANCELLED:
    case RC_STOP_STALLED:
    case RC_UNCERTIFIED:
    case RC_WITHIN_GOAL:
    case RC_ERR_ARGUMENT:
    case RC_ERR_SHAPE:
    case RC_ERR_OPTION:
    case RC_ERR_NO_BACKEND:
    case RC_ERR_NO_SOLVER:
    case RC_ERR_INCOMPATIBLE:
    case RC_ERR_MEMORY:
    case RC_ERR_INFEASIBLE:
    case RC_ERR_NUMERIC:
    case RC_ERR_EXTERNAL:
      return true;
    default:
      return false;  // statuses of plugins, other threads and defects must not occur here
  }
}

bool near(Real value, Real wanted, Real allowed) { return std::abs(value - wanted) <= allowed; }

}  // namespace

Answer::Answer(std::size_t points) : p(points, std::bit_cast<double>(pattern)), gap(points, std::bit_cast<double>(pattern)) {
  result = RC_RESULT_INIT;
  result.p.data = p.data();
  result.gap.data = gap.data();
}

bool Answer::untouched() const {
  const auto same = [](double value) { return std::bit_cast<std::uint64_t>(value) == pattern; };
  return std::ranges::all_of(p, same) && std::ranges::all_of(gap, same);
}

void Answer::took(rc_status returned) {
  status = returned;
  explained = rc_last_error()[0] != '\0';
}

// Facts that all checks need, in extended precision: the exact pressures are those at the returned approach.
struct Oracle::Parts {
  std::vector<bool> open;
  std::vector<Real> u;
  std::optional<std::vector<Real>> exact;
  Real largest_p = 0, largest_row = 0;  // of the sums of |H| along a row
  Real noise = 0;                       // of a gap
  Real scale = 0;                       // of the residuals
};

void Oracle::check(const Problem& problem, const Answer& answer) const {
  require(documented(answer.status), "a status that this call may have");
  if (answer.status < 0) {
    require(answer.untouched(), "a failed call writes neither p nor gap");
    require(answer.explained, "a failed call says why");
    return;
  }
  require(answer.explained == (answer.status != RC_OK && answer.status != RC_WITHIN_GOAL), "what is not certified says why");
  require(answer.result.status == answer.status, "the result's status is the returned one");
  require(answer.status != RC_WITHIN_GOAL || scene_.system.hardness == 0, "with a hardness the whole grid is solved");
  check_sums(problem, answer);
  if (!h_ || answer.status == RC_WITHIN_GOAL) return;
  Parts parts;
  check_residuals(problem, answer, parts);
  check_intervals(answer, parts);
}

Real Oracle::cap() const {
  return scene_.system.hardness > 0 ? static_cast<Real>(scene_.system.hardness) : std::numeric_limits<Real>::infinity();
}

// By how much two products with H may differ, relative to the largest entry. With some options the backend fft transforms in
// single precision: fft.precision=single, or a goal of accuracy.
Real Oracle::round_off() const {
  const auto single = [](const auto& option) { return option.first == RC_OPT_ACCURACY || option.second == "single"; };
  return std::ranges::any_of(scene_.options, single) ? 5e-7L : 2e-11L;
}

void Oracle::check_sums(const Problem& problem, const Answer& answer) const {
  const rc_result& r = answer.result;
  const std::size_t n = answer.p.size();
  const Real area = static_cast<Real>(scene_.system.hx) * static_cast<Real>(scene_.system.hy);
  Real sum = 0, sizes = 0;
  const Real hardness = cap();
  Real overlap = 0;
  std::int64_t contacts = 0, capped = 0;
  for (std::size_t i = 0; i < n; ++i) {
    require(std::isfinite(answer.p[i]), "pressures are finite");
    const bool open = !problem.mask || problem.mask[i] != 0;
    require(open || answer.p[i] == 0, "no pressure under the mask");
    require(!open || std::isfinite(answer.gap[i]), "gaps are finite");
    sum += static_cast<Real>(answer.p[i]);
    sizes += std::abs(static_cast<Real>(answer.p[i]));
    contacts += answer.p[i] > 0;
    const Real most = !answer.given ? hardness : hardness * (1 + static_cast<Real>(r.tolerance) * (1 + 1e-6L));
    require(static_cast<Real>(answer.p[i]) <= most || (answer.given && answer.status != RC_OK),
            "no pressure exceeds the hardness");
    if (!open || static_cast<Real>(answer.p[i]) < hardness) continue;
    ++capped;
    overlap += std::max<Real>(0, -static_cast<Real>(answer.gap[i]));
  }
  require(r.capped == capped, "capped are the points at the hardness");
  require(near(r.plastic_volume, area * overlap, 1e-12L * area * overlap + (area + 1) * 64 * least_double), "plastic volume");
  require(r.points == static_cast<std::int64_t>(n) && r.contacts == contacts, "contacts are the points with pressure");
  require(near(r.load, area * sum, 1e-12L * area * sizes + (area + 1) * 64 * least_double),
          "the load is the sum of the pressures");
  require(near(r.contact_area, static_cast<Real>(contacts) * area, 1e-12L * static_cast<Real>(contacts) * area), "contact area");
  require(std::isfinite(r.energy) && std::isfinite(r.approach), "energy and approach are finite");
  require(problem.control == RC_CONTROL_LOAD || r.approach == problem.target, "the approach is the prescribed one");
  if (answer.status != RC_OK) return;
  require(r.kkt_primal <= r.tolerance && r.kkt_dual <= r.tolerance && r.kkt_complementarity <= r.tolerance &&
              r.kkt_control <= r.tolerance,
          "a certified answer's residuals are within the tolerance");
  if (problem.control == RC_CONTROL_LOAD) {
    const Real wanted = problem.target;
    require(near(area * sum, wanted, (static_cast<Real>(r.tolerance) + 1e-12L) * wanted + (area + 1) * 64 * least_double),
            "the load is the wanted one");
  }
}

void Oracle::check_residuals(const Problem& problem, const Answer& answer, Parts& parts) const {
  const rc_result& r = answer.result;
  const std::size_t n = answer.p.size();
  const auto& h = *h_;
  const Real approach = r.approach;
  Real highest = 0, deepest = 0;
  parts.open.resize(n);
  parts.u.assign(n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    parts.open[i] = !problem.mask || problem.mask[i] != 0;
    parts.largest_p = std::max(parts.largest_p, std::abs(static_cast<Real>(answer.p[i])));
    if (!parts.open[i]) continue;
    parts.u[i] = approach - static_cast<Real>(problem.gap[i]);
    deepest = std::max(deepest, parts.u[i]);
    highest = std::max(highest, std::abs(static_cast<Real>(problem.gap[i])));
    Real row = 0;
    for (std::size_t j = 0; j < n; ++j) row += std::abs(h[i * n + j]);
    parts.largest_row = std::max(parts.largest_row, row);
  }
  parts.exact = exact_pressures(h, parts.u, parts.open, cap());
  parts.noise = round_off() * parts.largest_row * parts.largest_p + 8 * epsilon * (highest + std::abs(approach)) +
                64 * least_double * (1 + parts.largest_row);

  // Residuals are relative to the penetration. With periodic boundaries, where it may vanish beside the deflections, they are
  // relative to a deflection under the exact pressures, so that a wrong answer cannot loosen its own test.
  parts.scale = deepest;
  const rc_system& s = scene_.system;
  if (s.op == RC_OPERATOR_HALFSPACE && s.boundary == RC_BOUNDARY_PERIODIC) {
    Real largest = parts.largest_p;
    if (parts.exact && problem.control == RC_CONTROL_APPROACH)
      largest = std::min(largest, 2 * *std::ranges::max_element(*parts.exact));
    const Real side = std::sqrt(static_cast<Real>(s.hx)) * std::sqrt(static_cast<Real>(s.hy));
    parts.scale = std::max(parts.scale, largest * side / static_cast<Real>(s.modulus) / 4);
  }

  const Real tol = r.tolerance, allowed = tol * (1 + 1e-6L) * parts.scale + parts.noise;
  Real work = 0;
  for (std::size_t i = 0; i < n; ++i) {
    Real product = 0;
    for (std::size_t j = 0; j < n; ++j) product += h[i * n + j] * static_cast<Real>(answer.p[j]);
    work += product * static_cast<Real>(answer.p[i]);
    if (!parts.open[i]) continue;
    const Real gap = product - parts.u[i];
    require(near(answer.gap[i], gap, parts.noise), "the gap is H p + h - d");
    if (answer.status != RC_OK) continue;
    require(static_cast<Real>(answer.p[i]) >= -tol * parts.largest_p, "certified: no point pulls");
    require(gap >= -allowed || static_cast<Real>(answer.p[i]) >= cap() * (1 - tol * (1 + 1e-6L)),
            "certified: no point below the hardness overlaps");
    require(static_cast<Real>(answer.p[i]) <= tol * (1 + 1e-6L) * parts.largest_p || gap <= allowed,
            "certified: no pressure across a gap");
  }
  const Real least = -round_off() * parts.largest_row * parts.largest_p * parts.largest_p;
  require(answer.status != RC_OK || parts.largest_p == 0 || work >= least, "certified: p'Hp is not negative");
}

void Oracle::check_intervals(const Answer& answer, const Parts& parts) const {
  const rc_result& r = answer.result;
  if (std::isnan(r.load_lower) || !parts.exact) return;
  // For matrices next to singular the exact answer is not known to enough digits.
  if (parts.scale > 0 && parts.noise > parts.scale) return;
  const std::size_t n = answer.p.size();
  const auto& h = *h_;
  const auto& exact = *parts.exact;
  const Real area = static_cast<Real>(scene_.system.hx) * static_cast<Real>(scene_.system.hy);
  const Real largest = std::max(parts.largest_p, *std::ranges::max_element(exact));

  // Points at which both pressure and gap vanish to rounding may count as in contact or not.
  Real load = 0, energy = 0, returned = 0;
  std::int64_t contacts = 0, surely = 0, open = 0, capped = 0;
  for (std::size_t i = 0; i < n; ++i) {
    Real product = 0, own = 0;
    for (std::size_t j = 0; j < n; ++j) {
      product += h[i * n + j] * exact[j];
      own += h[i * n + j] * static_cast<Real>(answer.p[j]);
    }
    load += exact[i];
    energy += (product / 2 - parts.u[i]) * exact[i];
    returned += (own / 2 - parts.u[i]) * static_cast<Real>(answer.p[i]);
    const bool clearly_in = exact[i] > 1e-9L * largest;
    const bool clearly_out = !parts.open[i] || (exact[i] == 0 && product - parts.u[i] > 1e-9L * parts.scale + parts.noise);
    surely += clearly_in;
    capped += exact[i] >= cap() * (1 - 1e-9L);
    contacts += clearly_in || !clearly_out;
    open += clearly_out || !clearly_in;
  }
  const Real slack = 1e-9L * static_cast<Real>(n) * largest * area + (area + 1) * 64 * least_double;
  require(static_cast<Real>(r.load_lower) <= load * area + slack && load * area <= static_cast<Real>(r.load_upper) + slack,
          "the exact load lies in its interval");
  require(r.proven_capped <= capped, "points proven to carry the hardness do");
  require(r.proven_contacts <= contacts && r.proven_open <= open, "what is proven of points is so");
  require(r.proven_contacts + r.proven_open + r.undecided == r.points, "every point is counted once");
  require(static_cast<Real>(r.area_lower) <= static_cast<Real>(contacts) * area * (1 + 1e-12L) &&
              static_cast<Real>(surely) * area <= static_cast<Real>(r.area_upper) * (1 + 1e-12L),
          "the exact area lies in its interval");
  if (std::isnan(r.duality_gap)) return;
  const Real room = static_cast<Real>(n) * (parts.noise * largest + 1e-9L * parts.scale * largest) * area + 64 * least_double;
  require((returned - energy) * area <= static_cast<Real>(r.duality_gap) + room,
          "the energy is within the duality gap of the least");
}

}  // namespace fuzz

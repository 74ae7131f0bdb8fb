// Histogram of pressures: by hand, sums, and Hertz's distribution.
#include <cmath>
#include <numeric>

#include "maps.h"

namespace analysis {

namespace {

using namespace pairs;

void check_counts(const Histogram& found, const std::vector<std::int64_t>& expected) {
  for (std::size_t k = 0; k < expected.size(); ++k)
    check_equal(found.counts[k], expected[k], "counts[" + std::to_string(k) + "]");
}

void bins_hold_their_upper_ends() {
  const Map map = drawn({"0124", "3.4."});
  const Histogram all = histogram_of(map, 4, 0);
  check_counts(all, {1, 1, 1, 2});
  check_near(all.said.width, 1, 0, "width");
  check_equal(all.said.contacts, 5, "contacts");
  check_equal(all.said.above, 0, "above");
  check_near(all.said.mean_pressure, 2.8, 1e-15, "mean pressure");
  check_near(all.said.max_pressure, 4, 0, "largest pressure");
  check_near(all.density, {0.2, 0.2, 0.2, 0.4}, 1e-15, "density");
  const Histogram low = histogram_of(map, 4, 2);
  check_counts(low, {0, 1, 0, 1});
  check_near(low.said.width, 0.5, 0, "width");
  check_equal(low.said.above, 3, "above");
  check_near(low.density, {0, 0.4, 0, 0.4}, 1e-15, "density");
}

void everything_is_counted_once() {
  std::mt19937_64 random(5);
  for (const double share : {0.01, 0.3, 1.0})
    for (const double masked : {0.0, 0.2})
      for (const double upper : {0.0, 0.37, 5.0}) {
        const Map map = random_map(37, 29, RC_BOUNDARY_FREE, share, masked, random);
        const Histogram found = histogram_of(map, 17, upper);
        check_equal(std::accumulate(found.counts.begin(), found.counts.end(), found.said.above), found.said.contacts, "counts");
        check_equal(found.said.contacts, area_of(map).contacts, "contacts");
        const double shares = sum(found.density) * found.said.width +
                              static_cast<double>(found.said.above) / static_cast<double>(found.said.contacts);
        check_near(shares, 1, 1e-14, "sum of the shares");
        for (std::size_t k = 0; k < 17; ++k) {
          const double low = static_cast<double>(k) * found.said.width, end = upper > 0 ? upper : found.said.max_pressure;
          const double high = k == 16 ? end : static_cast<double>(k + 1) * found.said.width;
          std::int64_t inside = 0;
          for (std::size_t i = 0; i < map.points(); ++i)
            inside += map.touches(static_cast<std::int64_t>(i)) && map.p[i] > low && map.p[i] <= high;
          check_equal(found.counts[k], inside, "points between the edges");
        }
      }
}

void no_contact_is_zero() {
  const Map map = drawn({"...", "x.."});
  for (const double upper : {0.0, 2.0}) {
    const Histogram found = histogram_of(map, 2, upper);
    check_counts(found, {0, 0});
    check_near(found.density, {0, 0}, 0, "density");
    check_near(found.said.width, upper / 2, 0, "width");
    check_equal(found.said.contacts + found.said.above, 0, "contacts");
    check_near(found.said.mean_pressure + found.said.max_pressure, 0, 0, "pressures");
  }
}

// Hertz's pressure p0 sqrt(1 - r^2/a^2) is below p on a share p^2/p0^2 of the area.
void hertz_pressures_have_a_linear_density() {
  constexpr std::int64_t n = 401, bins = 10;
  constexpr double radius = 180, p0 = 3;
  Map map;
  map.system.nx = map.system.ny = n;
  for (std::int64_t i = 0; i < n * n; ++i) {
    const double r = std::hypot(static_cast<double>(i % n - n / 2), static_cast<double>(i / n - n / 2)) / radius;
    map.p.push_back(r < 1 ? p0 * std::sqrt(1 - r * r) : 0);
  }
  const Histogram found = histogram_of(map, bins, p0);
  for (std::size_t k = 0; k < bins; ++k) {
    const double middle = (static_cast<double>(k) + 0.5) * found.said.width;
    check_near(found.density[k], 2 * middle / (p0 * p0), 0.005 * 2 / p0, "density");
  }
  check_near(found.said.mean_pressure, 2 * p0 / 3, 1e-3, "mean pressure");
}

void arrays_may_be_left_out() {
  const Map map = drawn({"0124", "3.4."});
  rc_histogram said = RC_HISTOGRAM_INIT;
  said.bins = 3;
  check(rc_histogram_fill(&map.system, RC_IN(map.p.data()), {}, &said) == RC_OK, rc_last_error());
  check_equal(said.contacts, 5, "contacts");
  Field density(3, -7);
  said.density = RC_OUT(density.data());
  check(rc_histogram_fill(&map.system, RC_IN(map.p.data()), {}, &said) == RC_OK, rc_last_error());
  check_near(sum(density) * said.width, 1, 1e-15, "sum of the shares");
}

}  // namespace

std::vector<Test> histogram_tests() {
  return {{"bins_hold_their_upper_ends", bins_hold_their_upper_ends},
          {"every_point_in_contact_is_counted_once", everything_is_counted_once},
          {"no_contact_has_no_density", no_contact_is_zero},
          {"pressures_of_hertz_have_a_linear_density", hertz_pressures_have_a_linear_density},
          {"arrays_may_be_left_out", arrays_may_be_left_out}};
}

}  // namespace analysis

// The textbook method as it was published: I. A. Polonsky, L. M. Keer, "A numerical method for solving rough contact
// problems based on the multi-level multi-summation and conjugate gradient techniques", Wear 231 (1999) 206-219, section 3.2,
// with two products an iteration, here by a padded transform.
#include <cmath>

#include "padded_product.h"

namespace {

using namespace bench;

struct Sums {
  double a = 0, b = 0;
};

// The largest of dual and complementarity residuals of pressures p whose deformed gap is g, as docs/certificate.md defines them.
double residual_of(const std::vector<double>& p, const std::vector<double>& g, const double* gap, double approach) {
  const double highest = *std::max_element(p.begin(), p.end());
  const double depth = approach - *std::min_element(gap, gap + p.size());
  if (!(highest > 0) || !(depth > 0)) return INFINITY;
  double worst = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
    worst = std::max({worst, -g[i] / depth, std::min(p[i] / highest, std::abs(g[i]) / depth)});
  return worst;
}

}  // namespace

extern "C" {

// The textbook method on n x n cells of the unit square, contact modulus 1, for at most `most` iterations. After each product
// with p, while the clock stands still, look(products, p, residual, seconds of the iterations) says whether to go on: the
// stopping test is the caller's and costs this method nothing. wisdom: file of FFTW's plans, kept from run to run. times: seconds
// of set-up, and of planning as a part of it.
const char* bench_polonsky_keer(std::int64_t n, const double* gap, std::int64_t load_control, double target, std::int64_t threads,
                                std::int64_t most, double planning_limit, const char* wisdom, double* times,
                                int (*look)(std::int64_t products, const double* p, double residual, double seconds)) {
  return guarded([&] {
    const auto begun = Clock::now();
    fftw_init_threads();
    fftw_import_wisdom_from_filename(wisdom);
    PaddedProduct<double> product(n, threads, FFTW_MEASURE, planning_limit);
    times[0] = seconds_since(begun);
    times[1] = product.planning_seconds();
    fftw_export_wisdom_to_filename(wisdom);

    // The sums of each(i, sums) over all points.
    const auto over = [&](const auto& each) {
      std::vector<Sums> parts(static_cast<std::size_t>(threads));
      in_parallel(n * n, threads, [&](std::size_t thread, std::int64_t first, std::int64_t last) {
        Sums sums;
        for (std::int64_t i = first; i < last; ++i) each(static_cast<std::size_t>(i), sums);
        parts[thread] = sums;
      });
      Sums total;
      for (const Sums& part : parts) total = {total.a + part.a, total.b + part.b};
      return total;
    };
    const double side = 1 / static_cast<double>(n), cell = side * side;
    auto resumed = Clock::now();
    const std::size_t size = static_cast<std::size_t>(n * n);
    std::vector<double> p(size, target), g(size), t(size), r(size);
    if (!load_control)  // pressure where the undeformed surfaces overlap, of the size that a flat punch would need
      over([&](std::size_t i, Sums&) { p[i] = std::max(0.0, target - gap[i]); });
    double seconds = 0, approach = target, conjugate = 0, last_sum = 1;
    for (std::int64_t iteration = 0; iteration < most; ++iteration) {
      product.multiply(p.data(), g.data());
      const Sums contact = over([&](std::size_t i, Sums& sums) {
        g[i] = side * g[i] + gap[i];
        if (p[i] > 0) sums = {sums.a + g[i], sums.b + 1};
      });
      if (load_control) approach = contact.a / contact.b;
      const Sums square = over([&](std::size_t i, Sums& sums) {
        g[i] -= approach;
        if (p[i] > 0) sums.a += g[i] * g[i];
      });
      seconds += seconds_since(resumed);
      if (look(2 * iteration + 1, p.data(), residual_of(p, g, gap, approach), seconds) == 0) return;
      resumed = Clock::now();

      const double ratio = conjugate * (square.a / last_sum);
      over([&](std::size_t i, Sums&) { t[i] = p[i] > 0 ? g[i] + ratio * t[i] : 0.0; });
      last_sum = square.a;
      product.multiply(t.data(), r.data());
      double mean = 0;
      if (load_control) mean = over([&](std::size_t i, Sums& sums) { sums.a += p[i] > 0 ? r[i] : 0; }).a / contact.b;
      const Sums slope = over([&](std::size_t i, Sums& sums) {
        if (p[i] > 0) sums = {sums.a + g[i] * t[i], sums.b + (r[i] - mean) * t[i]};
      });
      const double step = slope.a / (side * slope.b);
      const Sums taken = over([&](std::size_t i, Sums& sums) {  // a: pressure, b: cells that came into contact
        if (p[i] > 0) p[i] = std::max(0.0, p[i] - step * t[i]);
        if (p[i] == 0 && g[i] < 0) {
          p[i] = -step * g[i];
          ++sums.b;
        }
        sums.a += p[i];
      });
      conjugate = taken.b > 0 ? 0 : 1;
      const double scale = load_control ? target / (cell * taken.a) : 1;
      if (load_control) over([&](std::size_t i, Sums&) { p[i] *= scale; });
    }
  });
}

}  // extern "C"

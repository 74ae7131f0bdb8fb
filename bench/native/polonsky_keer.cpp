// The field's standard method as it was published: I. A. Polonsky, L. M. Keer, "A numerical method for solving rough contact
// problems based on the multi-level multi-summation and conjugate gradient techniques", Wear 231 (1999) 206-219, section 3.2,
// with two products an iteration, here by a padded transform.
#include <algorithm>
#include <cmath>
#include <functional>
#include <thread>

#include "guarded.h"
#include "padded_product.h"

namespace bench {

namespace {

struct StandardProblem {
  std::int64_t n = 0;           // cells a side of the unit square; contact modulus 1
  const double* gap = nullptr;  // [n*n]
  bool load_control = true;
  double target = 0;  // load, or approach
};

// What a caller may look at after each product with p, while the clock stands still.
struct StandardState {
  std::int64_t iteration, products;
  const std::vector<double>& p;
  double residual;  // the largest of dual and complementarity residuals, as roughcontact's certificate defines them
  double seconds;   // of the iterations so far
};

struct Sums {
  double a = 0, b = 0;
};

// The sums of work(first, last) over equal shares of n points.
template <class Work> Sums in_parallel(std::int64_t n, int threads, const Work& work) {
  std::vector<Sums> parts(static_cast<std::size_t>(threads));
  {
    std::vector<std::jthread> helpers;
    for (int t = 1; t < threads; ++t)
      helpers.emplace_back([&, t] { parts[static_cast<std::size_t>(t)] = work(n * t / threads, n * (t + 1) / threads); });
    parts[0] = work(0, n / threads);
  }
  Sums total;
  for (const Sums& part : parts) {
    total.a += part.a;
    total.b += part.b;
  }
  return total;
}

// The largest residual of pressures p whose deformed gap is g, as docs/certificate.md defines it.
double residual_of(const std::vector<double>& p, const std::vector<double>& g, const double* gap, double approach) {
  const double highest = *std::max_element(p.begin(), p.end());
  const double depth = approach - *std::min_element(gap, gap + p.size());
  if (!(highest > 0) || !(depth > 0)) return INFINITY;
  double worst = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
    worst = std::max({worst, -g[i] / depth, std::min(p[i] / highest, std::abs(g[i]) / depth)});
  return worst;
}

// Goes on until `look` returns false or after `most` iterations. The stopping test is the caller's: it costs this method nothing.
void polonsky_keer(const StandardProblem& problem, PaddedProduct& product, int threads, std::int64_t most,
                   const std::function<bool(const StandardState&)>& look) {
  const std::int64_t points = problem.n * problem.n;
  const double side = 1 / static_cast<double>(problem.n), cell = side * side;
  const double* const gap = problem.gap;
  const auto share = [&](const auto& work) { return in_parallel(points, threads, work); };
  const auto at = [](std::int64_t i) { return static_cast<std::size_t>(i); };

  auto resumed = Clock::now();
  double seconds = 0, approach = problem.target;
  const std::size_t size = at(points);
  std::vector<double> p(size, problem.load_control ? problem.target : 0.0), g(size), t(size), r(size);
  if (!problem.load_control)  // pressure where the undeformed surfaces overlap, of the size that a flat punch would need
    for (std::size_t i = 0; i < size; ++i) p[i] = std::max(0.0, problem.target - gap[i]);
  double conjugate = 0, last_sum = 1;
  for (std::int64_t iteration = 0; iteration < most; ++iteration) {
    product.multiply(p.data(), g.data());
    const Sums contact = share([&](std::int64_t first, std::int64_t last) {
      Sums sums;
      for (std::int64_t i = first; i < last; ++i) {
        g[at(i)] = side * g[at(i)] + gap[at(i)];
        if (p[at(i)] > 0) {
          sums.a += g[at(i)];
          ++sums.b;
        }
      }
      return sums;
    });
    if (problem.load_control) approach = contact.a / contact.b;
    const double sum = share([&](std::int64_t first, std::int64_t last) {
                         Sums sums;
                         for (std::int64_t i = first; i < last; ++i) {
                           g[at(i)] -= approach;
                           if (p[at(i)] > 0) sums.a += g[at(i)] * g[at(i)];
                         }
                         return sums;
                       }).a;
    seconds += seconds_since(resumed);
    if (!look({iteration, 2 * iteration + 1, p, residual_of(p, g, gap, approach), seconds})) return;
    resumed = Clock::now();

    share([&](std::int64_t first, std::int64_t last) {
      for (std::int64_t i = first; i < last; ++i)
        t[at(i)] = p[at(i)] > 0 ? g[at(i)] + conjugate * (sum / last_sum) * t[at(i)] : 0.0;
      return Sums{};
    });
    last_sum = sum;
    product.multiply(t.data(), r.data());
    double mean = 0;
    if (problem.load_control)
      mean = share([&](std::int64_t first, std::int64_t last) {
               Sums sums;
               for (std::int64_t i = first; i < last; ++i)
                 if (p[at(i)] > 0) sums.a += r[at(i)];
               return sums;
             }).a /
             contact.b;
    const Sums slope = share([&](std::int64_t first, std::int64_t last) {
      Sums sums;
      for (std::int64_t i = first; i < last; ++i)
        if (p[at(i)] > 0) {
          sums.a += g[at(i)] * t[at(i)];
          sums.b += (r[at(i)] - mean) * t[at(i)];
        }
      return sums;
    });
    const double step = slope.a / (side * slope.b);
    const Sums taken = share([&](std::int64_t first, std::int64_t last) {  // a: pressure, b: cells that came into contact
      Sums sums;
      for (std::int64_t i = first; i < last; ++i) {
        double& value = p[at(i)];
        if (value > 0) value = std::max(0.0, value - step * t[at(i)]);
        if (value == 0 && g[at(i)] < 0) {
          value = -step * g[at(i)];
          ++sums.b;
        }
        sums.a += value;
      }
      return sums;
    });
    conjugate = taken.b > 0 ? 0 : 1;
    if (problem.load_control)
      share([&, scale = problem.target / (cell * taken.a)](std::int64_t first, std::int64_t last) {
        for (std::int64_t i = first; i < last; ++i) p[at(i)] *= scale;
        return Sums{};
      });
  }
}

}  // namespace

}  // namespace bench

extern "C" {

// The standard method, Polonsky & Keer (1999), until `look` returns 0. wisdom: file of FFTW's plans, kept from run to run.
// seconds: set-up, and planning as a part of it.
const char* bench_polonsky_keer(std::int64_t n, const double* gap, int load_control, double target, int threads,
                                std::int64_t most, double planning_limit, const char* wisdom, double* seconds,
                                int (*look)(std::int64_t products, const double* p, double residual, double seconds)) {
  using namespace bench;
  return guarded([&] {
    const auto begun = Clock::now();
    fftw_init_threads();
    fftw_import_wisdom_from_filename(wisdom);
    PaddedProduct product(n, threads, FFTW_MEASURE, planning_limit);
    seconds[0] = seconds_since(begun);
    seconds[1] = product.planning_seconds();
    fftw_export_wisdom_to_filename(wisdom);
    polonsky_keer({n, gap, load_control != 0, target}, product, threads, most, [&](const StandardState& state) {
      return look(state.products, state.p.data(), state.residual, state.seconds) != 0;
    });
  });
}

}  // extern "C"

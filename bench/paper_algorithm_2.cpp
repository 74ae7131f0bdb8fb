// Algorithm 2 of Bemporad & Paggi (2015) as printed, and with its errata put right one after the other: how far each gets. For
// the benchmark alone; the library's polonsky-keer has them all.
#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "failure_scenes.h"
#include "library.h"
#include "paper.h"

namespace bench {

namespace {

using Vector = Eigen::VectorXd;

struct Variant {
  const char* name;
  bool every_point;    // is clipped at zero and may come back, not those of the active set alone
  bool on_contact;     // directions and norms are restricted to the contact set
  bool squared_norms;  // in the ratio that makes directions conjugate
};
constexpr Variant variants[] = {{"as printed", false, false, false},
                                {"every point clipped and admitted", true, false, false},
                                {"and norms on the contact set", true, true, false},
                                {"and squared norms: Polonsky & Keer (1999)", true, true, true}};

struct Problem {
  Eigen::MatrixXd matrix;
  Vector u;
};

// The candidates of a scene with square cells.
Problem problem_of(const Scene& scene) {
  const std::int64_t nx = scene.system.nx, ny = scene.system.ny;
  Field table(scene.gap.size());
  check(rc_kernel_coefficients(scene.kernel.c_str(), 1, 1, nx, ny, table.data()));
  std::vector<std::int64_t> points;
  for (std::int64_t i = 0; i < nx * ny; ++i)
    if (scene.gap[static_cast<std::size_t>(i)] < scene.approach) points.push_back(i);
  const auto n = static_cast<Eigen::Index>(points.size());
  Problem problem{Eigen::MatrixXd(n, n), Vector(n)};
  for (Eigen::Index j = 0; j < n; ++j) {
    const std::int64_t b = points[static_cast<std::size_t>(j)];
    problem.u[j] = (scene.approach - scene.gap[static_cast<std::size_t>(b)]) / scene.approach;
    for (Eigen::Index i = 0; i < n; ++i) {
      const std::int64_t a = points[static_cast<std::size_t>(i)];
      problem.matrix(i, j) = table[static_cast<std::size_t>(std::abs(a / nx - b / nx) * nx + std::abs(a % nx - b % nx))];
    }
  }
  return problem;
}

// Largest violation of p >= 0, w >= 0, p w = 0, relative to the largest pressure and compenetration.
double residual_of(const Vector& p, const Vector& w, double height) {
  const double largest = p.cwiseAbs().maxCoeff();
  double worst = 0;
  for (Eigen::Index i = 0; i < p.size(); ++i) {
    worst = std::max(worst, (p[i] > 0 ? std::abs(w[i]) : -w[i]) / height);
    if (p[i] < 0) worst = std::max(worst, -p[i] / largest);
  }
  return worst;
}

Json measure(const Scene& scene, const Variant& variant, std::int64_t most) {
  constexpr double tol = 1e-8;
  const Problem problem = problem_of(scene);
  const auto n = problem.u.size();
  const double height = problem.u.maxCoeff();
  Vector p = Vector::Zero(n), t = Vector::Zero(n), w = -problem.u;
  Eigen::Array<bool, Eigen::Dynamic, 1> active = Eigen::Array<bool, Eigen::Dynamic, 1>::Constant(n, true);
  double last_norm = 1, direction = 0, least = 1, at_stop = -1;
  std::int64_t iterations = 0, stopped = -1;
  const auto norm_of = [&] {
    const Vector counted = variant.on_contact ? Vector(active.select(w, 0.0)) : w;
    return variant.squared_norms ? counted.squaredNorm() : counted.norm();
  };
  if (variant.on_contact) active = w.array() < 0;
  double norm = norm_of(), all_points = w.norm();
  while (least > tol && iterations < most) {
    t = w + direction * norm / last_norm * t;
    if (variant.on_contact) t = active.select(t, 0.0);
    const double step = w.dot(t) / t.dot(problem.matrix * t);
    if (!std::isfinite(step)) break;
    p -= step * t;
    const auto seen = [&](Eigen::Index i) { return variant.every_point || active[i]; };
    bool overlap = false;
    Eigen::Array<bool, Eigen::Dynamic, 1> next = Eigen::Array<bool, Eigen::Dynamic, 1>::Constant(n, false);
    for (Eigen::Index i = 0; i < n; ++i) {
      if (!seen(i)) continue;
      p[i] = std::max(p[i], 0.0);
      next[i] = p[i] > 0;
      if (p[i] == 0 && w[i] < 0) {
        overlap = next[i] = true;
        p[i] -= step * w[i];
      }
    }
    active = next || p.array() > 0;
    direction = overlap ? 0 : 1;
    last_norm = norm;
    w = problem.matrix * p - problem.u;
    norm = norm_of();
    ++iterations;
    const double residual = residual_of(p, w, height), now = w.norm();
    if (!std::isfinite(residual)) break;
    least = std::min(least, residual);
    // The printed test: the norm over all points changes little.
    if (stopped < 0 && std::abs(now - all_points) <= tol * all_points) {
      stopped = iterations;
      at_stop = residual;
    }
    all_points = now;
  }
  Json row = {{"candidates", n},
              {"iterations", iterations},
              {"most", most},
              {"residual", least},
              {"lowest_pressure", p.minCoeff() / p.cwiseAbs().maxCoeff()}};
  if (stopped >= 0) row.update({{"stopped", stopped}, {"residual_at_stop", at_stop}});
  return row;
}

}  // namespace

void plan_algorithm_2(const PaperRequest& request, Plan& plan) {
  const std::int64_t levels = request.quick ? 5 : 7, most = request.quick ? 500 : 5000;
  for (const std::string kernel : {"eq9", "love"})
    for (const Variant& variant : variants)
      plan.push_back({"algorithm_2", {{"kernel", kernel}, {"variant", variant.name}}, request.quick ? 0.1 : 10.0, [=] {
                        Scene scene = rough_scene(levels, 1);
                        scene.kernel = kernel;
                        return measure(scene, variant, most);
                      }});
}

}  // namespace bench

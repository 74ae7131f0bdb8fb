// Closed forms of grids that repeat: the wave of Westergaard (1939), full contact of any surface, the cylinder of Hertz.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "analytic_tests.h"
#include "support/registry.h"
#include "support/surfaces.h"

namespace pairs {

namespace {

// Gap amplitude (1 - cos(2 pi x / length)): its lowest point is 0, its mean the amplitude. Full contact at the mean pressure
// p* = pi E* amplitude / length; below, contact of width 2 a with mean pressure p* sin^2(pi a / length).
// Johnson, Contact Mechanics (1985), section 13.2.
struct Wave {
  double length = 3, amplitude = 0.2, modulus = 5;

  double full_pressure() const { return pi * modulus * amplitude / length; }
  double half_width(double t) const { return length / pi * std::asin(std::sqrt(t)); }
  double pressure(double t, double x) const {
    const double inside = t - std::pow(std::sin(pi * x / length), 2);
    return inside > 0 ? 2 * full_pressure() * std::cos(pi * x / length) * std::sqrt(inside) : 0;
  }
  // From the compliance of a row of flat punches, dd/d(mean pressure) = -(2 length / (pi E*)) log sin(pi a / length).
  double approach(double t) const { return amplitude * (t - t * std::log(t)); }
};

Problem wave_problem(const Wave& wave, std::int64_t nx, std::int64_t ny, double t) {
  Problem problem;
  rc_system& s = problem.system;
  s.boundary = RC_BOUNDARY_PERIODIC;
  s.nx = nx;
  s.ny = ny;
  s.hx = wave.length / static_cast<double>(nx);
  s.hy = 0.7;
  s.modulus = wave.modulus;
  for (std::int64_t iy = 0; iy < ny; ++iy)
    for (std::int64_t ix = 0; ix < nx; ++ix)
      problem.gap.push_back(wave.amplitude * (1 - std::cos(2 * pi * static_cast<double>(ix) / static_cast<double>(nx))));
  return at_load(problem, t * wave.full_pressure() * static_cast<double>(problem.points()) * problem.cell_area());
}

// Mean |p - p_exact| over the mean pressure.
double pressure_error(const Wave& wave, const Problem& problem, const Answer& answer, double t) {
  double error = 0;
  for (std::size_t i = 0; i < answer.p.size(); ++i) {
    const double x = static_cast<double>(i % static_cast<std::size_t>(problem.system.nx)) * problem.system.hx;
    error += std::abs(answer.p[i] - wave.pressure(t, std::min(x, wave.length - x)));
  }
  return error / sum(answer.p);
}

void wave_is_westergaards(const Pair& pair, std::int64_t ny, double t) {
  const Wave wave;
  Field errors;
  for (const std::int64_t nx : {128, 256, 512}) {
    if (quick() && nx * ny > 512) break;
    const Problem problem = wave_problem(wave, nx, ny, t);
    const Answer answer = solved(problem, pair, {{RC_OPT_TOL, "1e-11"}});
    const double width = answer.result.contact_area / (static_cast<double>(ny) * problem.system.hy);
    const double cells = static_cast<double>(nx);
    check_near(width, 2 * wave.half_width(t), 2 * problem.system.hx, "contact width, nx = " + std::to_string(nx));
    check_near(answer.result.approach, wave.approach(t), 10 / (cells * cells) * wave.amplitude,
               "approach, nx = " + std::to_string(nx));
    errors.push_back(pressure_error(wave, problem, answer, t));
    report("nx = " + std::to_string(nx) + ": contact width " + text(width) + ", Westergaard " + text(2 * wave.half_width(t)) +
           ", pressure error " + text(errors.back()));
    check(errors.back() < 2 / cells, "pressure error " + text(errors.back()) + ", nx = " + std::to_string(nx));
  }
  if (errors.size() == 3)
    check(errors[2] < 0.6 * errors[0], "the pressure does not converge: " + text(errors[0]) + " to " + text(errors[2]));
}

void wave_at_given_approach(const Pair& pair) {
  const Wave wave;
  Problem problem = wave_problem(wave, 256, 1, 0.5);
  problem.control = RC_CONTROL_APPROACH;
  problem.target = wave.approach(0.5);
  check_near(solved(problem, pair).result.mean_pressure, 0.5 * wave.full_pressure(), 1e-3 * wave.full_pressure(),
             "mean pressure");
}

// In full contact each wave A cos(q.x + phase) of the gap takes -(E* |q| / 2) A cos(q.x + phase) from the mean pressure.
struct Superposition {
  Problem problem;
  Field p;
  double mean_gap = 0;
};

Superposition full_contact(std::int64_t nx, std::int64_t ny) {
  Superposition made;
  rc_system& s = made.problem.system;
  s.boundary = RC_BOUNDARY_PERIODIC;
  s.nx = nx;
  s.ny = ny;
  s.hx = 0.5;
  s.hy = 0.8;
  s.modulus = 3;
  made.mean_gap = 2;
  made.problem.gap.assign(made.problem.points(), made.mean_gap);
  made.p.assign(made.problem.points(), 0.0);
  const double waves[][4] = {{1, 0, 0.2, 0.3}, {0, 2, 0.1, 1.1}, {2, 1, 0.15, 2.5}, {3, -2, 0.05, 4.2}, {-1, 3, 0.08, 5.9}};
  for (const auto& [kx, ky, amplitude, phase] : waves) {
    const double q = 2 * pi * std::hypot(kx / (static_cast<double>(nx) * s.hx), ky / (static_cast<double>(ny) * s.hy));
    for (std::size_t i = 0; i < made.p.size(); ++i) {
      const auto ix = static_cast<std::int64_t>(i) % nx, iy = static_cast<std::int64_t>(i) / nx;
      const double height = amplitude * std::cos(2 * pi *
                                                     (kx * static_cast<double>(ix) / static_cast<double>(nx) +
                                                      ky * static_cast<double>(iy) / static_cast<double>(ny)) +
                                                 phase);
      made.problem.gap[i] += height;
      made.p[i] -= 0.5 * s.modulus * q * height;
    }
  }
  const double mean = 1.2 * largest(made.p);
  for (double& value : made.p) value += mean;
  made.problem = at_load(made.problem, mean * static_cast<double>(made.problem.points()) * made.problem.cell_area());
  return made;
}

void full_contact_is_exact(const Pair& pair) {
  for (const auto& [nx, ny] : {std::pair<std::int64_t, std::int64_t>{24, 18}, {21, 15}, {16, 27}}) {
    const Superposition expected = full_contact(nx, ny);
    const Answer answer = solved(expected.problem, pair, {{RC_OPT_STIFFNESS, "1"}});
    const std::string size = ", " + std::to_string(nx) + " x " + std::to_string(ny);
    double worst = 0;
    for (std::size_t i = 0; i < expected.p.size(); ++i) worst = std::max(worst, std::abs(answer.p[i] - expected.p[i]));
    report("largest error of p / max p" + size + ": " + text(worst / largest(expected.p)));
    check_near(answer.p, expected.p, 4e-12, "p" + size);  // a residual of 1e-12, times what H damps
    check_near(answer.result.approach, expected.mean_gap, 1e-12 * expected.mean_gap, "approach is the mean plane" + size);
    check_equal(answer.result.contacts, nx * ny, "contacts" + size);
    check(std::isinf(answer.result.stiffness), "the stiffness of full contact is infinite");
  }
}

// A cylinder along the axis that repeats: Johnson, Contact Mechanics (1985), section 4.2(c), and the deflection of its middle
// under 2 q / (pi E*) ln(R / |y|), R = nx hx + ny hy.
void cylinder_is_hertz(std::int32_t boundary, const Pair& pair) {
  constexpr double radius = 10, modulus = 3, half_width = 1;
  constexpr std::int64_t across = 121, along = 3;
  Problem problem;
  rc_system& s = problem.system;
  const bool along_x = boundary == RC_BOUNDARY_PERIODIC_X;
  s.boundary = boundary;
  s.modulus = modulus;
  s.nx = along_x ? along : across;
  s.ny = along_x ? across : along;
  const double h = 3.0 / static_cast<double>(across);
  s.hx = along_x ? 0.8 : h;
  s.hy = along_x ? h : 0.8;
  const auto place = [&](std::size_t i) {
    const auto point = static_cast<std::int64_t>(i);
    return (static_cast<double>(along_x ? point / s.nx : point % s.nx) - 0.5 * static_cast<double>(across - 1)) * h;
  };
  for (std::size_t i = 0; i < problem.points(); ++i) problem.gap.push_back(place(i) * place(i) / (2 * radius));
  const double length = 0.8 * along, q = pi * modulus * half_width * half_width / (4 * radius);
  const Answer answer = solved(at_load(problem, q * length), pair, {{RC_OPT_STIFFNESS, "1"}});
  double error = 0;
  for (std::size_t i = 0; i < answer.p.size(); ++i) {
    const double inside = 1 - std::pow(place(i) / half_width, 2);
    error += std::abs(answer.p[i] - (inside > 0 ? 2 * q / (pi * half_width) * std::sqrt(inside) : 0));
  }
  check(error / sum(answer.p) < 0.005, "pressures are off by " + text(error / sum(answer.p)) + " of their mean");
  const double datum = length + 3, approach = 2 * q / (pi * modulus) * (std::log(2 * datum / half_width) + 0.5);
  check_near(answer.result.approach, approach, 5e-4 * approach, "approach");
  const double slope = pi * modulus * length / (2 * std::log(2 * datum / half_width));
  check_near(answer.result.stiffness, slope, 0.01 * slope, "stiffness");
}

}  // namespace

std::vector<Test> periodic_analytic_tests() {
  std::vector<Test> tests;
  for (const double t : {0.05, 0.25, 0.75})
    for (const std::int64_t ny : {1, 4})
      add_for_pairs(tests, "wave_is_westergaards/load_" + text(t) + "/ny_" + std::to_string(ny), RC_BOUNDARY_PERIODIC,
                    [=](const Pair& pair) { wave_is_westergaards(pair, ny, t); });
  add_for_pairs(tests, "wave_at_the_approach_of_half_the_full_pressure_carries_it", RC_BOUNDARY_PERIODIC, wave_at_given_approach);
  add_for_pairs(tests, "full_contact_is_exact", RC_BOUNDARY_PERIODIC, full_contact_is_exact);
  for (const std::int32_t boundary : {RC_BOUNDARY_PERIODIC_X, RC_BOUNDARY_PERIODIC_Y})
    add_for_pairs(tests, "cylinder_is_hertz", boundary, [=](const Pair& pair) { cylinder_is_hertz(boundary, pair); });
  return tests;
}

}  // namespace pairs

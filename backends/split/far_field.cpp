#include "far_field.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "common/coefficients.h"
#include "failure.h"

namespace rc_split {

namespace {

// The expansion is fitted from fit_from to fit_to, in units of the cell's longer side. The misfit is relative to H.
constexpr double fit_from = 16, fit_to = 40, largest_misfit = 1e-9;

// r^(-2k) cos(2 l angle) for k = 1, 2, 3 and the mean, in the order of the coefficients.
template <class Out> void basis(double x, double y, double unit, Out&& out) {
  const double square = x * x + y * y, inverse = unit * unit / square;
  const double cos2 = (x * x - y * y) / square, cos4 = 2 * cos2 * cos2 - 1, cos6 = 2 * cos2 * cos4 - cos2;
  const double second = inverse, fourth = inverse * inverse, sixth = fourth * inverse;
  out[0] = second;
  out[1] = second * cos2;
  out[2] = fourth;
  out[3] = fourth * cos2;
  out[4] = fourth * cos4;
  out[5] = sixth;
  out[6] = sixth * cos2;
  out[7] = sixth * cos4;
  out[8] = sixth * cos6;
}

struct Point {
  double x, y;
};

// Groups of point sources that are symmetric in both axes, 13 points in all. Given is one point of each group, in steps.
constexpr Point corners[] = {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {0, 2}, {1, 1}};

// Calls source(x, y) for the points of a group.
template <class Source> void for_each_point(Point p, const Source& source) {
  for (int i = 0; i < (p.x > 0 ? 2 : 1); ++i)
    for (int j = 0; j < (p.y > 0 ? 2 : 1); ++j) source(i ? -p.x : p.x, j ? -p.y : p.y);
}

// The expansion of 1/|x - s| up to k = 2: |s|^2k P_2k(cos of the angle between); only the terms that a symmetric group has.
std::array<double, 6> moments(Point s) {
  std::array<double, 6> m{};
  for_each_point(s, [&](double x, double y) {
    const double square = x * x + y * y;
    const double cos2 = square > 0 ? (x * x - y * y) / square : 0, cos4 = 2 * cos2 * cos2 - 1;
    m[0] += 1;
    m[1] += square / 4;
    m[2] += 3 * square / 4 * cos2;
    m[3] += 9 * square * square / 64;
    m[4] += 20 * square * square / 64 * cos2;
    m[5] += 35 * square * square / 64 * cos4;
  });
  return m;
}

}  // namespace

FarField::FarField(const rc_host* host, const rc_operator_spec& spec) {
  const double hx = spec.system->hx, hy = spec.system->hy, side = std::max(hx, hy);
  force_ = hx * hy / (std::numbers::pi * spec.system->modulus);
  step_ = side / 2;

  // About 12 radii and 12 angles are more than enough for 9 coefficients.
  rc_common::Coefficients h(host, spec, component);
  h.cover(static_cast<std::int64_t>(fit_to * side / hx) + 1, static_cast<std::int64_t>(fit_to * side / hy) + 1);
  std::vector<Point> samples;
  std::vector<double> values;
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 12; ++j) {
      const double r = side * (fit_from + (fit_to - fit_from) * i / 12), angle = std::numbers::pi / 2 * j / 11;
      const std::int64_t ix = std::lround(r * std::cos(angle) / hx), iy = std::lround(r * std::sin(angle) / hy);
      const Point p{hx * static_cast<double>(ix), hy * static_cast<double>(iy)};
      samples.push_back(p);
      values.push_back(h(ix, iy) * std::hypot(p.x, p.y) / force_ - 1);
    }
  const auto rows = static_cast<Eigen::Index>(samples.size());
  Eigen::MatrixXd a(rows, terms);
  const Eigen::VectorXd b = Eigen::Map<const Eigen::VectorXd>(values.data(), rows);
  for (Eigen::Index i = 0; i < rows; ++i)
    basis(samples[static_cast<std::size_t>(i)].x, samples[static_cast<std::size_t>(i)].y, fit_from * side, a.row(i));
  const Eigen::VectorXd c = a.colPivHouseholderQr().solve(b);
  const double misfit = (a * c - b).lpNorm<Eigen::Infinity>();
  if (!(misfit <= largest_misfit))
    fail(RC_ERR_INCOMPATIBLE, "kernel \"", spec.kernel, "\" differs from that of a compact source by ", misfit,
         " of its value far away, more than ", largest_misfit, "; use another backend");
  for (int k = 0; k < terms; ++k) c_[static_cast<std::size_t>(k)] = c[k] * std::pow(fit_from * side, k < 2 ? 2 : k < 5 ? 4 : 6);

  Eigen::Matrix<double, groups, groups> m;
  Eigen::Matrix<double, groups, 1> wanted;
  for (int j = 0; j < groups; ++j) {
    const auto column = moments(corners[j]);
    for (int i = 0; i < groups; ++i) m(i, j) = column[static_cast<std::size_t>(i)];
    wanted[j] = j == 0 ? 1 : c_[static_cast<std::size_t>(j - 1)] / std::pow(step_, j < 3 ? 2 : 4);
  }
  const Eigen::Matrix<double, groups, 1> strength = m.fullPivLu().solve(wanted);
  std::size_t i = 0;
  for (int j = 0; j < groups; ++j)
    for_each_point(corners[j], [&](double x, double y) {
      x_[i] = step_ * x;
      y_[i] = step_ * y;
      strength_[i++] = strength[j];
    });
}

double FarField::expansion(double x, double y) const {
  std::array<double, terms> value;
  basis(x, y, 1, value);
  double sum = 1;
  for (std::size_t k = 0; k < terms; ++k) sum += c_[k] * value[k];
  return force_ / std::sqrt(x * x + y * y) * sum;
}

double FarField::smooth(double x, double y, double rc, const Smoothed& smoothed) const {
  const double limit = rc + margin();
  if (x * x + y * y > limit * limit) return expansion(x, y);
  const double inverse = 1 / (rc * rc);
  std::array<double, lanes> square, within, value;
  for (std::size_t i = 0; i < lanes; ++i) {
    const double dx = x - x_[i], dy = y - y_[i];
    square[i] = dx * dx + dy * dy;
    within[i] = std::min(square[i] * inverse, 1.0);
  }
  for (std::size_t i = 0; i < lanes; i += Smoothed::lanes) smoothed(&within[i], &value[i]);
  double sum = 0;
  for (std::size_t i = 0; i < points; ++i) sum += strength_[i] * (within[i] < 1 ? value[i] / rc : 1 / std::sqrt(square[i]));
  return force_ * sum;
}

}  // namespace rc_split

#include "kernel/layer/remainder.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "kernel/density.h"

namespace rc::kernel::layer {

namespace {

constexpr double panel_width = 0.75;   // of asinh(rho); T is analytic within pi/2 of the real axis
constexpr double first_s = 1e-4;       // the first interval of the quadrature
constexpr double last_s = 22;          // beyond it exp(-2 s) is below round-off
constexpr double longest_phase = 8;    // s rho over an interval of the quadrature
constexpr double decayed = 40;         // exp(-decayed) is below round-off
constexpr int parts = 2;               // of the angle between two corners
constexpr double by_points_from = 12;  // cells of the longer side, see coefficient()

// Rules for the mean over the tent of two cells of length 1, by their moments of the orders 2, 4, and 6.
constexpr double two[] = {-0.408248290463863, 0.408248290463863}, two_weight[] = {0.5, 0.5};
constexpr double root = 0.6324555320336759;
constexpr double three[] = {-root, 0, root}, three_weight[] = {5.0 / 24, 7.0 / 12, 5.0 / 24};

constexpr double outer = 0.7509251433044474, inner = 0.26222984265274807, share = 0.09886630457987557;
constexpr double four[] = {-outer, -inner, inner, outer}, four_weight[] = {share, 0.5 - share, 0.5 - share, share};

template <class Polynomial> double sum(const Polynomial& c, double x) {  // Clenshaw's recurrence
  double next = 0, last = 0;
  for (std::size_t k = c.size() - 1; k > 0; --k) {
    const double now = 2 * x * next - last + c[k];
    last = next;
    next = now;
  }
  return x * next - last + c[0];
}

template <class Polynomial> Polynomial interpolated(const Polynomial& values) {
  const std::size_t n = values.size();
  Polynomial c{};
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t j = 0; j < n; ++j)
      c[k] += values[j] *
              std::cos(std::numbers::pi * static_cast<double>(k) * (static_cast<double>(j) + 0.5) / static_cast<double>(n));
    c[k] *= (k == 0 ? 1.0 : 2.0) / static_cast<double>(n);
  }
  return c;
}

double node(std::size_t j, std::size_t n) {
  return std::cos(std::numbers::pi * (static_cast<double>(j) + 0.5) / static_cast<double>(n));
}

}  // namespace

Remainder::Remainder(const Response& response, double hx, double hy, double farthest)
    : response_(response), t_(response.layer().thickness), hx_(hx), hy_(hy) {
  const double longer = std::max(hx, hy);
  if (2 * t_ < longer) near_ = by_points_from * longer;

  const double last = (farthest + 2 * (hx + hy)) / t_;
  // The last piece of the fast table ends beyond its last distance.
  tabulate(2 * last + 4, (near_ + 3 * (hx + hy)) / t_);
  fast_.tabulate(*this, last);
}

void Remainder::tabulate(double farthest_rho, double last_moment) {
  const Density gauss = box(1);
  Oscillating oscillating;
  const Decaying decaying;
  const double decaying_from = decayed / response_.reach();
  std::array<double, 3> begin{};  // the moments up to the panel
  for (double u = 0; u < std::asinh(farthest_rho); u += panel_width) {
    Panel panel{};
    Polynomial values;
    if (std::sinh(u) < decaying_from) oscillating.prepare(response_, std::min(decaying_from, std::sinh(u + panel_width)));
    for (std::size_t j = 0; j < nodes; ++j) {
      const double rho = std::sinh(u + panel_width * (1 + node(j, nodes)) / 2);
      values[j] = rho < decaying_from ? oscillating(rho) : decaying(response_, rho);
    }
    panel.value = interpolated(values);
    const auto up_to = [&](double width, std::size_t k) {
      double integral = 0;
      for (int i = 0; i < gauss.size; ++i) {
        const double at = width * (0.5 + gauss.node[i]), rho = std::sinh(u + at);
        integral +=
            width * gauss.weight[i] * sum(panel.value, 2 * at / panel_width - 1) * std::pow(rho, k + 1) * std::cosh(u + at);
      }
      return begin[k] + integral;
    };
    if (near_ > 0 && std::sinh(u) <= last_moment)
      for (std::size_t k = 0; k < begin.size(); ++k) {
        for (std::size_t j = 0; j < nodes; ++j) values[j] = up_to(panel_width * (1 + node(j, nodes)) / 2, k);
        panel.moment[k] = interpolated(values);
        begin[k] = up_to(panel_width, k);
      }
    panels_.push_back(panel);
  }
}

Remainder::BesselJ0::BesselJ0() {
  for (std::size_t k = 0; k < sine_.size(); ++k)
    sine_[k] = std::sin(std::numbers::pi * (static_cast<double>(k) + 0.5) / static_cast<double>(2 * sine_.size()));
}

// The trapezium rule of cos(z sin t) over t is off by 2 J64(z) + ..., the asymptotic series by its first term left out.
double Remainder::BesselJ0::operator()(double z) const {
  constexpr double far = 25, least = 1e-18;
  if (z < far) {
    double mean = 0;
    for (const double sine : sine_) mean += std::cos(z * sine);
    return mean / static_cast<double>(sine_.size());
  }
  double even = 1, odd = 0, term = 1;
  for (int k = 1; std::abs(term) > least; ++k) {
    term *= (2.0 * k - 1) * (2.0 * k - 1) / (8 * k * z);
    const double signed_term = k / 2 % 2 == 0 ? term : -term;
    if (k % 2 == 0)
      even += signed_term;
    else
      odd -= signed_term;
  }
  const double phase = z - std::numbers::pi / 4;
  return std::sqrt(2 / (std::numbers::pi * z)) * (even * std::cos(phase) - odd * std::sin(phase));
}

void Remainder::Oscillating::prepare(const Response& response, double largest) {
  s_.clear();
  weighted_.clear();
  const Density gauss = box(1);
  double begin = 0;
  for (double end = first_s; begin < last_s; end = std::min(2 * end, end + 1)) {
    const int parts = 1 + static_cast<int>((end - begin) * largest / longest_phase);
    const double width = (end - begin) / parts;
    for (int part = 0; part < parts; ++part)
      for (int j = 0; j < gauss.size; ++j) {
        s_.push_back(begin + width * (part + 0.5 + gauss.node[j]));
        weighted_.push_back(width * gauss.weight[j] * response.beyond(s_.back()));
      }
    begin = end;
  }
}

double Remainder::Oscillating::operator()(double rho) const {
  double total = 0;
  for (std::size_t i = 0; i < s_.size(); ++i) total += weighted_[i] * bessel_(s_[i] * rho);
  return total;
}

// Both integrals by the trapezium rule, which converges exponentially: over w, z = exp(w), and K0(z) over t.
Remainder::Decaying::Decaying() {
  constexpr double step = 0.25, most_w = 3.75, least_w = -38, step_t = 0.25, most_t = 48;
  for (double w = least_w; w <= most_w; w += step) {
    const double z = std::exp(w);
    double bessel = std::exp(-z) / 2;
    for (double t = step_t; t <= most_t; t += step_t) bessel += std::exp(-z * std::cosh(t));
    z_.push_back(z);
    weighted_.push_back(step * z * step_t * bessel);
  }
}

double Remainder::Decaying::operator()(const Response& response, double rho) const {
  double total = 0;
  for (std::size_t i = 0; i < z_.size(); ++i)
    total += weighted_[i] * response.beyond(std::complex<double>(0, z_[i] / rho)).real();
  return 2 / (std::numbers::pi * rho) * total;
}

void Remainder::Fast::tabulate(const Remainder& exact, double farthest_rho) {
  const double last = singular + farthest_rho * farthest_rho;
  for (double begin = singular; begin <= last; begin *= 2)
    for (int i = 0; i < per_octave; ++i) {
      const double half = begin / per_octave / 2, middle = begin + half * (2 * i + 1);
      std::array<double, degree> values;
      for (std::size_t j = 0; j < degree; ++j)
        values[j] = exact.value(std::sqrt(std::max(0.0, middle + half * node(j, degree) - singular)));
      const auto chebyshev = interpolated(values);
      // Chebyshev's polynomials in powers of x.
      std::array<double, degree> before{}, now{}, power{};
      before[0] = now[1] = 1;
      for (std::size_t k = 0; k < degree; ++k) {
        const std::array<double, degree>& term = k == 0 ? before : now;
        for (std::size_t j = 0; j < degree; ++j) power[j] += chebyshev[k] * term[j];
        if (k == 0) continue;
        std::array<double, degree> next{};
        for (std::size_t j = 0; j < degree; ++j) next[j] = (j > 0 ? 2 * now[j - 1] : 0) - before[j];
        before = now;
        now = next;
      }
      pieces_.push_back(power);
    }
}

double Remainder::Fast::operator()(double square) const {
  int octave;
  const double mantissa = std::frexp((singular + square) / singular, &octave);  // 0.5 .. 1
  const double at = (2 * mantissa - 1) * per_octave;
  const int piece = static_cast<int>(at);
  const auto& c = pieces_[static_cast<std::size_t>((octave - 1) * per_octave + piece)];
  const double x = 2 * (at - piece) - 1;
  double total = c[degree - 1];
  for (int k = degree - 2; k >= 0; --k) total = total * x + c[static_cast<std::size_t>(k)];
  return total;
}

double Remainder::value(double rho) const {
  const double u = std::asinh(rho) / panel_width;
  const auto panel = static_cast<std::size_t>(u);
  return sum(panels_[panel].value, 2 * (u - static_cast<double>(panel)) - 1);
}

std::array<double, 3> Remainder::moments(double rho) const {
  const double u = std::asinh(rho) / panel_width;
  const auto panel = static_cast<std::size_t>(u);
  const double at = 2 * (u - static_cast<double>(panel)) - 1;
  const auto& moment = panels_[panel].moment;
  return {sum(moment[0], at), sum(moment[1], at), sum(moment[2], at)};
}

// T is as smooth as its distance from the singularities at rho = +-2 i allows. Near a cell that is longer than 2 t, polar
// coordinates are exact where points are not.
double Remainder::coefficient(double x, double y) const {
  const double distance = std::hypot(x, y, 2 * t_) / std::max(hx_, hy_);
  double mean;
  if (distance >= 400) {
    mean = by_points(x, y, two, two_weight, 2);
  } else if (distance >= 60) {
    mean = by_points(x, y, three, three_weight, 3);
  } else if (distance >= by_points_from) {
    mean = by_points(x, y, four, four_weight, 4);
  } else if (near_ > 0) {
    mean = by_angles(std::abs(x), std::abs(y));
  } else {
    const Density density = tent(1);
    mean = by_points(x, y, density.node.data(), density.weight.data(), density.size);
  }
  return hx_ * hy_ / (std::numbers::pi * t_) * mean;
}

double Remainder::by_points(double x, double y, const double* at, const double* weight, int n) const {
  const auto along = [](double length) { return length * length; };
  double mean = 0;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      mean += weight[i] * weight[j] * fast_((along(x + at[i] * hx_) + along(y + at[j] * hy_)) / (t_ * t_));
  return mean;
}

// The tents of both axes are linear on either side of x and of y: four rectangles, of which those beyond an axis are mirrored.
double Remainder::by_angles(double x, double y) const {
  double mean = 0;
  for (const int side_x : {-1, 1})
    for (const int side_y : {-1, 1}) {
      const bool mirrored_x = x < hx_ / 2, mirrored_y = y < hy_ / 2;
      if ((mirrored_x && side_x < 0) || (mirrored_y && side_y < 0)) continue;
      mean += (mirrored_x ? 2 : 1) * (mirrored_y ? 2 : 1) * over_rectangle({x, side_x * hx_}, {y, side_y * hy_});
    }
  return mean;
}

// The integral of T (1 - |X - x|/hx)/hx (1 - |Y - y|/hy)/hy over a rectangle from (x, y) to one
// of the four corners of the tents: along radii by the moments of T, over angles between the corners by Gauss.
double Remainder::over_rectangle(Side x, Side y) const {
  const Density gauss = box(1);
  std::array<double, 4> corner;
  for (int i = 0; i < 4; ++i)
    corner[static_cast<std::size_t>(i)] = std::atan2(i % 2 == 0 ? y.low() : y.high(), i / 2 == 0 ? x.low() : x.high());
  std::sort(corner.begin(), corner.end());
  double integral = 0;
  for (std::size_t i = 1; i < corner.size(); ++i)
    for (int part = 0; part < parts; ++part)
      for (int j = 0; j < gauss.size; ++j) {
        const double width = (corner[i] - corner[i - 1]) / parts, angle = corner[i - 1] + width * (part + 0.5 + gauss.node[j]);
        const double cosine = std::cos(angle), sine = std::sin(angle);
        const double inner = std::max(x.low() / cosine, y.low() / sine), outer = std::min(x.high() / cosine, y.high() / sine);
        if (!(outer > inner)) continue;
        const auto from = moments(inner / t_), to = moments(outer / t_);
        const double part0 = t_ * t_ * (to[0] - from[0]), part1 = t_ * t_ * t_ * (to[1] - from[1]),
                     part2 = t_ * t_ * t_ * t_ * (to[2] - from[2]);
        integral +=
            width * gauss.weight[j] *
            (x.constant() * y.constant() * part0 + (x.slope() * y.constant() * cosine + x.constant() * y.slope() * sine) * part1 +
             x.slope() * y.slope() * cosine * sine * part2);
      }
  return integral;
}

}  // namespace rc::kernel::layer

#include "influence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace scenes {

namespace {

constexpr Real pi = std::numbers::pi_v<Real>;

Real x_asinh(Real x, Real y) { return x == 0 ? 0 : x * std::asinh(y / std::abs(x)); }
// Its second mixed derivative is 1/r.
Real corner(Real x, Real y) { return x_asinh(x, y) + x_asinh(y, x); }

Real love(Real x, Real y, Real hx, Real hy) {
  return (corner(x + hx / 2, y + hy / 2) - corner(x - hx / 2, y + hy / 2) - corner(x + hx / 2, y - hy / 2) +
          corner(x - hx / 2, y - hy / 2)) /
         pi;
}

// The mean of love over a cell: differences of a function whose fourth mixed derivative is 1/r, far away by Gauss's rule.
Real galerkin(Real x, Real y, Real hx, Real hy) {
  constexpr std::array<std::pair<Real, Real>, 3> rule{{{0.238619186083196908630501721681L, 0.467913934572691047389870343990L},
                                                       {0.661209386466264513661399595020L, 0.360761573048138607569833513838L},
                                                       {0.932469514203152027812301554494L, 0.171324492379170345040296142173L}}};
  if (std::hypot(x, y) > 24 * std::max(hx, hy)) {
    Real sum = 0;
    for (const auto& [s, a] : rule)
      for (const auto& [t, b] : rule)
        for (const Real sx : {-s, s})
          for (const Real sy : {-t, t}) sum += a * b / 4 * love(x + sx * hx / 2, y + sy * hy / 2, hx, hy);
    return sum;
  }
  Real sum = 0;
  for (const int a : {-1, 0, 1})
    for (const int b : {-1, 0, 1}) {
      const Real u = std::abs(x + static_cast<Real>(a) * hx), v = std::abs(y + static_cast<Real>(b) * hy);
      const Real potential = u * v * corner(u, v) / 2 - std::pow(std::hypot(u, v), 3) / 6;
      sum += static_cast<Real>((a == 0 ? -2 : 1) * (b == 0 ? -2 : 1)) * potential;
    }
  return sum / (pi * hx * hy);
}

// Uniform pressure on a disc of the cell's width and force: E and K by arithmetic and geometric means (Abramowitz & Stegun 17.6).
Real disc(Real r, Real h) {
  if (r == 0) return 4 * h / pi;
  const Real k = h / (2 * r);
  Real a = 1, b = std::sqrt(1 - k * k), c = k, sum = c * c / 2, power = 1;
  for (int step = 0; step < 40 && c != 0; ++step) {
    const Real mean = (a + b) / 2;
    c = (a - b) / 2;
    b = std::sqrt(a * b);
    a = mean;
    sum += power * c * c;
    power *= 2;
  }
  const Real complete = pi / (2 * a), second = complete * (1 - sum);
  return 16 * r / (pi * pi) * (second - (1 - k * k) * complete);
}

Real coefficient(const std::string& kernel, Real x, Real y, Real hx, Real hy) {
  if (kernel == "galerkin") return galerkin(x, y, hx, hy);
  const Real r = std::hypot(x, y);
  if (kernel == "disc") return disc(r, hx);
  if (kernel == "punch" || kernel == "eq9") {
    if (r == 0) return kernel == "punch" ? hx : 2 * hx / pi;
    return 2 * hx / pi * std::asin(hx / (2 * r));
  }
  return love(x, y, hx, hy);
}

Reals cosines(std::size_t n) {
  Reals values;
  for (std::size_t k = 0; k < n; ++k) values.push_back(std::cos(2 * pi * static_cast<Real>(k) / static_cast<Real>(n)));
  return values;
}

// 2/|q| for every wave but the mean, summed along x and then along y.
Reals periodic_table(std::size_t nx, std::size_t ny, Real hx, Real hy) {
  const Reals along_x = cosines(nx), along_y = cosines(ny);
  const auto frequency = [](std::size_t k, std::size_t n, Real h) {
    return 2 * pi * static_cast<Real>(std::min(k, n - k)) / (static_cast<Real>(n) * h);
  };
  Reals rows(nx * ny), table(nx * ny);
  for (std::size_t ky = 0; ky < ny; ++ky)
    for (std::size_t kx = 0; kx < nx; ++kx) {
      if (kx == 0 && ky == 0) continue;
      const Real value = 2 / std::hypot(frequency(kx, nx, hx), frequency(ky, ny, hy)) / static_cast<Real>(nx * ny);
      for (std::size_t ix = 0; ix < nx; ++ix) rows[ky * nx + ix] += value * along_x[kx * ix % nx];
    }
  for (std::size_t iy = 0; iy < ny; ++iy)
    for (std::size_t ky = 0; ky < ny; ++ky)
      for (std::size_t ix = 0; ix < nx; ++ix) table[iy * nx + ix] += rows[ky * nx + ix] * along_y[ky * iy % ny];
  return table;
}

// A grid that repeats along one axis. Deflections of its mean load are 0 at the distance `datum`.
struct Strip {
  std::size_t along, across;
  Real h_along, h_across, datum;
  Real period() const { return static_cast<Real>(along) * h_along; }
};

// A row of love by M images on either side, the others by their integral to the second order in 1/M.
Reals images(const Strip& s, Real y, std::size_t count) {
  const auto shift = count * s.along;
  const Real M = static_cast<Real>(count), L = s.period();
  Reals row(s.along), edge(2 * shift + s.along + 1);
  for (std::size_t k = 0; k < edge.size(); ++k) {
    const Real x = (static_cast<Real>(k) - 0.5L) * s.h_along - M * L;
    edge[k] = corner(x, y + s.h_across / 2) - corner(x, y - s.h_across / 2);
  }
  for (std::size_t ix = 0; ix < s.along; ++ix) {
    Real sum = 0;
    for (std::size_t k = ix; k + 1 < edge.size(); k += s.along) sum += edge[k + 1] - edge[k];
    const Real x = static_cast<Real>(ix) * s.h_along;
    Real beyond = 2 / L * std::log(s.datum);
    for (const Real from : {(M + 0.5L) * L + x, (M + 0.5L) * L - x}) {
      const Real r = std::hypot(from, y);
      beyond -= std::log(from + r) / L + L * from / (24 * r * r * r);
      beyond += (2 * s.h_along * s.h_along - s.h_across * s.h_across) / (48 * L * from * from);
    }
    row[ix] = (sum + s.h_along * s.h_across * beyond) / pi;
  }
  return row;
}

// The integral of K0 from x on: of exp(-x cosh u)/cosh u over u > 0, by the trapezoidal rule, which converges exponentially.
Real beyond_bessel(Real x) {
  constexpr Real width = 0.125L;
  Real sum = std::exp(-x) / 2;
  for (int k = 1; k < 400; ++k) {
    const Real c = std::cosh(static_cast<Real>(k) * width), term = std::exp(-x * c) / c;
    sum += term;
    if (term < 1e-22L * sum) break;
  }
  return width * sum;
}

Real x_log(Real x) { return x == 0 ? 0 : x * std::log(std::abs(x)); }

// 2/pi times the integral of ln(R/|y|) over a cell at y.
Real line_load(Real y, Real h, Real R) {
  const Real high = y + h / 2, low = y - h / 2;
  return 2 / pi * (h * (1 + std::log(R)) - x_log(high) + x_log(low));
}

// A row by waves along the axis that repeats, constant across each cell: those of the grid for spectral, for love all, each by
// its mean over a cell.
Reals waves(const Strip& s, Real y, bool love) {
  const Reals cosine = cosines(s.along);
  const Real n = static_cast<Real>(s.along), h = s.h_across;
  Reals row(s.along, line_load(y, h, s.datum) / n);
  for (std::size_t k = 1; love || 2 * k <= s.along; ++k) {
    const Real q = 2 * pi * static_cast<Real>(k) / s.period(), half = q * s.h_along / 2;
    if (love && q * (y - h / 2) > 50) break;
    const Real across =
        y == 0 ? pi - 2 * beyond_bessel(q * h / 2) : beyond_bessel(q * (y - h / 2)) - beyond_bessel(q * (y + h / 2));
    const Real both = 2 * k == s.along && !love ? 1 : 2;  // k and -k
    const Real value = both * 2 / pi * across / q / n * (love ? std::sin(half) / half : 1);
    for (std::size_t ix = 0; ix < s.along; ++ix) row[ix] += value * cosine[k * ix % s.along];
  }
  return row;
}

// Rows of love near the load by images, far ones by waves, which decay there.
Reals strip_rows(const Strip& s, bool love) {
  Reals table;
  for (std::size_t iy = 0; iy < s.across; ++iy) {
    const Real y = static_cast<Real>(iy) * s.h_across;
    Reals row;
    if (love && y - s.h_across / 2 < s.period() / 2) {
      const auto count = static_cast<std::size_t>(std::ceil(120 * std::max<Real>(1, (y + s.h_across / 2) / s.period())));
      const Reals half = images(s, y, count);
      row = images(s, y, 2 * count);
      for (std::size_t i = 0; i < row.size(); ++i) row[i] += (row[i] - half[i]) / 15;  // the next order, 1/M^4
    } else {
      row = waves(s, y, love);
    }
    table.insert(table.end(), row.begin(), row.end());
  }
  return table;
}

}  // namespace

Reals influence_table(const Scene& scene) {
  const rc_system& s = scene.system;
  const auto nx = static_cast<std::size_t>(s.nx), ny = static_cast<std::size_t>(s.ny);
  const Real hx = s.hx, hy = s.hy;
  Reals table;
  if (scene.periodic()) {
    table = periodic_table(nx, ny, hx, hy);
  } else if (scene.semi_periodic()) {
    const bool along_x = s.boundary == RC_BOUNDARY_PERIODIC_X;
    const Real datum = static_cast<Real>(nx) * hx + static_cast<Real>(ny) * hy;
    const Strip strip = along_x ? Strip{nx, ny, hx, hy, datum} : Strip{ny, nx, hy, hx, datum};
    const Reals made = strip_rows(strip, scene.kernel != "spectral");
    for (std::size_t iy = 0; iy < ny; ++iy)
      for (std::size_t ix = 0; ix < nx; ++ix) table.push_back(along_x ? made[iy * nx + ix] : made[ix * ny + iy]);
  } else {
    for (std::size_t iy = 0; iy < ny; ++iy)
      for (std::size_t ix = 0; ix < nx; ++ix)
        table.push_back(coefficient(scene.kernel, static_cast<Real>(ix) * hx, static_cast<Real>(iy) * hy, hx, hy));
  }
  for (Real& value : table) value /= static_cast<Real>(s.modulus);
  return table;
}

Influence::Influence(const Scene& scene)
    : n_(scene.points()), nx_(static_cast<std::size_t>(scene.system.nx)), matrix_(&scene.matrix) {
  if (scene.halfspace()) table_ = influence_table(scene);
  for (std::size_t i = 0; i < n_; ++i) {
    row_.push_back(i / nx_);
    column_.push_back(i % nx_);
  }
  for (std::size_t i = 0; i < (n_ <= 1000 ? n_ : 0); ++i) {
    Real sum = 0;
    for (std::size_t j = 0; j < n_; ++j) sum += std::abs((*this)(i, j));
    largest_row_ = std::max(largest_row_, sum);
  }
  if (n_ > 1000)  // a row is at most four quarters around its point
    for (const Real value : table_) largest_row_ += 4 * std::abs(value);
}

Reals Influence::times(const Reals& v) const {
  Reals result(n_, 0);
  for (std::size_t j = 0; j < n_; ++j)
    if (v[j] != 0)
      for (std::size_t i = 0; i < n_; ++i) result[i] += (*this)(i, j) * v[j];
  return result;
}

}  // namespace scenes

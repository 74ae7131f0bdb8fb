#include "small/spectrum.h"

#include <cmath>
#include <numbers>

#include "lengths.h"

namespace rc_cuda {

namespace {

constexpr double pi = std::numbers::pi;

// None where the length has a prime factor above 7.
Passes passes_of(Index length) {
  Passes passes{static_cast<int>(length), 0, {}};
  Index rest = length;
  for (const int radix : {8, 4, 2, 3, 5, 7})
    for (; rest % radix == 0; rest /= radix) passes.radix[passes.count++] = radix;
  if (rest != 1) passes.length = 0;
  return passes;
}

struct Sides {
  Index x, y;
};
Sides sides_of(Index nx, Index ny, bool periodic) {
  return periodic ? Sides{nx, ny} : Sides{fast_length(nx), fast_length(2 * ny - 1)};
}

// Which frequency the passes leave at each place.
std::vector<Index> frequencies(const Passes& passes) {
  std::vector<Index> found(static_cast<std::size_t>(passes.length));
  for (Index at = 0; at < passes.length; ++at) {
    Index rest = at, block = passes.length, weight = 1;
    for (int k = 0; k < passes.count; ++k) {
      block /= passes.radix[k];
      found[static_cast<std::size_t>(at)] += rest / block * weight;
      rest %= block;
      weight *= passes.radix[k];
    }
  }
  return found;
}

std::vector<double> cosines(Index n) {
  std::vector<double> table;
  for (Index k = 0; k < n; ++k) table.push_back(std::cos(2 * pi * static_cast<double>(k) / static_cast<double>(n)));
  return table;
}

// Sums over both signs of every offset, along y and then along x; over the number of points.
std::vector<double> eigenvalues_of(const Passes& x, const Passes& y, Index nx, Index ny, bool periodic,
                                   const std::vector<double>& coefficients) {
  const auto weight = [&](Index offset) { return periodic || offset == 0 ? 1.0 : 2.0; };
  const Index width = x.length, height = y.length, quarter = periodic ? 1 : 4;
  const std::vector<double> along_x = cosines(quarter * width), along_y = cosines(height);
  const std::vector<Index> of_x = frequencies(x), of_y = frequencies(y);
  std::vector<double> rows(static_cast<std::size_t>(width * ny)), all(static_cast<std::size_t>(width * height));
  for (Index row = 0; row < ny; ++row)
    for (Index column = 0; column < width; ++column) {
      // The angle of the shift is 2 pi (k + 1/4) / width, without the quarter where the grid is periodic.
      const Index turn = quarter * of_x[static_cast<std::size_t>(column)] + (periodic ? 0 : 1);
      double sum = 0;
      for (Index m = 0; m < nx; ++m)
        sum += weight(m) * coefficients[static_cast<std::size_t>(row * nx + m)] *
               along_x[static_cast<std::size_t>(turn * m % (quarter * width))];
      rows[static_cast<std::size_t>(row * width + column)] = weight(row) * sum;
    }
  const double points = static_cast<double>(width * height);
  for (Index place = 0; place < height; ++place)
    for (Index row = 0; row < ny; ++row) {
      const double by = along_y[static_cast<std::size_t>(of_y[static_cast<std::size_t>(place)] * row % height)] / points;
      for (Index column = 0; column < width; ++column)
        all[static_cast<std::size_t>(place * width + column)] += by * rows[static_cast<std::size_t>(row * width + column)];
    }
  return all;
}

template <class R> void add(std::vector<R>& to, double angle) {
  to.push_back(static_cast<R>(std::cos(angle)));
  to.push_back(static_cast<R>(-std::sin(angle)));
}

}  // namespace

bool SmallSpectrum::suits(Index nx, Index ny, bool periodic) {
  const Sides sides = sides_of(nx, ny, periodic);
  return passes_of(sides.x).length > 0 && passes_of(sides.y).length > 0;
}

std::size_t SmallSpectrum::bytes(Index nx, Index ny, bool periodic) {
  const Sides sides = sides_of(nx, ny, periodic);
  return static_cast<std::size_t>(4 * sides.x + 2 * sides.y + sides.x * sides.y) * (sizeof(float) + sizeof(double));
}

SmallSpectrum::SmallSpectrum(Device& device, Index nx, Index ny, bool periodic, const std::vector<double>& coefficients)
    : nx_(static_cast<int>(nx)),
      ny_(static_cast<int>(ny)),
      periodic_(periodic),
      x_(passes_of(sides_of(nx, ny, periodic).x)),
      y_(passes_of(sides_of(nx, ny, periodic).y)) {
  const std::vector<double> eigenvalues = eigenvalues_of(x_, y_, nx, ny, periodic, coefficients);
  single_ = uploaded<float>(device, eigenvalues);
  double_ = uploaded<double>(device, eigenvalues);
}

// Roots of rows, of columns, what reals are multiplied by, eigenvalues.
template <class R> Memory SmallSpectrum::uploaded(Device& device, const std::vector<double>& eigenvalues) const {
  std::vector<R> values;
  for (const Passes& each : {x_, y_})
    for (int k = 0; k < each.length; ++k) add(values, 2 * pi * k / each.length);
  for (int k = 0; k < x_.length; ++k) add(values, periodic_ ? 0 : pi * k / (2 * x_.length));
  for (const double value : eigenvalues) values.push_back(static_cast<R>(value));
  Memory memory(device, values.size() * sizeof(R));
  device.upload(memory.as<R>(), values.data(), values.size() * sizeof(R));
  return memory;
}

template <class R> SmallTorus<R> SmallSpectrum::torus() const {
  const Memory& memory = sizeof(R) == sizeof(float) ? single_ : double_;
  SmallTorus<R> torus{};
  torus.nx = nx_;
  torus.ny = ny_;
  torus.x = x_;
  torus.y = y_;
  torus.roots_x = memory.as<Complex<R>>();
  torus.roots_y = torus.roots_x + x_.length;
  torus.twist = torus.roots_y + y_.length;
  torus.eigenvalues = reinterpret_cast<const R*>(torus.twist + x_.length);
  return torus;
}

template SmallTorus<float> SmallSpectrum::torus() const;
template SmallTorus<double> SmallSpectrum::torus() const;

}  // namespace rc_cuda

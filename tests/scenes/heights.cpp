#include "heights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace scenes {

namespace {

struct Grid {
  std::int64_t nx, ny;
  std::size_t points() const { return static_cast<std::size_t>(nx * ny); }
};

template <class Height> Field filled(const Grid& grid, Height height) {
  Field z;
  z.reserve(grid.points());
  for (std::int64_t iy = 0; iy < grid.ny; ++iy)
    for (std::int64_t ix = 0; ix < grid.nx; ++ix) z.push_back(height(ix, iy));
  return z;
}

Field white_noise(const Grid& grid, Random& random) {
  return filled(grid, [&](std::int64_t, std::int64_t) { return random.normal(); });
}

// Random values at every `step`-th point, linear between them.
void add_octave(const Grid& grid, std::int64_t step, double amplitude, Random& random, Field& z) {
  const Grid coarse{(grid.nx - 1) / step + 2, (grid.ny - 1) / step + 2};
  const Field knots = white_noise(coarse, random);
  std::size_t i = 0;
  for (std::int64_t iy = 0; iy < grid.ny; ++iy)
    for (std::int64_t ix = 0; ix < grid.nx; ++ix) {
      const auto k = static_cast<std::size_t>((iy / step) * coarse.nx + ix / step),
                 above = k + static_cast<std::size_t>(coarse.nx);
      const double x = static_cast<double>(ix % step) / static_cast<double>(step),
                   y = static_cast<double>(iy % step) / static_cast<double>(step);
      z[i++] +=
          amplitude * ((1 - y) * ((1 - x) * knots[k] + x * knots[k + 1]) + y * ((1 - x) * knots[above] + x * knots[above + 1]));
    }
}

// Like random midpoint displacement: each octave 2^-H as high as the one before.
Field self_affine(const Grid& grid, Random& random, std::int64_t shortest = 1) {
  const double hurst = random.uniform(0.1, 0.9);
  Field z(grid.points(), 0.0);
  for (std::int64_t step = shortest; step == shortest || step < std::max(grid.nx, grid.ny); step *= 2)
    add_octave(grid, step, std::pow(static_cast<double>(step), hurst), random, z);
  return z;
}

Field band_limited(const Grid& grid, Random& random) { return self_affine(grid, random, random.between(3, 8)); }

Field plateaus(const Grid& grid, Random& random) {
  Field z = self_affine(grid, random);
  const auto [low, high] = std::ranges::minmax(z);
  if (random.chance(0.5)) {  // one, of the cut tops
    const double cut = low + random.uniform(0.2, 1) * (high - low);
    for (double& value : z) value = std::min(value, cut);
  } else {  // terraces
    const double step = (high > low ? high - low : 1) / static_cast<double>(random.between(1, 8));
    for (double& value : z) value = std::round(value / step);
  }
  return z;
}

Field spikes(const Grid& grid, Random& random) {
  Field z = random.chance(0.5) ? self_affine(grid, random) : white_noise(grid, random);
  const double height = random.chance(0.3) ? 1000 : random.decades(0, 3);
  for (std::int64_t count = random.between(1, 5); count > 0; --count)
    z[static_cast<std::size_t>(random.below(grid.nx * grid.ny))] += height * random.uniform(0.5, 1);
  return z;
}

Field sphere(const Grid& grid, Random& random) {
  const double x = random.uniform(-0.2, 1.2) * static_cast<double>(grid.nx),
               y = random.uniform(-0.2, 1.2) * static_cast<double>(grid.ny);
  const double noise = random.chance(0.5) ? random.decades(-3, 2) : 0;
  return filled(grid, [&](std::int64_t ix, std::int64_t iy) {
    const double dx = static_cast<double>(ix) - x, dy = static_cast<double>(iy) - y;
    return -0.5 * (dx * dx + dy * dy) + (noise > 0 ? noise * random.normal() : 0);
  });
}

Field one_cell(const Grid& grid, Random& random) {
  Field z = self_affine(grid, random);
  const double base = std::ranges::max(z);
  z[static_cast<std::size_t>(random.below(grid.nx * grid.ny))] = base + random.decades(-2, 2);
  return z;
}

Field checkerboard(const Grid& grid, Random& random) {
  const std::int64_t side = random.between(1, 3);
  const double noise = random.chance(0.5) ? random.decades(-6, -1) : 0;
  return filled(grid, [&](std::int64_t ix, std::int64_t iy) {
    return ((ix / side + iy / side) % 2 == 0 ? 1.0 : 0.0) + (noise > 0 ? noise * random.normal() : 0);
  });
}

Field aligned_waves(const Grid& grid, Random& random) {
  Field z(grid.points(), 0.0);
  for (std::int64_t count = random.between(1, 3); count > 0; --count) {
    const auto kx = static_cast<double>(random.between(0, grid.nx / 2)), ky = static_cast<double>(random.between(0, grid.ny / 2));
    const double amplitude = random.uniform(0.2, 1);
    std::size_t i = 0;
    for (std::int64_t iy = 0; iy < grid.ny; ++iy)
      for (std::int64_t ix = 0; ix < grid.nx; ++ix)
        z[i++] += amplitude * std::cos(2 * std::numbers::pi *
                                       (kx * static_cast<double>(ix) / static_cast<double>(grid.nx) +
                                        ky * static_cast<double>(iy) / static_cast<double>(grid.ny)));
  }
  return z;
}

// A profile drawn out along x or y: rough, or a few single lines.
Field lines(const Grid& grid, Random& random) {
  const bool along_x = random.chance(0.5), single = random.chance(0.4);
  const std::int64_t across = along_x ? grid.ny : grid.nx;
  Field profile = self_affine({across, 1}, random);
  if (single) {
    std::ranges::fill(profile, 0.0);
    for (std::int64_t count = random.between(1, 3); count > 0; --count)
      profile[static_cast<std::size_t>(random.below(across))] = 1;
  }
  const double noise = random.chance(0.3) ? random.decades(-6, -1) : 0;
  return filled(grid, [&](std::int64_t ix, std::int64_t iy) {
    return profile[static_cast<std::size_t>(along_x ? iy : ix)] + (noise > 0 ? noise * random.normal() : 0);
  });
}

Field step(const Grid& grid, Random& random) {
  Field z = white_noise(grid, random);
  const double roughness = random.decades(-5, -1);
  for (std::size_t i = 0; i < z.size(); ++i) z[i] = roughness * z[i] + (i < z.size() / 2 ? 1 : 0);
  return z;
}

Field flat(const Grid& grid, Random&) { return Field(grid.points(), 0.0); }

struct Family {
  const char* name;
  Field (*make)(const Grid&, Random&);
  double share;
};
constexpr std::array families{
    Family{"self-affine", [](const Grid& g, Random& r) { return self_affine(g, r); }, 0.24},
    Family{"white", white_noise, 0.1},
    Family{"band-limited", band_limited, 0.1},
    Family{"plateaus", plateaus, 0.1},
    Family{"spikes", spikes, 0.1},
    Family{"sphere", sphere, 0.09},
    Family{"one-cell", one_cell, 0.06},
    Family{"checkerboard", checkerboard, 0.05},
    Family{"waves", aligned_waves, 0.06},
    Family{"lines", lines, 0.05},
    Family{"step", step, 0.04},
    Family{"flat", flat, 0.01},
};

}  // namespace

Heights random_heights(std::int64_t nx, std::int64_t ny, Random& random) {
  double rest = random.uniform();
  const Family* chosen = &families.front();
  for (const Family& family : families) {
    if (rest < 0) break;
    chosen = &family;
    rest -= family.share;
  }
  Heights heights{chosen->name, chosen->make({nx, ny}, random)};
  if (random.chance(0.05)) {
    heights.family += ", tilted";
    const double x = random.normal(), y = random.normal();
    for (std::size_t i = 0; i < heights.z.size(); ++i) {
      const auto column = static_cast<std::int64_t>(i) % nx, row = static_cast<std::int64_t>(i) / nx;
      heights.z[i] += x * static_cast<double>(column) + y * static_cast<double>(row);
    }
  }
  return heights;
}

}  // namespace scenes

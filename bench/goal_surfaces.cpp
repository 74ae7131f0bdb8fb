#include "goal_surfaces.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>

namespace bench {

namespace {

// The same numbers everywhere: the distributions of the standard library are not.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : bits_(seed) {}
  double uniform(double low, double high) { return low + (high - low) * std::ldexp(static_cast<double>(bits_() >> 11), -53); }
  double power_of_ten(double low, double high) { return std::pow(10, uniform(low, high)); }
  std::int64_t integer(std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(uniform(0, static_cast<double>(high - low + 1)));
  }
  bool chance(double share) { return uniform(0, 1) < share; }

 private:
  std::mt19937_64 bits_;
};

struct Heights {
  std::int64_t n;
  Field z;
  double approach = 0;  // 0: a part of the mean gap

  explicit Heights(std::int64_t side) : n(side), z(static_cast<std::size_t>(side * side)) {}
  double cell() const { return 1 / static_cast<double>(n); }
  // value(x, y, column, row, z) is the new height; x and y from the middle.
  template <class Value> void each(const Value& value) {
    for (std::int64_t iy = 0; iy < n; ++iy)
      for (std::int64_t ix = 0; ix < n; ++ix) {
        double& height = z[static_cast<std::size_t>(iy * n + ix)];
        height =
            value((static_cast<double>(ix) + 0.5) * cell() - 0.5, (static_cast<double>(iy) + 0.5) * cell() - 0.5, ix, iy, height);
      }
  }
};

double square(double x) { return x * x; }

// Adds a rough surface of this rms height.
void roughen(Heights& h, Draw& draw, double rms, double hurst, double roll_off, double cut_off) {
  SelfAffine surface;
  surface.seed = static_cast<std::uint64_t>(draw.integer(1, 1000000));
  surface.hurst = hurst;
  surface.roll_off = roll_off;
  surface.cut_off = cut_off;
  const Field rough = self_affine_gap(h.n, surface);
  double squares = 0;
  for (const double value : rough) squares += value * value;
  const double scale = rms / std::sqrt(squares / static_cast<double>(rough.size()));
  for (std::size_t i = 0; i < rough.size(); ++i) h.z[i] += scale * rough[i];
}

void sphere(Heights& h, Draw& draw, double least = -3, double most = -1.5) {
  h.each([](double x, double y, auto, auto, double z) { return z - (x * x + y * y) / 2; });
  h.approach = draw.power_of_ten(least, most);
}

// Single points outside the contact, which block means hide.
void outer_pins(Heights& h, Draw& draw) {
  const double share = draw.power_of_ten(-4, -2.3), height = draw.uniform(0, 0.6);
  h.each([&](double x, double y, auto, auto, double) {
    const double r2 = x * x + y * y;
    return r2 > 0.02 && draw.chance(share) ? draw.uniform(-height, 0) * h.cell() : -8 * r2 * h.cell();
  });
  h.approach = draw.uniform(0.3, 4) * h.cell();
}

void two_spheres(Heights& h, Draw& draw) {
  const double apart = draw.uniform(0.15, 0.3), radius = draw.power_of_ten(-1.5, 0), lower = draw.uniform(0, 0.02);
  h.each([&](double x, double y, auto, auto, double) {
    return std::max(-(square(x + apart) + y * y) / 2, -(square(x - apart) + square(y - 0.1)) / (2 * radius) - lower);
  });
  h.approach = draw.power_of_ten(-3, -1.7);
}

void scratched_sphere(Heights& h, Draw& draw) {
  sphere(h, draw);
  for (std::int64_t k = draw.integer(1, 11); k > 0; --k) {
    const double angle = draw.uniform(0, std::numbers::pi), at = draw.uniform(-0.15, 0.15),
                 width = draw.uniform(0.5, 2) * h.cell(), depth = draw.power_of_ten(-4, -2);
    h.each([&](double x, double y, auto, auto, double z) {
      return std::abs(x * std::cos(angle) + y * std::sin(angle) - at) < width ? z - depth : z;
    });
  }
}

void cone(Heights& h, Draw& draw) {
  const double slope = draw.power_of_ten(-1, 0);
  h.each([&](double x, double y, auto, auto, double) { return -slope * std::hypot(x, y); });
}

void pillars(Heights& h, Draw& draw) {
  const std::int64_t side = draw.integer(1, 8);
  for (std::int64_t k = draw.integer(3, 60); k > 0; --k) {
    const std::int64_t left = draw.integer(0, h.n - side - 1), low = draw.integer(0, h.n - side - 1);
    const double height = draw.uniform(0.005, 0.02);
    h.each([&](double, double, std::int64_t ix, std::int64_t iy, double z) {
      return ix >= left && ix < left + side && iy >= low && iy < low + side ? height : z;
    });
  }
}

void dimples(Heights& h, Draw& draw) {
  const double bend = draw.uniform(0, 0.05), depth = draw.power_of_ten(-4, -1.5);
  const std::int64_t apart = draw.integer(3, 20);
  const double radius = draw.uniform(0.2, 0.45) * static_cast<double>(apart), middle = static_cast<double>(apart) / 2;
  h.each([&](double x, double y, std::int64_t ix, std::int64_t iy, double) {
    const double r = std::hypot(static_cast<double>(ix % apart) - middle, static_cast<double>(iy % apart) - middle);
    return -bend * (x * x + y * y) - (r < radius ? depth : 0);
  });
}

void needles(Heights& h, Draw& draw) {
  roughen(h, draw, 0.003, 0.8, 4, 8);
  const double share = draw.power_of_ten(-4, -2);
  h.each([&](double, double, auto, auto, double z) { return draw.chance(share) ? z + draw.uniform(0, 0.03) : z; });
}

void steps(Heights& h, Draw& draw) {
  const double count = draw.uniform(2, 30), angle = draw.uniform(0, std::numbers::pi);
  h.each([&](double x, double y, auto, auto, double) {
    return 0.02 * std::floor((x * std::cos(angle) + y * std::sin(angle)) * count) / count - 0.02 * (x * x + y * y);
  });
}

void grating(Heights& h, Draw& draw) {
  const std::int64_t period = draw.integer(2, 16);
  const double depth = draw.power_of_ten(-4, -1.5), bend = draw.uniform(0, 0.05);
  h.each([&](double x, double y, std::int64_t ix, auto, double) {
    return (ix % period < std::max<std::int64_t>(1, period / 2) ? 0 : -depth) - bend * (x * x + y * y);
  });
}

void pits(Heights& h, Draw& draw) {
  const double bend = draw.power_of_ten(-1, 0) / 2, share = draw.power_of_ten(-3, -0.5), depth = draw.power_of_ten(-4, -2);
  h.each([&](double x, double y, auto, auto, double) { return -bend * (x * x + y * y) - (draw.chance(share) ? depth : 0); });
}

void self_affine(Heights& h, Draw& draw) {
  roughen(h, draw, 0.01, draw.uniform(0.3, 1), draw.uniform(1, 6), draw.uniform(6, static_cast<double>(h.n) / 2));
}

void long_waves(Heights& h, Draw& draw) { roughen(h, draw, 0.01, 1, 1, 3); }

void to_single_cells(Heights& h, Draw& draw) { roughen(h, draw, 0.01, draw.uniform(0.3, 0.9), 1, static_cast<double>(h.n) / 2); }

void rough_sphere(Heights& h, Draw& draw) {
  sphere(h, draw);
  roughen(h, draw, draw.power_of_ten(-4.5, -2.5), 0.8, 8, static_cast<double>(h.n) / 2);
}

void smooth_sphere(Heights& h, Draw& draw) { sphere(h, draw, -3, -1.3); }

// Every second cell is lower: half of the contact that the means show.
void checkerboard(Heights& h, Draw& draw) {
  sphere(h, draw);
  const double depth = draw.power_of_ten(-4, -2);
  h.each([&](double, double, std::int64_t ix, std::int64_t iy, double z) { return (ix + iy) % 2 == 0 ? z : z - depth; });
}

// A rim one cell wide around a sphere, hidden in the means of what lies lower beside it.
void rim(Heights& h, Draw& draw) {
  sphere(h, draw, -3, -1.7);
  const double radius = draw.uniform(0.2, 0.45), below = draw.power_of_ten(-4, -2);
  h.each([&](double x, double y, auto, auto, double z) {
    return std::abs(std::hypot(x, y) - radius) < 0.7 * h.cell() ? -below : z;
  });
}

// Wires one cell wide beside a ridge.
void wires(Heights& h, Draw& draw) {
  h.each([](double x, double, auto, auto, double) { return -0.05 * std::abs(x); });
  for (std::int64_t k = draw.integer(1, 10); k > 0; --k) {
    const std::int64_t at = draw.integer(0, h.n - 1);
    const double below = draw.power_of_ten(-4, -2);
    h.each([&](double, double, std::int64_t ix, auto, double z) { return ix == at ? -below : z; });
  }
  h.approach = draw.power_of_ten(-3, -1.7);
}

// A flat punch whose edge stands up by one cell.
void raised_edge(Heights& h, Draw& draw) {
  const double half = draw.uniform(0.1, 0.4), edge = draw.power_of_ten(-4, -2);
  h.each([&](double x, double y, auto, auto, double) {
    const double r = std::max(std::abs(x), std::abs(y));
    return std::abs(r - half) < 0.6 * h.cell() ? edge : r < half ? 0.0 : -0.05;
  });
  h.approach = draw.power_of_ten(-3, -1.7);
}

// Grains of one cell on a plane, a few of them high.
void dust(Heights& h, Draw& draw) {
  const double share = draw.power_of_ten(-4, -2.5);
  h.each([&](double, double, auto, auto, double) {
    return draw.chance(share) ? std::min(0.05, 0.0005 + 0.001 * (std::pow(draw.uniform(0, 1), -1 / 1.5) - 1)) : 0.0;
  });
  h.approach = draw.power_of_ten(-3, -2);
}

// A bed of pins just below the approach, all outside the contact of the coarser grids.
void bed_of_pins(Heights& h, Draw& draw) {
  sphere(h, draw, -2.7, -1.8);
  const std::int64_t apart = draw.integer(2, 8);
  const double top = -draw.uniform(0.3, 1.2) * h.approach, free = 2.5 * h.approach;
  h.each([&](double x, double y, std::int64_t ix, std::int64_t iy, double z) {
    return ix % apart == 0 && iy % apart == 0 && x * x + y * y > free ? std::max(z, top) : z;
  });
}

void rough_saddle(Heights& h, Draw& draw) {
  h.each([](double x, double y, auto, auto, double) { return 0.02 * (x * x - y * y); });
  roughen(h, draw, draw.power_of_ten(-4, -2.5), 0.8, 2, static_cast<double>(h.n) / 2);
}

void terraces(Heights& h, Draw& draw) {
  sphere(h, draw, -2.7, -1.5);
  const double step = draw.power_of_ten(-4, -3);
  h.each([&](double, double, auto, auto, double z) { return std::round(z / step) * step; });
}

// Noise of single cells, from even to a few deep ones.
void noisy_sphere(Heights& h, Draw& draw) {
  sphere(h, draw);
  const double depth = draw.power_of_ten(-4, -2), skew = draw.uniform(0.3, 6);
  h.each([&](double, double, auto, auto, double z) { return z - depth * std::pow(draw.uniform(0, 1), skew); });
}

void cylinder(Heights& h, Draw& draw) {
  const double angle = draw.uniform(0, std::numbers::pi);
  h.each([&](double x, double y, auto, auto, double) { return -square(x * std::cos(angle) + y * std::sin(angle)) / 2; });
  h.approach = draw.power_of_ten(-3, -1.5);
}

// Needles in pairs with pits beside them, so that the means of blocks show neither.
void dipoles(Heights& h, Draw& draw) {
  sphere(h, draw, -3, -1.7);
  const double share = draw.power_of_ten(-4, -2), size = draw.uniform(0.2, 3) * h.approach;
  for (std::size_t i = 0; i + 1 < h.z.size(); i += 2)
    if (draw.chance(share)) {
      h.z[i] += size;
      h.z[i + 1] -= size;
    }
}

// Waves of two and three cells, which alias on coarser grids.
void shortest_waves(Heights& h, Draw& draw) {
  sphere(h, draw);
  const double size = draw.power_of_ten(-4.5, -2.5), kx = draw.uniform(1.8, 3.1), ky = draw.uniform(0, 3.1);
  h.each([&](double, double, std::int64_t ix, std::int64_t iy, double z) {
    return z + size * std::cos(kx * static_cast<double>(ix) + ky * static_cast<double>(iy));
  });
}

struct Kind {
  const char* name;
  void (*make)(Heights&, Draw&);
};
constexpr Kind kinds[] = {{"sphere-outer-pins", outer_pins},
                          {"two-spheres", two_spheres},
                          {"scratched-sphere", scratched_sphere},
                          {"cone", cone},
                          {"pillars", pillars},
                          {"dimples", dimples},
                          {"needles", needles},
                          {"steps", steps},
                          {"grating", grating},
                          {"pits", pits},
                          {"waves-self-affine", self_affine},
                          {"long-waves", long_waves},
                          {"to-single-cells", to_single_cells},
                          {"rough-sphere", rough_sphere},
                          {"smooth-sphere", smooth_sphere},
                          {"checkerboard", checkerboard},
                          {"rim", rim},
                          {"wires", wires},
                          {"raised-edge", raised_edge},
                          {"dust", dust},
                          {"bed-of-pins", bed_of_pins},
                          {"rough-saddle", rough_saddle},
                          {"terraces", terraces},
                          {"noisy-sphere", noisy_sphere},
                          {"cylinder", cylinder},
                          {"dipoles", dipoles},
                          {"shortest-waves", shortest_waves}};

void leave_out(GoalSurface& surface, Draw& draw, bool parts) {
  const rc_system& s = surface.system;
  surface.mask.assign(surface.gap.size(), 1);
  if (!parts) {
    for (std::uint8_t& counts : surface.mask) counts = !draw.chance(0.1);
    return;
  }
  for (int k = 0; k < 6; ++k) {
    const std::int64_t left = draw.integer(0, s.nx - 5), low = draw.integer(0, s.ny - 5);
    const std::int64_t right = std::min(s.nx, left + draw.integer(2, 30)), high = std::min(s.ny, low + draw.integer(2, 30));
    for (std::int64_t iy = low; iy < high; ++iy)
      for (std::int64_t ix = left; ix < right; ++ix) surface.mask[static_cast<std::size_t>(iy * s.nx + ix)] = 0;
  }
}

}  // namespace

std::vector<std::string> goal_surface_names() {
  std::vector<std::string> names;
  for (const Kind& kind : kinds) names.emplace_back(kind.name);
  return names;
}

GoalSurface make_goal_surface(const std::string& name, std::int64_t n, std::uint64_t seed) {
  const auto kind = std::find_if(std::begin(kinds), std::end(kinds), [&](const Kind& each) { return name == each.name; });
  if (kind == std::end(kinds)) throw Failure("unknown surface \"" + name + "\"");
  Draw draw(seed * 1009 + static_cast<std::uint64_t>(kind - kinds));
  const std::int64_t side = seed % 2 == 0 ? draw.integer(4 * n / 5, 6 * n / 5) : n;
  Heights heights(side);
  kind->make(heights, draw);
  GoalSurface surface;
  surface.system = unit_square(side);
  const double top = *std::max_element(heights.z.begin(), heights.z.end());
  for (const double z : heights.z) surface.gap.push_back(top - z);
  surface.approach = heights.approach;
  if (surface.approach == 0) {
    const double mean = std::accumulate(surface.gap.begin(), surface.gap.end(), 0.0) / static_cast<double>(surface.gap.size());
    const bool periodic = draw.chance(0.4);
    if (periodic) surface.system.boundary = RC_BOUNDARY_PERIODIC;
    surface.approach = mean * draw.power_of_ten(-1, periodic ? -0.25 : 0);
  }
  if (seed % 5 == 3) surface.system.hy *= draw.power_of_ten(-1.3, 1.3);
  if (seed % 5 == 4 && surface.system.boundary == RC_BOUNDARY_FREE) {
    surface.system.ny /= draw.integer(2, 4);
    surface.gap.resize(static_cast<std::size_t>(surface.system.nx * surface.system.ny));
  }
  if (seed % 7 >= 5) leave_out(surface, draw, seed % 7 == 6);
  return surface;
}

}  // namespace bench

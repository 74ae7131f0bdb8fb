#include <cmath>
#include <limits>

#include "known_answers.h"
#include "problems.h"

namespace mutants {

rc::Bounds put(Figures& figures, const std::string& name, const Small& small, rc::ProvenSets* sets) {
  if (!figures.wants(name)) return {};
  const rc::System system = small.system();
  const rc::StepSurface surface = small.surface();
  const rc::Bounds bounds =
      prove_bounds(system, spectrum_of(system), surface, small.compression, small.answer, small.survey(), sets);
  figures.section(name);
  figures.exact("gap", bounds.duality_gap);
  figures.exact("gap_error", bounds.gap_error);
  figures.exact("lower", bounds.load_lower);
  figures.exact("upper", bounds.load_upper);
  figures.exact("area_lower", bounds.area_lower);
  figures.exact("area_upper", bounds.area_upper);
  figures.exact("contacts", static_cast<double>(bounds.proven_contacts));
  figures.exact("open", static_cast<double>(bounds.proven_open));
  figures.exact("undecided", static_cast<double>(bounds.undecided));
  return bounds;
}

std::vector<Small> systems() {
  std::vector<Small> all;
  for (const char* kernel : {"love", "galerkin", "disc", "punch", "eq9"}) {
    all.emplace_back(6, 5);
    all.back().kernel = kernel;
  }
  all.emplace_back(3, 8);
  all.back().given.hx = 0.3;
  all.back().given.hy = 1.7;
  all.emplace_back(1, 1);
  for (const std::int64_t ny : {4, 7}) {
    all.emplace_back(5, ny);
    all.back().given.boundary = RC_BOUNDARY_PERIODIC;
  }
  all.back().given.hx = 0.4;
  all.emplace_back(9, 1);
  all.back().make_dense(1e-3);
  for (const std::int32_t boundary : {RC_BOUNDARY_PERIODIC_X, RC_BOUNDARY_PERIODIC_Y}) {
    all.emplace_back(6, 4);
    all.back().given.hx = 0.7;
    all.back().given.boundary = boundary;
  }
  return all;
}

namespace {

// What a certificate meets, at every size of the residual, down to nothing but round-off.
void residuals_of_all_sizes(Figures& figures) {
  int number = 0;
  for (Small small : systems()) {
    ++number;
    for (const double off : {0.3, 1e-2, 1e-5, 0.0})
      for (const double depth : {0.15, 0.45, 2.0}) {
        if (small.system().periodic() && depth > 1) continue;
        small.press(depth, off, 7);
        put(figures, "sizes" + std::to_string(number) + "/" + std::to_string(off) + "/" + std::to_string(depth), small);
      }
  }
}

// Pressures where there should be none, negative ones, masks, and nothing at all.
void odd_answers(Figures& figures) {
  int number = 0;
  for (const Small& plain : systems()) {
    const std::string name = "odd" + std::to_string(++number) + "/";
    const std::size_t n = plain.points(), last = n - 1;
    for (const double off : {1e-2, 1e-6, 0.0}) {
      const std::string size = std::to_string(off);
      Small small = plain;
      small.press(0.4, off, 3);
      std::vector<double>& p = small.answer.pressures.p;
      std::vector<double>& product = small.answer.product;
      p[0] = 1e-5;
      put(figures, name + "stray/" + size, small);
      p[n / 2] = 0.3;
      product[n / 2] += 0.2;
      put(figures, name + "far/" + size, small);
      p[0] = -1e-4;
      p[last] = -0.2;
      put(figures, name + "negative/" + size, small);
      for (double& value : p) value = 0;
      put(figures, name + "none/" + size, small);
      for (double& value : product) value = 0;
      put(figures, name + "nothing/" + size, small);
      small.press(-0.2, off, 3);
      put(figures, name + "apart/" + size, small);
      small.answer.product.assign(n, 0.0);
      put(figures, name + "apart_and_nothing/" + size, small);
      small.press(0.4, off, 3);
      small.answer.pressures.p[0] = 1;
      small.answer.pressures.p[last] = -1;
      put(figures, name + "ones/" + size, small);
      small.answer.product[last] = -3;
      put(figures, name + "deep/" + size, small);
      for (const double strange : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
        small.press(0.4, off, 3);
        for (std::size_t i = 0; i < n; ++i)
          if (small.answer.pressures.p[i] > 0) {
            small.answer.pressures.p[i] = strange;
            put(figures, name + "strange_pressure/" + size, small);
            small.press(0.4, off, 3);
            small.answer.product[i] = strange;
            put(figures, name + "strange_product/" + size, small);
            break;
          }
      }

      small.mask.assign(n, 1);
      for (std::size_t i = 0; i < n; i += 3) small.mask[i] = 0;
      small.press(0.4, off, 5);
      if (n > 1) put(figures, name + "mask/" + size, small);
      small.mask.assign(n, 0);
      small.press(0, off, 5);
      put(figures, name + "all_masked/" + size, small);
      small.answer.product.assign(n, 0.0);
      put(figures, name + "all_masked_and_nothing/" + size, small);

      // Far above everything else, the doubt about every gap.
      small = plain;
      small.gap[last] = 1e7;
      if (!plain.system().periodic()) small.press(0.4, off, 9), put(figures, name + "far_point/" + size, small);
      small = plain;
      for (double& h : small.gap) h += 0.1;
      for (const double depth : {1.0 / 3, 0.4, 0.23, 1e-5 / 3}) {
        small.press(depth, off, 9);
        put(figures, name + "datum/" + std::to_string(depth) + size, small);
      }
      for (double& h : small.gap) h += 1e9;
      put(figures, name + "far_datum/" + size, small);
    }
  }
}

// Pressures that are a solution but for one point that lies apart: what is open shrinks the punch.
void proofs_in_rounds(Figures& figures) {
  for (const double off : {1e-3, 1e-7, 1e-12}) {
    Small small(14, 11);
    for (std::size_t i = 0; i < small.points(); ++i) {
      const double x = static_cast<double>(i % 14) - 4, y = static_cast<double>(i / 14) - 5;
      small.gap[i] = 0.02 * (x * x + y * y);
    }
    for (const double depth : {0.05, 0.3, 1.5, 20.0}) {
      small.press(depth, off, 1);
      const std::string name = "rounds/" + std::to_string(off * 1e6) + "/" + std::to_string(depth);
      put(figures, name, small);
      small.answer.pressures.p[153] = 1e-3 * off;
      put(figures, name + "/stray", small);
      small.given.boundary = RC_BOUNDARY_PERIODIC;
      if (depth < 0.6) put(figures, name + "/periodic", small);
      small.mask.assign(small.points(), 1);
      small.mask[100] = 0;
      small.answer.pressures.p[100] = 0;
      put(figures, name + "/mask", small);
      small.mask.clear();
      small.given.boundary = RC_BOUNDARY_FREE;
    }
  }
}

// A periodic surface from far below the mean plane to just below, and above.
void near_the_mean_plane(Figures& figures) {
  for (const double below : {0.3, 1e-2, 1e-4, 1e-8, -1e-3})
    for (const double off : {1e-2, 1e-6, 1e-12}) {
      Small small(6, 6);
      small.given.boundary = RC_BOUNDARY_PERIODIC;
      small.press(small.surface().moments().mean - below, off, 2);
      const std::string name = "mean/" + std::to_string(below * 1e6) + "/" + std::to_string(off * 1e6);
      put(figures, name, small);
      Small stray = small;
      stray.answer.pressures.p[5] = stray.answer.pressures.p[20] = 1e-3 * off;
      put(figures, name + "/stray", stray);
      for (double& h : small.gap) h += 3e7;
      put(figures, name + "/far_datum", small);
    }
}

// A point without pressure far above all others sets the unit of length: beside it the surface is nearly flat, so the mean gap
// tells more of the load than the points that may carry.
void flat_beside_one_deflection(Figures& figures) {
  for (const double off : {1e-2, 1e-6})
    for (const double stray : {0.0, 1e-3, 3e-2}) {
      Small small(6, 6);
      small.given.boundary = RC_BOUNDARY_PERIODIC;
      small.press(small.surface().moments().mean - 0.1, off, 2);
      std::size_t last = 0;
      for (std::size_t i = 0; i < small.points(); ++i)
        if (!(small.answer.pressures.p[i] > 0)) last = i;
      small.answer.product[last] = 100;
      for (std::size_t i = 0; i < last; ++i)
        if (!(small.answer.pressures.p[i] > 0)) small.answer.pressures.p[i] = stray;
      put(figures, "flat/" + std::to_string(off * 1e6) + "/" + std::to_string(stray), small);
    }
}

void unlisted_points(Figures& figures) {
  Small small(8, 6);
  small.press(0.35, 1e-4, 4);
  const rc::Deflected all = small.answer;
  std::vector<std::int64_t> pressed, more, some;
  for (std::size_t i = 0; i < small.points(); ++i) {
    if (i % 3 != 1) some.push_back(static_cast<std::int64_t>(i));
    if (all.pressures.p[i] > 0) pressed.push_back(static_cast<std::int64_t>(i));
    if (all.pressures.p[i] > 0 || i % 5 == 0) more.push_back(static_cast<std::int64_t>(i));
  }
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double beyond : {infinite, 0.1, 1e-4, 0.0})
    for (const std::vector<std::int64_t>& listed : {pressed, more, some})
      for (const bool stray : {false, true}) {
        small.answer = all;
        if (stray) small.answer.pressures.p[40] = small.answer.pressures.p[static_cast<std::size_t>(listed[0])] = 1e-5;
        small.list(listed, beyond);
        const std::string name =
            "unlisted/" + std::to_string(beyond) + "/" + std::to_string(listed.size()) + (stray ? "/stray" : "");
        put(figures, name, small);
        Small masked = small;
        masked.mask.assign(small.points(), 1);
        for (const std::int64_t i : {1, 7, 13, 22, 31, 46}) masked.mask[static_cast<std::size_t>(i)] = 0;
        put(figures, name + "/mask", masked);
        Small lifted = small;
        for (double& h : lifted.gap) h += 0.1;
        put(figures, name + "/datum", lifted);
        Small above = small;
        above.gap[static_cast<std::size_t>(listed[0])] = 3;
        put(figures, name + "/first_above", above);
        small.answer.pressures.p[2] = -0.2;
        put(figures, name + "/negative", small);
        Small below = small;
        below.compression = 20;
        below.answer.product[1] += 3;
        put(figures, name + "/negative_all_below", below);
        small.answer.product[2] = -4;
        put(figures, name + "/deep", small);
        small.gap[45] = 50;
        put(figures, name + "/high", small);
        small.gap[45] = small.gap[44];
        small.compression = 20;
        put(figures, name + "/all_below", small);
        small.compression = 0.35;
      }
}

}  // namespace

void figures_of_bounds(Figures& figures) {
  residuals_of_all_sizes(figures);
  odd_answers(figures);
  proofs_in_rounds(figures);
  near_the_mean_plane(figures);
  flat_beside_one_deflection(figures);
  unlisted_points(figures);
}

}  // namespace mutants

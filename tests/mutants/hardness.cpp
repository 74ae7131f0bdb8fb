// Certificates and bounds with 0 <= p <= c: pressures at both ends, right and wrong, and the sets that bound the stiffness.
#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/proof/certificate.h"
#include "known_answers.h"
#include "problems.h"

namespace mutants {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

double number_of(const std::vector<std::int64_t>& points) {
  double sum = static_cast<double>(points.size());
  for (const std::int64_t i : points) sum = 3 * sum + static_cast<double>(i + 1);
  return sum;
}

void put_all(Figures& figures, const std::string& name, const Small& small) {
  if (!figures.wants("capped/" + name)) return;
  rc::ProvenSets sets;
  const rc::Bounds bounds = put(figures, "capped/" + name, small, &sets);
  figures.exact("capped", static_cast<double>(bounds.proven_capped));
  figures.exact("below", number_of(sets.contacts));
  figures.exact("possible", number_of(sets.possible));
  const rc::Certificate c =
      certify(small.surface(), small.compression, small.answer, small.survey(), 0.3, small.system().hardness);
  figures.exact("primal", c.primal);
  figures.exact("dual", c.dual);
  figures.exact("complementarity", c.complementarity);
}

// A point that carries the hardness, one that carries less, and one that is open.
struct Points {
  std::size_t at_cap, free, open;
};

Points points_of(const Small& small) {
  Points found{0, 0, 0};
  const std::vector<double>& p = small.answer.pressures.p;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (!(small.mask.empty() || small.mask[i])) continue;
    (p[i] >= small.given.hardness ? found.at_cap : p[i] > 0 ? found.free : found.open) = i;
  }
  return found;
}

// Each end of 0 <= p <= c, met by the pressures, missed by little, and missed by much.
void both_ends(Figures& figures, const std::string& name, const Small& right) {
  put_all(figures, name, right);
  const double c = right.given.hardness;
  const Points at = points_of(right);
  std::size_t number = 0;
  const auto change = [&](std::size_t point, double pressure, double product) {
    Small wrong = right;
    wrong.answer.pressures.p[point] = pressure;
    wrong.answer.product[point] += product;
    put_all(figures, name + "/change" + std::to_string(number++), wrong);
  };
  for (const double less : {1e-12, 1e-6, 1e-2, 0.5, 1.0}) change(at.at_cap, c * (1 - less), 0);
  for (const double more : {1e-13, 1e-6, 1e-2, 0.5}) change(at.at_cap, c * (1 + more), 0);
  for (const double product : {-1.0, -1e-4, 1e-4, 0.3}) change(at.at_cap, c, product), change(at.at_cap, 0.9999 * c, product);
  for (const double product : {-1.0, -1e-3, 1e-3, 1.0}) change(at.free, right.answer.pressures.p[at.free], product);
  for (const double share : {0.0, 0.3, 1.0, 2.0}) change(at.free, share * c, -0.1);
  for (const double share : {-1e-3, 1e-6, 1.0, 1.5}) change(at.open, share * c, 0), change(at.open, share * c, -0.4);
  Small wrong = right;
  wrong.answer.pressures.p[at.at_cap] *= 1.1;
  wrong.answer.pressures.p[at.free] *= -0.2;
  wrong.answer.pressures.p[at.open] = 0.01 * c;
  put_all(figures, name + "/all", wrong);
  for (double& p : wrong.answer.pressures.p) p = p > 0 ? c : 0;
  put_all(figures, name + "/only_ends", wrong);
  for (double& p : wrong.answer.pressures.p) p *= 1 + 1e-9;
  put_all(figures, name + "/above", wrong);
}

void all_systems(Figures& figures) {
  const std::vector<Small> all = systems();
  for (const std::size_t number : {0, 5, 6, 7, 9}) {
    Small small = all[number];
    for (const double off : {0.1, 1e-4, 0.0})
      for (const double depth : {0.4, 0.9})  // the last is above the mean plane
        for (const double share : {0.2, 0.7}) {
          small.press(depth, off, 11);
          small.cap(share * depth * small.given.modulus);
          const std::string name =
              std::to_string(number) + "/" + std::to_string(off) + "/" + std::to_string(depth) + "/" + std::to_string(share);
          both_ends(figures, name, small);
          if (small.points() == 1) continue;
          Small masked = small;
          masked.mask.assign(small.points(), 1);
          for (std::size_t i = 1; i < small.points(); i += 3) masked.mask[i] = 0;
          masked.press(depth, off, 11);
          masked.cap(share * depth * small.given.modulus);
          put_all(figures, name + "/mask", masked);
        }
  }
}

// A periodic surface just below the mean plane, in it, and above: the hardness bounds the load there.
void around_the_mean_plane(Figures& figures) {
  for (const double below : {0.1, 1e-3, 1e-9, 0.0, -1e-9, -1e-3, -0.1, -3.0})
    for (const double off : {1e-2, 1e-6, 1e-12})
      for (const double c : {0.05, 0.4, 9.0}) {
        Small small(6, 6);
        small.given.boundary = RC_BOUNDARY_PERIODIC;
        small.press(small.surface().moments().mean - below, off, 2);
        small.cap(c);
        const std::string name =
            "mean/" + std::to_string(below * 1e6) + "/" + std::to_string(off * 1e6) + "/" + std::to_string(c);
        put_all(figures, name, small);
        small.answer.pressures.p[5] = small.answer.pressures.p[20] = 1e-3 * off;
        put_all(figures, name + "/stray", small);
        for (double& h : small.gap) h += 3e7;
        put_all(figures, name + "/far_datum", small);
      }
}

// The sets of points, and those that a list leaves out.
void unlisted_capped_points(Figures& figures) {
  for (const double c : {infinite, 0.5, 0.2}) {
    Small small(8, 6);
    small.press(0.35, 1e-4, 4);
    small.cap(c);
    const rc::Deflected all = small.answer;
    std::vector<std::int64_t> pressed, more, some;
    for (std::size_t i = 0; i < small.points(); ++i) {
      if (i % 3 != 1) some.push_back(static_cast<std::int64_t>(i));
      if (all.pressures.p[i] > 0) pressed.push_back(static_cast<std::int64_t>(i));
      if (all.pressures.p[i] > 0 || i % 5 == 0) more.push_back(static_cast<std::int64_t>(i));
    }
    for (const double beyond : {infinite, 0.1, 1e-4, 0.0})
      for (const std::vector<std::int64_t>& listed : {pressed, more, some}) {
        small.answer = all;
        small.list(listed, beyond);
        put_all(figures, "unlisted/" + std::to_string(c) + "/" + std::to_string(beyond) + "/" + std::to_string(listed.size()),
                small);
        small.answer.pressures.p[1] = 1.2 * std::min(c, 1.0);
        small.answer.pressures.p[2] = 0.99 * std::min(c, 1.0);
        put_all(figures,
                "unlisted/" + std::to_string(c) + "/" + std::to_string(beyond) + "/" + std::to_string(listed.size()) + "/wrong",
                small);
      }
  }
}

// Full contact and nothing between the ends: the load is known from the number of points alone.
void all_at_the_hardness(Figures& figures) {
  for (Small small : systems())
    for (const double c : {1e-9, 1e-2}) {
      small.press(small.system().periodic() ? 0.9 : 3, 1e-3, 6);
      small.cap(c);
      const std::string name = "all/" + std::to_string(small.points()) + small.kernel + std::to_string(c * 1e3) +
                               std::to_string(small.given.hx) + std::to_string(small.given.boundary);
      put_all(figures, name, small);
      small.answer.pressures.p[0] = 0.5 * c;
      put_all(figures, name + "/half", small);
      small.answer.product[0] = 7;
      put_all(figures, name + "/apart", small);
    }
}

// Gaps that are rounded sums, above a datum that leaves them few digits. Some points are above the compression by less than that.
void rounded_gaps(Figures& figures) {
  const std::vector<Small> all = systems();
  for (const std::size_t number : {0, 7, 9})
    for (const double datum : {-3e6, 4e6})
      for (const double c : {0.3, infinite}) {
        Small small = all[number];
        small.summed = true;
        for (double& h : small.gap) h += datum;
        small.press(0.4, 1e-9, 8);
        small.cap(c);
        const std::string name = "rounded/" + std::to_string(number) + "/" + std::to_string(datum) + "/" + std::to_string(c);
        put_all(figures, name, small);
        const double lowest = *std::min_element(small.gap.begin(), small.gap.end());
        std::vector<std::int64_t> pressed;
        for (std::size_t i = 0; i < small.points(); ++i)
          if (small.answer.pressures.p[i] > 0) pressed.push_back(static_cast<std::int64_t>(i));
        for (const double above : {6e-10, 1.2e-9}) {
          Small near = small;
          near.gap.back() = lowest + small.compression + above;
          near.answer.product.back() = small.compression;
          const std::string at = name + "/" + std::to_string(above * 1e9);
          put_all(figures, at, near);
          near.list(pressed, infinite);
          put_all(figures, at + "/unlisted", near);
          near.answer.beyond = 0.1;
          put_all(figures, at + "/beyond", near);
        }
      }
}

void certificates(Figures& figures) {
  const auto put_certificate = [&figures](const std::string& name, const Small& small, double scale, double hardness) {
    if (!figures.wants("capped_certificate/" + name)) return;
    const rc::Certificate c = certify(small.surface(), small.compression, small.answer, small.survey(), scale, hardness);
    figures.section("capped_certificate/" + name);
    figures.exact("primal", c.primal);
    figures.exact("dual", c.dual);
    figures.exact("complementarity", c.complementarity);
  };
  for (const double p : {-0.1, 0.0, 0.3, 0.7, 1.0, 1.2})
    for (const double gap : {-0.5, -1e-3, 0.0, 1e-3, 0.5})
      for (const double hardness : {0.5, 1.0, 4.0, infinite})
        for (const double scale : {0.2, 3.0}) {
          Small small(2, 1);
          small.gap = {0, 0.25};
          small.compression = 0.75;
          small.answer.pressures.on.n = 2;
          small.answer.pressures.p = {p, 0.4};
          small.answer.product = {0.75 + gap, 0.5};
          put_certificate(
              std::to_string(p) + "/" + std::to_string(gap) + "/" + std::to_string(hardness) + "/" + std::to_string(scale), small,
              scale, hardness);
        }
}

}  // namespace

void figures_of_hardness(Figures& figures) {
  all_systems(figures);
  around_the_mean_plane(figures);
  unlisted_capped_points(figures);
  all_at_the_hardness(figures);
  rounded_gaps(figures);
  certificates(figures);
}

}  // namespace mutants

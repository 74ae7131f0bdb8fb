#include "kernel/density.h"

#include <cmath>
#include <numbers>

namespace rc::kernel {

namespace {

constexpr int points = 12;

// Legendre's P_n and its derivative at z, by the three-term recurrence.
struct Legendre {
  double value, slope;
};
Legendre legendre(double z) {
  double previous = 1, current = z;
  for (int n = 2; n <= points; ++n) {
    const double next = ((2 * n - 1) * z * current - (n - 1) * previous) / n;
    previous = current;
    current = next;
  }
  return {current, points * (previous - z * current) / ((1 - z) * (1 + z))};
}

// Gauss-Legendre on [0, 1], weights of sum 1; Newton's iteration from the asymptotic roots.
Density computed_gauss() {
  Density rule{points, {}, {}};
  for (int i = 0; i < points; ++i) {
    double z = -std::cos(std::numbers::pi * (i + 0.75) / (points + 0.5));
    for (int step = 0; step < 5; ++step) z -= legendre(z).value / legendre(z).slope;
    const double slope = legendre(z).slope;
    rule.node[i] = (1 + z) / 2;
    rule.weight[i] = 1 / ((1 - z) * (1 + z) * slope * slope);
  }
  return rule;
}

const Density& gauss() {
  static const Density rule = computed_gauss();
  return rule;
}

}  // namespace

Density box(double side) {
  Density rule = gauss();
  for (int i = 0; i < points; ++i) rule.node[i] = side * (rule.node[i] - 0.5);
  return rule;
}

Density tent(double side) {
  const Density& half = gauss();
  Density rule{2 * points, {}, {}};
  for (int i = 0; i < points; ++i) {
    rule.node[i] = side * half.node[i];
    rule.node[points + i] = -rule.node[i];
    rule.weight[i] = rule.weight[points + i] = half.weight[i] * (1 - half.node[i]);
  }
  return rule;
}

}  // namespace rc::kernel

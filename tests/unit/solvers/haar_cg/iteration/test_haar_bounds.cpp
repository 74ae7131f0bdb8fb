// What keeps the iteration of haar-cg from a step too far: how much the trees' datum raises the limit of the free set, and by how
// much pressures are stretched. The plain machine tells each.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <vector>

#include "kernel/kernel.h"
#include "solvers/haar_cg/iteration/iteration.h"
#include "solvers/haar_cg/plain/machine.h"
#include "support/cmocka.hpp"
#include "trees/tree_inputs.h"

namespace {

using Field = std::vector<double>;
constexpr std::int64_t side = 24;
constexpr std::size_t points = side * side;
constexpr double infinite = std::numeric_limits<double>::infinity();

// Waves, the highest point of which overlaps by 1.
Field waves(double roughness) {
  Field u;
  for (std::size_t i = 0; i < points; ++i) {
    const double x = static_cast<double>(i % side), y = static_cast<double>(i / side);
    u.push_back(roughness * std::sin(0.6 * x + 0.2 * y) * std::cos(0.5 * y));
  }
  const double highest = *std::max_element(u.begin(), u.end());
  for (double& value : u) value += 1 - highest;
  return u;
}

struct Coefficients {
  Field k = Field(points);

  Coefficients() { rc::kernel::coefficients(*rc::kernel::find("love"), 1, 1, side, side, k.data()); }
  void multiply(const Field& x, Field& y) const {
    const auto apart = [](std::size_t a, std::size_t b) { return a > b ? a - b : b - a; };
    for (std::size_t i = 0; i < points; ++i) {
      y[i] = 0;
      for (std::size_t j = 0; j < points; ++j) y[i] += k[apart(i / side, j / side) * side + apart(i % side, j % side)] * x[j];
    }
  }
};

struct Choice {
  double threshold, largest, mean;  // mean: of w, weighted by the pressures
};

class Watched : public rc::PlainMachine<double> {
 public:
  Watched(const Coefficients& h, const Field& u, double pressure)
      : PlainMachine(
            u, Field(points, pressure), infinite, [&h](const Field& x, Field& y) { h.multiply(x, y); }, tree(h, false),
            tree(h, true)) {}

  rc::HaarMeasure add_and_measure(Vector change, double shift) {
    now_ = PlainMachine::add_and_measure(change, shift);
    best.push_back(-now_.moment / (2 * (now_.moment - now_.merit)));
    return now_;
  }
  rc::HaarMeasure replace_and_measure(Wide product, double shift) {
    return now_ = PlainMachine::replace_and_measure(product, shift);
  }
  rc::HaarMeasure grow_and_measure(double share) { return now_ = PlainMachine::grow_and_measure(share); }
  bool choose_set(double threshold) {
    choices.push_back({threshold, now_.largest, now_.moment / now_.load});
    return PlainMachine::choose_set(threshold);
  }
  void multiply(double factor, bool free) {
    stretched.push_back(factor - 1);
    PlainMachine::multiply(factor, free);
  }

  std::vector<Choice> choices;
  Field best, stretched;  // shares: of the pressures' best multiple at each bound; by which they were stretched

 private:
  static rc::PlainTree tree(const Coefficients& h, bool second) {
    return {side, side, rc::CouplingTable{side, side, h.k, 1, 1}, second};
  }

  rc::HaarMeasure now_;
};

void run(Watched& machine, const rc::HaarTask& task) {
  const auto poll = [&](std::int64_t, double) { return machine.choices.size() < 12; };
  rc::HaarIteration(machine, task, poll).run(0);
}

// Some of the free set's limits would be higher still: the mean of w is further below 0 there than the bound allows for.
void the_trees_datum_raises_the_limit_of_the_set_by_a_bounded_part(void**) {
  constexpr double most_swing = 6, admission = rc::HaarPace::first_admission;
  const Coefficients h;
  Watched machine(h, waves(1), 0.2);
  run(machine, {.by_load = true, .load = 0.2 * points, .tol = 1e-9, .patience = 100});
  int raised = 0, beyond = 0;
  for (const Choice& choice : machine.choices) {
    const double limit = admission * choice.largest;
    raised += choice.threshold > 2 * limit;
    beyond += choice.mean < -1.1 * most_swing * limit;
    assert_true(choice.threshold <= (1 + most_swing) * limit * (1 + 1e-12));
  }
  std::printf("%zu sets, %d limits raised, %d of them by the most\n", machine.choices.size(), raised, beyond);
  assert_true(raised > 1 && beyond > 0);
}

// At the first bounds the set is not known yet, and the best multiple is far off.
void pressures_are_stretched_by_a_bounded_part(void**) {
  constexpr double most = 0.01;
  const Coefficients h;
  Watched machine(h, waves(0.7), 0);
  run(machine, {.tol = 1e-9, .patience = 100});
  const auto larger = [](double share) { return std::abs(share) > most; };
  std::printf("best shares %g, %g, ..., taken %zu of %zu\n", machine.best.at(0), machine.best.at(1), machine.stretched.size(),
              machine.best.size());
  assert_true(std::count_if(machine.best.begin(), machine.best.end(), larger) > 1);
  assert_false(machine.stretched.empty());
  assert_true(std::none_of(machine.stretched.begin(), machine.stretched.end(), larger));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(the_trees_datum_raises_the_limit_of_the_set_by_a_bounded_part),
                              cmocka_unit_test(pressures_are_stretched_by_a_bounded_part)};
  return cmocka_run_group_tests_name("unit.haar_bounds", tests, nullptr, nullptr);
}

// A law from the origin to its first node, and between two nodes.
#include <cmath>

#include "law/interval.h"
#include "support/cmocka.hpp"

namespace {

using namespace rc;

// At x = p = 1. Beyond a slope of 2 one parabola from the origin cannot have it: then a knot's place gives the energy.
void the_first_interval_has_the_nodes_value_slope_and_energy(void**) {
  for (const double slope : {1.1, 1.5, 1.9, 2.5, 4.0, 20.0})
    for (const double share : {0.01, 0.2, 0.4, 0.6, 0.8, 0.99}) {
      rc_law_point node = RC_LAW_POINT_INIT;
      node.x = node.p = 1;
      node.slope = slope;
      node.energy = (1 - share) / (2 * slope) + share / 2;  // from nothing before a jump to `slope`, to a straight line
      const LawInterval found = up_to_first(node);
      assert_true(std::abs(found.before.length + found.after.length - 1) <= 1e-12);
      assert_true(std::abs(found.before.rise() + found.after.rise() - 1) <= 1e-9);
      assert_true(std::abs(found.after.last - slope) <= 1e-9 * slope);
      assert_true(std::abs(found.energy(0) - node.energy) <= 1e-9);
      assert_true(found.before.length >= 0 && found.after.length >= 0);
      assert_true(found.before.first >= 0 && found.before.last >= found.before.first - 1e-9);
      assert_true(found.after.first >= found.before.last - 1e-9 && found.after.last >= found.after.first - 1e-9);
    }
}

// The slope jumps at a node from whose overclosure a kink is at most 1e-9 away, and nowhere else.
void a_kink_beside_a_node_is_at_it_within_1e_9_of_its_overclosure(void**) {
  for (const double share : {0.5, 2.0})
    for (const bool last : {false, true}) {
      rc_law_point node = RC_LAW_POINT_INIT, next = RC_LAW_POINT_INIT;
      node.x = node.p = node.slope = 1;
      next.x = 8;
      next.slope = 2;
      const double kink = last ? 8 - share * 8e-9 : 1 + share * 1e-9;
      next.p = kink + 2 * (next.x - kink);
      const auto found = with_tangents(node, next);
      assert_true(found.has_value());
      const LawPart &first = found->before.length > 0 ? found->before : found->after,
                    &second = found->after.length > 0 ? found->after : found->before;
      const double jump = last ? next.slope - second.last : first.first - node.slope;
      assert_true(share < 1 ? std::abs(jump - 1) < 1e-6 : std::abs(jump) < 1e-6);
    }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(the_first_interval_has_the_nodes_value_slope_and_energy),
                              cmocka_unit_test(a_kink_beside_a_node_is_at_it_within_1e_9_of_its_overclosure)};
  return cmocka_run_group_tests_name("unit.interval", tests, nullptr, nullptr);
}

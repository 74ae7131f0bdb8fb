// The survey of an answer against plain loops, and the points of trial sets below a limit.
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "contact/proof/survey.h"
#include "contact/surface/points_below.h"
#include "core/thread_team.h"
#include "support/cmocka.hpp"

namespace {

using namespace rc;

constexpr std::int64_t nx = 37, ny = 29;
constexpr double compression = 0.4, nan = std::numeric_limits<double>::quiet_NaN();

struct Scene {
  std::vector<double> gap;
  std::vector<float> gap_single;
  std::vector<std::uint8_t> mask;
  Deflected answer;
};

// Single: the gap in 4 bytes. Some: the answer is on some of the points.
Scene scene(bool masked, bool some) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<float> number(0, 1);
  Scene made;
  for (std::int64_t i = 0; i < nx * ny; ++i) {
    made.gap_single.push_back(number(generator));
    made.gap.push_back(made.gap_single.back());
    if (masked) made.mask.push_back(number(generator) < 0.8F);
    if (some && number(generator) < 0.5F) continue;
    if (some) made.answer.pressures.on.index.push_back(i);
    made.answer.pressures.p.push_back(number(generator) < 0.1F ? 1 : 0);
    made.answer.product.push_back(number(generator) < 0.01F ? nan : static_cast<double>(number(generator)) - 0.3);
  }
  made.answer.pressures.on.n = static_cast<std::int64_t>(made.answer.size());
  return made;
}

void survey_is_that_of_plain_loops(void**) {
  const ThreadTeam team(1);
  for (const bool masked : {false, true})
    for (const bool some : {false, true})
      for (const bool single : {false, true}) {
        const Scene given = scene(masked, some);
        const GapValues gap = single ? GapValues(std::span<const float>(given.gap_single)) : GapValues(given.gap);
        const StepSurface surface({nx, ny, gap, given.mask, false}, team);
        const Survey found = survey(surface, compression, given.answer);
        Survey plain;
        for (std::size_t k = 0; k < given.answer.size(); ++k) {
          const std::size_t i = given.answer.point(k);
          const double height = given.gap[i] - surface.lowest(), left = given.answer.product[k] - (compression - height);
          if (given.answer.p()[k] != 0 || !(left >= 0)) plain.touching.push_back(k);
          if (given.answer.product[k] == given.answer.product[k])
            plain.largest_product = std::max(plain.largest_product, std::abs(given.answer.product[k]));
          if (left == left && (given.mask.empty() || given.mask[i] != 0))
            plain.largest_gap = std::max(plain.largest_gap, std::abs(left));
        }
        assert_true(found.touching == plain.touching);
        assert_true(found.largest_product == plain.largest_product);
        assert_true(found.largest_gap == plain.largest_gap);
      }
}

void gaps_of_included_points_are_summed(void**) {
  const ThreadTeam team(1);
  for (const bool masked : {false, true}) {
    Scene given = scene(masked, false);
    for (double& product : given.answer.product)
      if (std::isnan(product)) product = 0.5;
    const StepSurface surface({nx, ny, given.gap, given.mask, false}, team);
    double plain = 0;
    for (std::size_t i = 0; i < given.gap.size(); ++i)
      if (!masked || given.mask[i] != 0) plain += given.answer.product[i] - (compression - (given.gap[i] - surface.lowest()));
    assert_true(std::abs(survey(surface, compression, given.answer).sum_of_gaps - plain) < 1e-13 * nx * ny);
  }
}

void points_below_a_limit_are_all_that_are(void**) {
  const ThreadTeam team(1);
  for (const bool masked : {false, true}) {
    const Scene given = scene(masked, false);
    const StepSurface surface({nx, ny, given.gap, given.mask, false}, team);
    for (const double limit : {0.01, 0.3, 0.9, 2.0}) {
      std::vector<std::int64_t> plain;
      for (std::size_t i = 0; i < given.gap.size(); ++i)
        if (given.gap[i] < limit && (!masked || given.mask[i] != 0)) plain.push_back(static_cast<std::int64_t>(i));
      const TrialSet found = points_below(limit, surface);
      assert_int_equal(found.n, static_cast<std::int64_t>(plain.size()));
      if (found.n < nx * ny) assert_true(found.index == plain);
    }
  }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(survey_is_that_of_plain_loops),
                              cmocka_unit_test(gaps_of_included_points_are_summed),
                              cmocka_unit_test(points_below_a_limit_are_all_that_are)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}

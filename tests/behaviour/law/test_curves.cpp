// Random laws, with a hardness and without: their curves rise without jumps, stay inside the bounds that they claim, and have an
// inverse; and the exact pressure is inside the bounds of every interval that is proven.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

#include "small_patches.h"

namespace {

using namespace laws;
using pairs::check;
using pairs::text;

constexpr double eps = std::numeric_limits<double>::epsilon();

struct Count {
  std::int64_t laws = 0, proven = 0, points = 0, exact = 0, jumps = 0, outside = 0, no_inverse = 0, falls = 0, exact_outside = 0,
               slope_jumps = 0, areas = 0, refused = 0;
  double farthest = 0, worst_exact = 0;
};

// Where the pieces of the curve begin, from the numbers that table.h describes.
std::vector<double> pieces_of(const rc_law* law) {
  const std::string path = (std::filesystem::temp_directory_path() / "curves-of-the-test.law-table").string();
  rc_law_export_spec spec = RC_LAW_EXPORT_SPEC_INIT;
  spec.format = RC_LAW_TABLE;
  pairs::check_equal(rc_law_export(law, path.c_str(), &spec), RC_OK, rc_last_error());
  std::ifstream file(path);
  std::vector<double> numbers, begins;
  for (std::string word; file >> word;) numbers.push_back(std::strtod(word.c_str(), nullptr));
  file.close();
  std::filesystem::remove(path);
  for (std::size_t i = 0; i < static_cast<std::size_t>(numbers[2]); ++i) begins.push_back(numbers[9 + 5 * i]);
  return begins;
}

struct Value {
  double p, slope;
};
Value value(const rc_law* law, double x) {
  Value at{};
  check(rc_law_pressure(law, x, &at.p, &at.slope, nullptr) >= 0, "rc_law_pressure");
  return at;
}

void judge_curve(const rc_law* law, std::mt19937& generator, Count& count) {
  const rc_law_info info = describe(law);
  const std::vector<double> pieces = pieces_of(law);
  std::vector<double> xs;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (const double x : {std::nextafter(pieces[i], 0), pieces[i], std::nextafter(pieces[i], HUGE_VAL)}) xs.push_back(x);
    if (i + 1 < pieces.size())
      for (int k = 0; k < 3; ++k)
        xs.push_back(pieces[i] + (pieces[i + 1] - pieces[i]) * static_cast<double>(generator()) / 4294967296.0);
  }
  std::erase_if(xs, [&](double x) { return !(x > 1e-300 && x <= info.x_upper); });
  std::sort(xs.begin(), xs.end());
  Value before{0, 0};
  double last = 0;
  for (const double x : xs) {
    const Value at = value(law, x);
    const double steepest = std::max(at.slope, before.slope);
    count.falls += at.p < before.p * (1 - eps);
    if (x == std::nextafter(last, HUGE_VAL)) count.jumps += at.p - before.p > 16 * eps * at.p + 4 * steepest * (x - last);
    before = at, last = x;
    ++count.points;

    const rc_law_point point = evaluate(law, x);
    const double excess = std::max(point.p_lower - at.p, at.p - point.p_upper);
    const bool told_apart = x >= info.x_lower || at.p > 1e-3 * info.p_lower;  // near 0 round-off of p_lower is not relative to p
    count.outside += told_apart && excess > 1e-13 * (at.p + info.p_lower);
    if (told_apart) count.farthest = std::max(count.farthest, excess / at.p);
    count.areas += !(point.area_lower <= point.area_upper);

    double back = 0;
    check(rc_law_overclosure(law, at.p, &back) >= 0, "rc_law_overclosure");
    const Value there = value(law, back);
    double least = std::min(at.slope, there.slope);
    for (const double begin : pieces)
      if (begin > std::min(x, back) && begin < std::max(x, back)) least = std::min(least, value(law, begin).slope);
    count.no_inverse += std::abs(there.p - at.p) > 16 * eps * at.p + 4 * eps * there.slope * back;
    if (least > 0) count.no_inverse += std::abs(back - x) > 16 * eps * (x + at.p / least);
  }
}

// Between proven intervals the slope jumps only on a kink of the exact curve, with x = approach.
void judge_slopes(const rc_law* law, ExactLaw& exact, Count& count) {
  for (std::int64_t i = 2; i + 1 < describe(law).nodes; ++i) {
    rc_law_point node = RC_LAW_POINT_INIT, previous = RC_LAW_POINT_INIT;
    rc_law_describe_node(law, i, &node), rc_law_describe_node(law, i - 1, &previous);
    if (node.bounds != RC_LAW_CONVEX || previous.bounds != RC_LAW_CONVEX) continue;
    const double left = value(law, std::nextafter(node.x, 0)).slope, right = value(law, node.x).slope;
    if (std::abs(right / left - 1) < 1e-6) continue;
    count.slope_jumps += !(exact.at(node.x * (1 + 1e-8)).slope > exact.at(node.x * (1 - 1e-8)).slope * (1 + 1e-9));
  }
}

void judge_exact(const rc_law* law, const SmallPatch& small, ExactLaw& exact, std::mt19937& generator, int checks, Count& count) {
  const rc_law_info info = describe(law);
  double most = info.x_upper;  // of the approach
  if (info.bulk == RC_LAW_BULK_GIVEN) most += info.p_upper * info.area / info.bulk_stiffness;
  for (int k = 0; k < checks; ++k) {
    const double share = (static_cast<double>(generator()) + 0.5) / 4294967296.0;
    const Exact at = exact.at(most * (k % 2 == 0 ? share : std::pow(info.x_lower / info.x_upper, share)));
    if (!(at.x > 0 && at.x <= info.x_upper)) continue;
    const rc_law_point point = evaluate(law, at.x);
    const double excess = std::max(point.p_lower / at.p, at.p / point.p_upper) - 1;
    ++count.exact;
    if (at.p > 0) count.worst_exact = std::max(count.worst_exact, excess);
    if (at.p > 0 && excess > small.slack) {
      ++count.exact_outside;
      pairs::report("outside by " + text(excess) + ", bounds " + std::to_string(info.bounds) + ", kernel " +
                    small.patch.problem.kernel);
    }
  }
}

void judge(SmallPatch small, std::mt19937& generator, int checks, Count& count) {
  if (small.patch.problem.system.op == RC_OPERATOR_DENSE) small.patch.problem.system.dense = small.matrix.data();
  const MadeLaw made = make(small.patch);
  if (made.status == RC_ERR_INFEASIBLE) {
    ++count.refused;
    return;
  }
  check(made.status >= 0, made.message);
  ++count.laws;
  count.proven += made.status == RC_OK;
  ExactLaw exact(small, describe(made.law.get()));
  judge_curve(made.law.get(), generator, count);
  if (describe(made.law.get()).bulk == RC_LAW_BULK_NONE) judge_slopes(made.law.get(), exact, count);
  judge_exact(made.law.get(), small, exact, generator, checks, count);
}

void conclude(const Count& count) {
  pairs::report(std::to_string(count.laws) + " laws, " + std::to_string(count.proven) + " proven, " +
                std::to_string(count.refused) + " refused, " + std::to_string(count.points) +
                " points of curves, farthest outside " + text(count.farthest) + ", " + std::to_string(count.exact) +
                " exact pressures, farthest outside " + text(count.worst_exact));
  const auto none = [](std::int64_t found, const char* what) { check(found == 0, std::to_string(found) + what); };
  none(count.jumps, " jumps of p");
  none(count.falls, " times p falls");
  none(count.outside, " times p is outside its bounds");
  none(count.no_inverse, " times the inverse is another overclosure");
  none(count.slope_jumps, " jumps of the slope without a kink");
  none(count.areas, " bounds of the area in the wrong order");
  none(count.exact_outside, " exact pressures outside the bounds");
}

void random_laws_hold(bool hard, int laws) {
  std::mt19937 generator(hard ? 31 : 32);
  Count count;
  for (int i = 0; i < laws; ++i) judge(small_patch(generator, hard), generator, 12, count);
  conclude(count);
}

void laws_of_two_asperities_hold() {
  std::mt19937 generator(33);
  Count count;
  for (int i = 0; i <= 40; ++i)
    for (const double tolerance : {0.1, 0.05, 0.02, 0.01, 0.003})
      judge(two_asperities(0.5 + 0.05 * i, tolerance), generator, 2, count);
  conclude(count);
}

}  // namespace

int main(int argc, char** argv) {
  const int hard = pairs::quick() ? 300 : 5500, elastic = pairs::quick() ? 100 : 2500;
  return pairs::run_group("law curves",
                          {{"with a hardness", [=] { random_laws_hold(true, hard); }},
                           {"without a hardness", [=] { random_laws_hold(false, elastic); }},
                           {"of two asperities", laws_of_two_asperities_hold}},
                          argc, argv);
}

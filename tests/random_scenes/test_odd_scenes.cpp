// Odd scenes: what "auto" chooses takes hardly more products than plain conjugate gradients wherever these are certified.
#include <algorithm>

#include "odd_scene.h"
#include "pairs/contact.h"
#include "pairs/harness.h"

namespace scenes {

namespace {

using pairs::check, pairs::Answer;

// Products of "auto" over those of polonsky-keer, and products by which small counts may differ: it solves the surface of one
// wave in full contact, a vector of which H takes a multiple, in two to eight.
constexpr double most_ratio = 1.5;
constexpr std::int64_t spare = 30;
constexpr double most_astray = 0.02;  // of the scenes may take more than that, near the mean plane of elongated periodic surfaces
constexpr double most_ever = 4;       // times as many

Answer answer_of(const OddScene& scene, const pairs::Pair& pair) {
  return pairs::solve(scene.problem, pair, {{RC_OPT_TOL, pairs::text(scene.tol)}, {RC_OPT_THREADS, "1"}, {RC_OPT_BOUNDS, "0"}});
}

void hardly_more_products_than_plain_iterations() {
  const std::uint64_t scenes = pairs::quick() ? 300 : 2000;
  std::int64_t certified = 0, astray = 0, ours = 0, plain = 0, most = 0;
  for (std::uint64_t number = 0; number < scenes; ++number) {
    const OddScene scene = odd_scene(1, number);
    const Answer found = answer_of(scene, pairs::automatic), by_plain = answer_of(scene, {"polonsky-keer", "fft"});
    if (by_plain.status != RC_OK) continue;
    const std::string name = "scene " + std::to_string(number) + ", " + scene.name;
    check(found.status == RC_OK, name + ": " + rc_status_name(found.status));
    // nnls counts a product for each point that it adds, of a few points.
    if (std::string(found.result.solver) == "nnls") continue;
    ++certified;
    const std::int64_t a = found.result.applications, b = by_plain.result.applications;
    ours += a;
    plain += b;
    most = std::max(most, a);
    const auto limit = [&](double ratio) { return ratio * static_cast<double>(b) + static_cast<double>(spare); };
    if (static_cast<double>(a) > limit(most_ratio)) {
      ++astray;
      pairs::report(name + ": " + std::to_string(a) + " products, polonsky-keer " + std::to_string(b));
    }
    check(static_cast<double>(a) <= limit(most_ever), name + ": " + std::to_string(a) + " products");
  }
  pairs::report(std::to_string(certified) + " scenes: products " + std::to_string(ours) + ", most " + std::to_string(most) +
                ", polonsky-keer " + std::to_string(plain));
  check(static_cast<double>(astray) <= most_astray * static_cast<double>(certified), "too many products in too many scenes");
}

}  // namespace

}  // namespace scenes

int main(int argc, char** argv) {
  return pairs::run_group("scenes_odd",
                          {{"hardly_more_products_than_plain_iterations", scenes::hardly_more_products_than_plain_iterations}},
                          argc, argv);
}

// Odd scenes: what "auto" chooses takes hardly more products than plain conjugate gradients wherever these are certified.
//   test_odd_scenes [--scenes A:B]      prints the products of each of these
#include <algorithm>
#include <cstdio>

#include "odd_scene.h"
#include "support/contact.h"
#include "support/harness.h"

namespace scenes {

namespace {

using pairs::check, pairs::Answer;

constexpr double most_ratio = 1.5;    // products of "auto" over those of polonsky-keer
constexpr double most_astray = 0.02;  // of the scenes may take more than that
constexpr double most_ever = 4.5;     // times as many
constexpr std::int64_t few = 40;      // products that need no comparison: a wave pressed flat takes plain iterations five
constexpr std::int64_t many = 600;    // products that hardly a scene takes

struct Slice {
  unsigned long first = 0, end = 2000;
  bool each = false;  // prints every scene
};

Answer answer_of(const OddScene& scene, const pairs::Pair& pair) {
  return pairs::solve(scene.problem, pair, {{RC_OPT_TOL, pairs::text(scene.tol)}, {RC_OPT_THREADS, "1"}, {RC_OPT_BOUNDS, "0"}});
}

void hardly_more_products_than_plain_iterations(const Slice& slice) {
  std::int64_t certified = 0, astray = 0, above = 0, ours = 0, plain = 0, most = 0;
  for (std::uint64_t number = slice.first; number < slice.end; ++number) {
    const OddScene scene = odd_scene(1, number);
    const Answer found = answer_of(scene, pairs::automatic), by_plain = answer_of(scene, {"polonsky-keer", "fft"});
    if (by_plain.status != RC_OK) continue;
    const std::string name = "scene " + std::to_string(number) + ", " + scene.name;
    check(found.status == RC_OK, name + ": " + rc_status_name(found.status));
    // nnls counts a product for each point that it adds, of a few points.
    if (std::string(found.result.solver) == "nnls") continue;
    ++certified;
    const std::int64_t a = found.result.products, b = by_plain.result.products;
    ours += a;
    plain += b;
    most = std::max(most, a);
    above += a > many ? 1 : 0;
    const bool beyond = a > few && static_cast<double>(a) > most_ratio * static_cast<double>(b);
    astray += beyond ? 1 : 0;
    if (beyond || slice.each) pairs::report(name + ": " + std::to_string(a) + " products, polonsky-keer " + std::to_string(b));
    check(a <= few || static_cast<double>(a) <= most_ever * static_cast<double>(b),
          name + ": " + std::to_string(a) + " products");
  }
  pairs::report(std::to_string(certified) + " scenes: products " + std::to_string(ours) + ", most " + std::to_string(most) +
                ", " + std::to_string(above) + " scenes above " + std::to_string(many) + "; polonsky-keer " +
                std::to_string(plain) + "; " + std::to_string(astray) + " scenes above " + pairs::text(most_ratio) +
                " times its products");
  check(static_cast<double>(astray) <= most_astray * static_cast<double>(certified), "too many products in too many scenes");
}

}  // namespace

}  // namespace scenes

int main(int argc, char** argv) {
  scenes::Slice slice;
  if (pairs::quick()) slice.end = 300;
  if (argc == 3 && std::string(argv[1]) == "--scenes") {
    if (std::sscanf(argv[2], "%lu:%lu", &slice.first, &slice.end) != 2) {
      std::fprintf(stderr, "usage: %s [--scenes A:B]\n", argv[0]);
      return 2;
    }
    slice.each = true;
    argc = 1;
  }
  return pairs::run_group(
      "scenes_odd",
      {{"hardly_more_products_than_plain_iterations", [&] { scenes::hardly_more_products_than_plain_iterations(slice); }}}, argc,
      argv);
}

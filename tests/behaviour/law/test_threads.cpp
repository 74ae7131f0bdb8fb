// Eight threads evaluate one law, and open it by name.
#include <array>
#include <cmath>
#include <filesystem>
#include <random>
#include <thread>

#include "patches.h"

namespace {

using namespace laws;
using pairs::check;

constexpr int crowd = 8;

double evaluated(const rc_law* law) {
  const rc_law_info info = describe(law);
  double sum = 0;
  for (int i = 0; i < 5000; ++i) {
    const double x = 2e-4 * i * info.x_upper;
    double p = 0, slope = 0, energy = 0, back = 0, conductance = 0;
    rc_law_pressure(law, x, &p, &slope, &energy);
    rc_law_overclosure(law, p, &back);
    rc_law_gap_conductance(law, p, 1, 1, &conductance);
    sum += p + slope + energy + back + conductance + evaluate(law, x).area_upper;
    if (i % 500 == 0) {
      const rc_law* same = nullptr;
      if (rc_law_open("of eight threads", nullptr, &same) != RC_OK || same != law) sum = NAN;
    }
  }
  return sum;
}

void eight_threads_evaluate_one_law() {
  const LawHandle law = made(usual_patch(24));
  const std::string path =
      (std::filesystem::temp_directory_path() / ("of-eight-threads-" + std::to_string(std::random_device()()) + ".law")).string();
  pairs::check_equal(rc_law_save(law.get(), path.c_str()), RC_OK, "save");
  std::array<double, crowd> sums{};
  std::vector<std::thread> threads;
  for (double& sum : sums)
    threads.emplace_back([&sum, &path] {
      const rc_law* opened = nullptr;
      if (rc_law_open("of eight threads", path.c_str(), &opened) == RC_OK) sum = evaluated(opened);
    });
  for (std::thread& thread : threads) thread.join();
  std::filesystem::remove(path);
  for (const double sum : sums) check(sum > 0 && sum == sums[0], "threads disagree");
}

}  // namespace

int main(int argc, char** argv) {
  return pairs::run_group("law threads", {{"eight threads evaluate one law", eight_threads_evaluate_one_law}}, argc, argv);
}

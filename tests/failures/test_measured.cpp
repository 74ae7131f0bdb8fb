// Certified cascade multi-resolution equals the whole problem on every measured surface of RC_MEASURED_DIR.
#include <algorithm>
#include <filesystem>

#include "failures/cascade.h"
#include "measured_surface.h"
#include "rough_surface.h"

namespace failures {

namespace {

constexpr double densest = 0.15;  // share of points in contact; deeper is slow and shows nothing more

std::vector<std::string> surface_files() {
  std::vector<std::string> files;
  for (const char* folder : {"measured", "measured-lgpl"}) {
    const std::filesystem::path path = std::filesystem::path(RC_MEASURED_DIR) / folder;
    if (!std::filesystem::is_directory(path)) continue;
    for (const auto& entry : std::filesystem::directory_iterator(path))
      if (const auto type = entry.path().extension(); type == ".gsf" || type == ".npy") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

Problem pressed(const std::string& file) {
  const bench::MeasuredSurface surface = bench::read_measured(file);
  Problem problem;
  problem.system.nx = surface.nx;
  problem.system.ny = surface.ny;
  problem.system.hx = surface.hx;
  problem.system.hy = surface.hy;
  problem.gap = bench::gap_below_highest(surface.heights);
  // Half of the highest point's height, less where most of the surface would touch.
  problem.target = bench::mean_of(problem.gap) / 2;
  for (int halvings = 0; halvings < 6; ++halvings) {
    const Answer loose = solve(problem, {"polonsky-keer", "fft"}, {{"tol", "1e-2"}});
    if (static_cast<double>(loose.result.contacts) <= densest * static_cast<double>(problem.points())) break;
    problem.target /= 2;
  }
  return problem;
}

void check_surface(const std::string& file) {
  const Problem problem = pressed(file);
  for (const char* filter : {"subsample", "max"}) {
    const Cascade cascade = check_cascade(problem, filter);
    report(std::to_string(cascade.full.result.contacts) + " of " + std::to_string(problem.points()) + " points in contact");
  }
}

// Grooves finer than the coarsest grid: the published method fails on them.
void grooves_defeat_the_published_method() {
  for (const std::string& file : surface_files())
    if (file.find("fv_skibase") != std::string::npos) {
      const Cascade cascade = check_cascade(pressed(file), "subsample");
      check_status(cascade.plain, RC_STOP_UNCERTIFIED, "as published");
      return;
    }
  throw Skipped("the surface is not at " RC_MEASURED_DIR);
}

}  // namespace

}  // namespace failures

int main(int argc, char** argv) {
  using namespace failures;
  std::vector<pairs::Test> tests;
  for (const std::string& file : surface_files())
    tests.push_back({std::filesystem::path(file).filename(), [=] { check_surface(file); }});
  tests.push_back({"grooves_defeat_the_published_method", grooves_defeat_the_published_method});
  return pairs::run_group("failures.measured", tests, argc, argv);
}

// Certified cascade multi-resolution equals the whole problem on every surface of a folder: test_failures_measured FOLDER.
#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "cascade.h"
#include "measured_surface.h"

namespace failures {

namespace {

constexpr double densest = 0.15;  // share of points in contact; deeper is slow and shows nothing more

// Without those that have missing points.
std::vector<std::string> surface_files(const std::string& folder) {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".gsf" && entry.path().stem() != "missing") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

// Less deep where most of the surface would touch.
Problem pressed(const std::string& file) {
  Problem problem = measured_problem(file);
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
void grooves_defeat_the_published_method(const std::string& file) {
  const Cascade cascade = check_cascade(pressed(file), "subsample");
  check_status(cascade.plain, RC_UNCERTIFIED, "as published");
}

bool has_grooves(const std::string& file) {
  const std::string name = std::filesystem::path(file).stem();
  return name == "fv_skibase_4mm" || name == "grooves";
}

}  // namespace

}  // namespace failures

int main(int argc, char** argv) {
  using namespace failures;
  if (argc < 2 || !std::filesystem::is_directory(argv[1])) {
    std::printf("skipped: no folder of surfaces\n");
    return 77;
  }
  std::vector<pairs::Test> tests;
  for (const std::string& file : surface_files(argv[1])) {
    tests.push_back({std::filesystem::path(file).filename(), [=] { check_surface(file); }});
    if (has_grooves(file))
      tests.push_back({"grooves_defeat_the_published_method", [=] { grooves_defeat_the_published_method(file); }});
  }
  return pairs::run_group("failures.measured", tests, argc - 1, argv + 1);
}

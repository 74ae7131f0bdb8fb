// The memory that the dense backend takes at 20000 points, and its refusal of sizes beyond the limit. Through the C interface;
// each solve is a process of its own, whose peak the kernel counts.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "support/cmocka.hpp"
#include "support/contact.h"
#include "support/surfaces.h"

namespace {

// What backends/dense/README.md states: n^2/2 numbers and this much, where that is more than 512 MiB.
constexpr double beside_a_triangle = 64.0 * 1048576.0;
constexpr double library_and_arrays = 32.0 * 1048576.0;  // of the process without a matrix, vectors of the solver among them

struct Outcome {
  rc_status status;
  std::int64_t contacts, candidates;
};

// A paraboloid up to a plateau: all points are candidates, and few of the plateau's touch.
Outcome solve(const char* solver, std::int64_t nx, std::int64_t ny) {
  constexpr double radius = 1000;
  pairs::Problem problem;
  problem.system.nx = nx;
  problem.system.ny = ny;
  problem.gap = pairs::paraboloid(nx, ny, 1, 0.5 * static_cast<double>(nx), 0.5 * static_cast<double>(ny), radius);
  problem.target = std::pow(0.46 * static_cast<double>(ny), 2) / radius;
  for (double& gap : problem.gap) gap = std::min(gap, 0.99 * problem.target);
  const rc_step step = problem.step();
  rc_result result = RC_RESULT_INIT;
  const rc_status status =
      rc_solve(&problem.system, &step, pairs::make_options({solver, "dense"}, "auto", {{RC_OPT_TOL, "1e-8"}}).get(), &result);
  return {status, result.contacts, result.candidates};
}

// The peak of a child that runs action(outcome) [bytes].
template <class Action> double peak_of(Outcome& outcome, const Action& action) {
  int channel[2];
  assert_int_equal(pipe(channel), 0);
  std::fflush(nullptr);
  const pid_t child = fork();
  assert_true(child >= 0);
  if (child == 0) {
    const Outcome made = action();
    _exit(write(channel[1], &made, sizeof made) == sizeof made ? 0 : 1);
  }
  assert_int_equal(read(channel[0], &outcome, sizeof outcome), sizeof outcome);
  int status = 0;
  rusage usage{};
  assert_int_equal(wait4(child, &status, 0, &usage), child);
  assert_int_equal(status, 0);
  close(channel[0]);
  close(channel[1]);
  return static_cast<double>(usage.ru_maxrss) * 1024.0;
}

void a_full_run_takes_one_triangle(const char* solver) {
  const bool quick = std::getenv("RC_TEST_QUICK") != nullptr;
  const std::int64_t nx = quick ? 60 : 200, ny = quick ? 50 : 100;
  const auto n = static_cast<double>(nx * ny);
  Outcome outcome{};
  const double peak = peak_of(outcome, [&] { return solve(solver, nx, ny); });
  const double triangle = 8.0 * n * n / 2.0;
  const double allowed = std::max(triangle + beside_a_triangle, 512.0 * 1048576.0) + library_and_arrays;
  print_message(
      "%s: n = %.0f, %lld candidates, %lld contacts (%.0f %%), status %d, peak %.0f MB of n^2/2 = %.0f MB, allowed %.0f MB\n",
      solver, n, static_cast<long long>(outcome.candidates), static_cast<long long>(outcome.contacts),
      100.0 * static_cast<double>(outcome.contacts) / n, static_cast<int>(outcome.status), peak / 1e6, triangle / 1e6,
      allowed / 1e6);
  assert_int_equal(outcome.status, RC_OK);
  assert_true(static_cast<double>(outcome.contacts) > 0.2 * n);
  assert_true(peak <= allowed);
}

void nnls_takes_one_triangle(void**) { a_full_run_takes_one_triangle("nnls"); }
void polonsky_keer_takes_one_triangle(void**) { a_full_run_takes_one_triangle("polonsky-keer"); }

void what_cannot_fit_is_refused_before_it_is_allocated(void**) {
  for (const char* solver : {"nnls", "polonsky-keer"}) {
    Outcome outcome{};
    const double peak = peak_of(outcome, [&] {
      const Outcome made = solve(solver, 500, 400);
      const std::string message = rc_last_error();
      print_message("%s\n", message.c_str());
      const bool said = message.find("dense: the matrix of 200000 unknowns needs 160") != std::string::npos &&
                        message.find("\"fft\"") != std::string::npos;
      return Outcome{said ? made.status : RC_OK, made.contacts, made.candidates};
    });
    assert_int_equal(outcome.status, RC_ERR_MEMORY);
    assert_true(peak <= 2.0 * library_and_arrays);
  }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(what_cannot_fit_is_refused_before_it_is_allocated),
      cmocka_unit_test(polonsky_keer_takes_one_triangle),
      cmocka_unit_test(nnls_takes_one_triangle),
  };
  return cmocka_run_group_tests_name("dense_footprint", tests, nullptr, nullptr);
}

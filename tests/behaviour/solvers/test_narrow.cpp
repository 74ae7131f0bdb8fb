// Surfaces of few columns: pressures and memory are the same when x and y are exchanged.
#include <algorithm>
#include <cstdlib>
#include <new>
#include <utility>

#include "support/contact.h"
#include "support/registry.h"
#include "support/surfaces.h"

namespace {

std::size_t most_asked = 0;  // largest request for memory with an alignment

}  // namespace

// Sanitizers have their own.
#if !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define RC_COUNTS_MEMORY
void* operator new(std::size_t size, std::align_val_t align, const std::nothrow_t&) noexcept {
  most_asked = std::max(most_asked, size);
  const auto unit = static_cast<std::size_t>(align);
  return std::aligned_alloc(unit, (size + unit - 1) / unit * unit);
}
void operator delete(void* p, std::align_val_t) noexcept { std::free(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { std::free(p); }
void operator delete(void* p, std::align_val_t, const std::nothrow_t&) noexcept { std::free(p); }
#endif

namespace pairs {

namespace {

Problem rugged(std::int64_t nx, std::int64_t ny, double hy, std::int32_t boundary, double depth) {
  Problem problem = rough_problem(nx, ny, boundary, 1, hy);
  const double mean = sum(problem.gap) / static_cast<double>(problem.points()), lowest = problem.lowest_gap();
  problem.target = lowest + depth * (mean - lowest);
  return problem;
}

// 3 x 400, with a mask, seen as 400 x 3: the same pressures.
void a_narrow_surface_may_be_turned() {
  for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC})
    for (const std::int64_t width : {1, 3}) {
      Problem lying = rugged(400, width, 0.7, boundary, 0.8), standing = lying;
      std::swap(standing.system.nx, standing.system.ny);
      std::swap(standing.system.hx, standing.system.hy);
      lying.mask.assign(lying.points(), 1);
      lying.mask[17] = 0;
      standing.mask = lying.mask;
      const auto turned = [&](std::int64_t x, std::int64_t y) { return static_cast<std::size_t>(x * width + y); };
      const auto given = [](std::int64_t x, std::int64_t y) { return static_cast<std::size_t>(y * 400 + x); };
      for (std::int64_t y = 0; y < width; ++y)
        for (std::int64_t x = 0; x < 400; ++x) {
          standing.gap[turned(x, y)] = lying.gap[given(x, y)];
          standing.mask[turned(x, y)] = lying.mask[given(x, y)];
        }
      for (const std::int32_t control : controls) {
        if (control == RC_CONTROL_LOAD) {
          const double load = solved(lying, {"haar-cg", "fft"}).result.load;
          lying = at_load(lying, load);
          standing = at_load(standing, load);
        }
        const Answer one = solved(lying, {"haar-cg", "fft"}), other = solved(standing, {"haar-cg", "fft"});
        Field p(one.p.size()), gap(one.p.size());
        for (std::int64_t y = 0; y < width; ++y)
          for (std::int64_t x = 0; x < 400; ++x) {
            p[given(x, y)] = other.p[turned(x, y)];
            gap[given(x, y)] = other.gap[turned(x, y)];
          }
        check_near(p, one.p, 1e-9, "pressures");
        check_near(gap, one.gap, 1e-9, "gaps");
      }
    }
}

// Each row of a transform begins at a block of columns, most of which are empty where there are few.
void a_narrow_surface_takes_no_more_memory() {
  for (const std::int64_t width : {1, 2}) {
    std::size_t bytes[2];
    for (const int standing : {0, 1}) {
      const Problem problem = rugged(standing ? width : 5000, standing ? 5000 : width, 1, RC_BOUNDARY_FREE, 0.8);
      most_asked = 0;
      solved(problem, {"haar-cg", "fft"}, {{RC_OPT_TOL, "1e-8"}});
      bytes[standing] = most_asked;
    }
    report("largest array " + std::to_string(bytes[0]) + " bytes lying, " + std::to_string(bytes[1]) + " standing");
#ifdef RC_COUNTS_MEMORY
    check(bytes[0] > 0, "no array was seen");
#endif
    check(bytes[1] <= bytes[0] + bytes[0] / 4, "standing it takes more");
  }
}

}  // namespace

}  // namespace pairs

int main(int argc, char** argv) {
  using namespace pairs;
  return run_group("solvers.narrow",
                   {{"a_narrow_surface_may_be_turned", a_narrow_surface_may_be_turned},
                    {"a_narrow_surface_takes_no_more_memory", a_narrow_surface_takes_no_more_memory}},
                   argc, argv);
}

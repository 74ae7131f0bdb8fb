// Surfaces of few columns take no more memory than those of few rows. Their answers: tests/scenes.
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

// Each row of a transform begins at a block of columns, most of which are empty where there are few.
void a_narrow_surface_takes_no_more_memory() {
  for (const std::int64_t width : {1, 2}) {
    std::size_t bytes[2];
    for (const int standing : {0, 1}) {
      const Problem problem = rugged_problem(standing ? width : 5000, standing ? 5000 : width, 0.8);
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
  return run_group("solvers.narrow", {{"a_narrow_surface_takes_no_more_memory", a_narrow_surface_takes_no_more_memory}}, argc,
                   argv);
}

// The host program's floating-point mode changes no answer and stays as it was: traps, rounding, flush to zero.
#include <cfenv>
#ifdef __x86_64__
#include <xmmintrin.h>
#endif

#include "invariance_tests.h"
#include "registry.h"
#include "surfaces.h"

namespace pairs {

namespace {

// A mode that a host may have. Sets it for the calling thread.
struct Mode {
  const char* name;
  void (*set)();
};

const Mode modes[] = {
#ifdef __GLIBC__
    {"traps", [] { feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW); }},
#endif
    {"upward", [] { std::fesetround(FE_UPWARD); }},
#ifdef __x86_64__
    {"flush to zero", [] { _mm_setcsr(_mm_getcsr() | 0x8040); }},
#endif
};

// All that a thread's mode consists of.
struct Found {
  int rounding = std::fegetround(), raised = std::fetestexcept(FE_ALL_EXCEPT), trapped = 0;
  unsigned vectors = 0;

  Found() {
#ifdef __GLIBC__
    trapped = fegetexcept();
#endif
#ifdef __x86_64__
    vectors = _mm_getcsr();
#endif
  }
  bool operator==(const Found&) const = default;
};

// Until its end the thread has the mode.
class InMode {
 public:
  explicit InMode(const Mode& mode) {
    std::fegetenv(&before_);
    std::feclearexcept(FE_ALL_EXCEPT);
    mode.set();
  }
  ~InMode() { std::fesetenv(&before_); }
  InMode(const InMode&) = delete;
  InMode& operator=(const InMode&) = delete;

 private:
  std::fenv_t before_;
};

void check_same_in(const Mode& mode, const Problem& problem, const Pair& pair, const Settings& settings, const Answer& wanted) {
  Answer found;
  bool kept = false;
  {
    const InMode in_mode(mode);
    const Found given;
    found = solve(problem, pair, settings);
    kept = Found() == given;
  }
  check(kept, std::string("the call leaves another mode than ") + mode.name);
  check_status(found, RC_OK, mode.name);
  check_same(found.p, wanted.p, mode.name);
  check_same(found.gap, wanted.gap, mode.name);
  const rc_result &a = found.result, &b = wanted.result;
  check_same({a.load, a.approach, a.energy, a.stiffness, a.load_upper}, {b.load, b.approach, b.energy, b.stiffness, b.load_upper},
             mode.name);
}

void host_modes_change_nothing(std::int32_t boundary, const Pair& pair) {
  std::vector<Problem> problems = {rough_problem(24, 18, boundary, 0.5, 0.75)};
  problems[0].target *= 1.4;
  problems.push_back(at_load(problems[0], solved(problems[0], pair).result.load));
  for (const char* threads : {"1", "2"})
    for (const Problem& problem : problems) {
      const Settings settings = {{RC_OPT_THREADS, threads}, {RC_OPT_STIFFNESS, "1"}};
      const Answer wanted = solved(problem, pair, settings);
      for (const Mode& mode : modes) check_same_in(mode, problem, pair, settings, wanted);
    }
}

}  // namespace

std::vector<Test> arithmetic_tests() {
  std::vector<Test> tests;
  for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC})
    add_for_pairs(tests, "the_hosts_floating_point_mode_changes_nothing", boundary,
                  [=](const Pair& pair) { host_modes_change_nothing(boundary, pair); });
  return tests;
}

}  // namespace pairs

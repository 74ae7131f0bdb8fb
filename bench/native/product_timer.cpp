// Times y = H[T,T] x through the public plugin interface: a solver that multiplies instead of solving.
#include <roughcontact/plugin.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "guarded.h"
#include "padded_product.h"
#include "stopwatch.h"

namespace bench {

namespace {

struct ProductSetup {
  const char* backend = "auto";
  const char* planning = "";  // of backend fft; empty: its default
  int threads = 1;
  double budget = 0.3;  // seconds to spend, three products at least
  bool single = false;  // precision
  double share = 1;     // of the trial set that carries pressure, the deepest points
};

struct ProductTimes {
  CallTimes calls;
  double first = 0;  // seconds of the first product, with the set-up
  std::int64_t points = 0, contacts = 0;
  std::vector<double> y;  // the last product
};

template <class Handle, void (*destroy)(Handle*), class Create> auto made(const Create& create) {
  Handle* handle = nullptr;
  check(create(&handle));
  return std::unique_ptr<Handle, decltype([](Handle* each) { destroy(each); })>(handle);
}

// rc_solver::solve has no user pointer.
thread_local ProductSetup setup;
thread_local ProductTimes found;

rc_status multiply(const rc_host*, const rc_problem* problem, const rc_options*, double*, double*) {
  const auto n = static_cast<std::size_t>(problem->n);
  if (setup.single && !problem->apply_float) return RC_ERR_INCOMPATIBLE;
  std::vector<double> x(problem->u, problem->u + n);
  if (setup.share < 1) {
    std::vector<double> sorted = x;
    const auto level = sorted.begin() + static_cast<std::ptrdiff_t>(static_cast<double>(n) * (1 - setup.share));
    std::nth_element(sorted.begin(), level, sorted.end());
    for (double& value : x) value = std::max(0.0, value - *level);
  }
  found.points = problem->n;
  found.contacts = problem->n - std::count(x.begin(), x.end(), 0.0);
  found.y.resize(n);
  rc_status status = RC_OK;
  const auto start = Clock::now();
  const auto timed = [&](const auto& product) {
    const auto call = [&] {
      if (status == RC_OK) status = product();
    };
    call();
    found.first = seconds_since(start);
    found.calls = time_calls(setup.budget, call);
  };
  if (setup.single) {
    const std::vector<float> single(x.begin(), x.end());
    std::vector<float> y(n);
    timed([&] { return problem->apply_float(problem, single.data(), y.data()); });
    std::copy(y.begin(), y.end(), found.y.begin());
  } else {
    timed([&] { return problem->apply(problem, x.data(), found.y.data()); });
  }
  return status == RC_OK ? RC_STOP_CANCELLED : status;
}

const rc_solver timer = {
    sizeof(rc_solver), "product-timer", "times products, solves nothing", "BSD-3-Clause", 0, RC_CONTROL_DISPLACEMENT, 0, 0,
    nullptr,           multiply};
const rc_solver* const solvers[] = {&timer};
const rc_plugin plugin = {
    sizeof(rc_plugin), RC_PLUGIN_ABI_MAJOR, RC_PLUGIN_ABI_MINOR, "product-timer", "1", 0, 1, nullptr, solvers};

// T is the trial set of this gap and approach. x is the compenetration over T, and with a share below 1 its excess over what the
// other points have.
ProductTimes time_products(const rc_system& system, const double* gap, double approach, const ProductSetup& wanted) {
  const auto context = made<rc_context, rc_context_destroy>([](auto** out) { return rc_context_create(nullptr, out); });
  check(rc_context_register(context.get(), &plugin));
  const auto options = made<rc_options, rc_options_destroy>([&](auto** out) { return rc_options_create(context.get(), out); });
  check(rc_options_parse(options.get(), RC_OPT_SOLVER, timer.name));
  check(rc_options_parse(options.get(), RC_OPT_BACKEND, wanted.backend));
  check(rc_options_set_int(options.get(), RC_OPT_THREADS, wanted.threads));
  const std::string planning = wanted.planning;
  if (planning == "measure") check(rc_options_set_int(options.get(), RC_OPT_DETERMINISTIC, 0));
  if (!planning.empty()) check(rc_options_parse(options.get(), "fft.planning", planning.c_str()));
  const auto contact =
      made<rc_contact, rc_contact_destroy>([&](auto** out) { return rc_contact_create(&system, options.get(), out); });
  rc_step step = RC_STEP_INIT;
  step.control = RC_CONTROL_DISPLACEMENT;
  step.undeformed_gap = gap;
  step.target = approach;
  rc_result result = RC_RESULT_INIT;
  setup = wanted;
  found = {};
  check(rc_contact_solve(contact.get(), &step, &result));
  return std::move(found);
}

}  // namespace

}  // namespace bench

extern "C" {

// times: best, median and first; counts: products, points of the trial set, points with pressure; y: [points], or null
const char* bench_time_products(const rc_system* system, const double* gap, double approach, const char* backend,
                                const char* planning, int threads, double budget, int single, double share, double* times,
                                std::int64_t* counts, double* y) {
  return bench::guarded([&] {
    const bench::ProductTimes found =
        bench::time_products(*system, gap, approach, {backend, planning, threads, budget, single != 0, share});
    const double seconds[] = {found.calls.best, found.calls.median, found.first};
    const std::int64_t numbers[] = {found.calls.count, found.points, found.contacts};
    std::copy_n(seconds, 3, times);
    std::copy_n(numbers, 3, counts);
    if (y) std::copy(found.y.begin(), found.y.end(), y);
  });
}

}  // extern "C"

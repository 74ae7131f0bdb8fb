// Times y = H[T,T] x through the public plugin interface: a solver that multiplies instead of solving.
#include <roughcontact/plugin.h>

#include "padded_product.h"

namespace {

using namespace bench;

template <class Handle, void (*destroy)(Handle*), class Create> auto made(const Create& create) {
  Handle* handle = nullptr;
  check(create(&handle));
  return std::unique_ptr<Handle, decltype([](Handle* each) { destroy(each); })>(handle);
}

// What is asked of the timer and what it found; rc_solver::solve has no user pointer.
thread_local struct {
  double budget;  // seconds to spend, three products at least
  bool single;    // precision
  double share;   // of the trial set that carries pressure, the deepest points
  CallTimes calls;
  double first;  // seconds of the first product, with the set-up
  std::int64_t points, contacts;
  std::vector<double> y;  // the last product
} timed;

rc_status multiply(const rc_host*, const rc_problem* problem, const rc_options*, double*, double*) {
  const auto n = static_cast<std::size_t>(problem->n);
  if (timed.single && !problem->apply_float) return RC_ERR_INCOMPATIBLE;
  std::vector<double> x(problem->u, problem->u + n);
  if (timed.share < 1) {
    std::vector<double> sorted = x;
    const auto level = sorted.begin() + static_cast<std::ptrdiff_t>(static_cast<double>(n) * (1 - timed.share));
    std::nth_element(sorted.begin(), level, sorted.end());
    for (double& value : x) value = std::max(0.0, value - *level);
  }
  timed.points = problem->n;
  timed.contacts = problem->n - std::count(x.begin(), x.end(), 0.0);
  const std::vector<float> given(x.begin(), x.end());
  std::vector<float> product(n);
  timed.y.resize(n);
  rc_status status = RC_OK;
  const auto call = [&] {
    if (status == RC_OK)
      status = timed.single ? problem->apply_float(problem, given.data(), product.data())
                            : problem->apply(problem, x.data(), timed.y.data());
  };
  const auto start = Clock::now();
  call();
  timed.first = seconds_since(start);
  timed.calls = time_calls(timed.budget, call);
  if (timed.single) timed.y.assign(product.begin(), product.end());
  return status == RC_OK ? RC_STOP_CANCELLED : status;
}

const rc_solver timer = {
    sizeof(rc_solver), "product-timer", "times products, solves nothing", "BSD-3-Clause", 0, RC_CONTROL_APPROACH, 0, 0,
    nullptr,           multiply};
const rc_solver* const solvers[] = {&timer};
const rc_plugin plugin = {
    sizeof(rc_plugin), RC_PLUGIN_ABI_MAJOR, RC_PLUGIN_ABI_MINOR, "product-timer", "1", 0, 1, nullptr, solvers};

}  // namespace

extern "C" {

// T is the trial set of this gap and approach. x is the compenetration over T, and with a share below 1 its excess over what the
// other points have. times: best, median and first; counts: products, points of the
// trial set, points with pressure; y: [points], or null.
const char* bench_time_products(const rc_system* system, const double* gap, double approach, const char* backend,
                                std::int64_t threads, double budget, std::int64_t single, double share, double* times,
                                std::int64_t* counts, double* y) {
  return guarded([&] {
    const auto context = made<rc_context, rc_context_destroy>([](auto** out) { return rc_context_create(nullptr, out); });
    check(rc_context_register(context.get(), &plugin));
    const auto options = made<rc_options, rc_options_destroy>([&](auto** out) { return rc_options_create(context.get(), out); });
    check(rc_options_parse(options.get(), RC_OPT_SOLVER, timer.name));
    check(rc_options_parse(options.get(), RC_OPT_BACKEND, backend));
    check(rc_options_set_int(options.get(), RC_OPT_THREADS, threads));
    const auto contact =
        made<rc_contact, rc_contact_destroy>([&](auto** out) { return rc_contact_create(system, options.get(), out); });
    rc_step step = RC_STEP_INIT;
    step.control = RC_CONTROL_APPROACH;
    step.undeformed_gap = gap;
    step.target = approach;
    rc_result result = RC_RESULT_INIT;
    timed = {budget, single != 0, share, {}, 0, 0, 0, {}};
    check(rc_contact_solve(contact.get(), &step, &result));
    const double seconds[] = {timed.calls.best, timed.calls.median, timed.first};
    const std::int64_t numbers[] = {timed.calls.count, timed.points, timed.contacts};
    std::copy_n(seconds, 3, times);
    std::copy_n(numbers, 3, counts);
    if (y) std::copy(timed.y.begin(), timed.y.end(), y);
    timed.y = {};
  });
}

}  // extern "C"

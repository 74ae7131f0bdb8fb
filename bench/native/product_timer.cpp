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

// Request and answer of the timer; rc_solver::solve has no user pointer.
thread_local struct {
  double budget;          // seconds to spend, three products at least
  bool single;            // precision
  double best;            // seconds of the fastest
  std::vector<double> y;  // the last product
} timed;

rc_status multiply(const rc_host*, const rc_problem* problem, const rc_options*, double*, double*) {
  const auto n = static_cast<std::size_t>(problem->n);
  if (timed.single && !problem->apply_float) return RC_ERR_INCOMPATIBLE;
  const std::vector<double> x(problem->u, problem->u + n);
  const std::vector<float> given(x.begin(), x.end());
  std::vector<float> product(n);
  timed.y.resize(n);
  rc_status status = RC_OK;
  const auto call = [&] {
    if (status == RC_OK)
      status = timed.single ? problem->apply_float(problem, given.data(), product.data())
                            : problem->apply(problem, x.data(), timed.y.data());
  };
  timed.best = best_time(timed.budget, call);
  if (timed.single) timed.y.assign(product.begin(), product.end());
  return status == RC_OK ? RC_STOP_CANCELLED : status;
}

const rc_solver timer = {
    sizeof(rc_solver), "product-timer", "times products, solves nothing", "BSD-3-Clause", 0, RC_CONTROL_APPROACH, 0, 0,
    nullptr,           multiply};
const rc_solver* const solvers[] = {&timer};
const rc_plugin plugin = {
    sizeof(rc_plugin), RC_PLUGIN_ABI_MAJOR, RC_PLUGIN_ABI_MINOR, "product-timer", "1", 0, 1, 0, nullptr, solvers, nullptr};

}  // namespace

extern "C" {

// T is the trial set of this gap and approach, x the penetration over T. y: [points of T], or null.
const char* bench_time_products(const rc_system* system, const double* gap, double approach, const char* backend,
                                std::int64_t threads, double budget, std::int64_t single, double* y, double* seconds) {
  return guarded([&] {
    const auto context =
        made<rc_context, rc_context_destroy>([](auto** out) { return rc_context_create(0, nullptr, nullptr, nullptr, out); });
    check(rc_context_register(context.get(), &plugin));
    const auto options = made<rc_options, rc_options_destroy>([&](auto** out) { return rc_options_create(context.get(), out); });
    check(rc_options_set_text(options.get(), RC_OPT_SOLVER, timer.name));
    check(rc_options_set_text(options.get(), RC_OPT_BACKEND, backend));
    check(rc_options_set_number(options.get(), RC_OPT_THREADS, threads));
    const auto contact =
        made<rc_contact, rc_contact_destroy>([&](auto** out) { return rc_contact_create(system, options.get(), out); });
    rc_step step = RC_STEP_INIT;
    step.control = RC_CONTROL_APPROACH;
    step.undeformed_gap.data = gap;
    step.target = approach;
    rc_result result = RC_RESULT_INIT;
    timed = {budget, single != 0, 0, {}};
    check(rc_contact_solve(contact.get(), &step, &result));
    *seconds = timed.best;
    if (y) std::copy(timed.y.begin(), timed.y.end(), y);
    timed.y = {};
  });
}

}  // extern "C"

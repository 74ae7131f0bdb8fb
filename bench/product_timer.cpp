#include "product_timer.h"

#include <algorithm>

namespace bench {

namespace {

// rc_solver::solve has no user pointer.
struct Request {
  double budget = 0;
  bool single = false;
  CallTimes times;
  std::vector<double> y;
};
thread_local Request request;

rc_status multiply(const rc_host*, const rc_problem* problem, const rc_options*, double*, double*) {
  request.y.resize(static_cast<std::size_t>(problem->n));
  rc_status status = RC_OK;
  if (request.single && !problem->apply_float) return RC_ERR_INCOMPATIBLE;
  const std::vector<float> u(problem->u, problem->u + problem->n);
  std::vector<float> y(u.size());
  request.times = time_calls(request.budget, [&] {
    if (status != RC_OK) return;
    status = request.single ? problem->apply_float(problem, u.data(), y.data())
                            : problem->apply(problem, problem->u, request.y.data());
  });
  if (request.single) std::copy(y.begin(), y.end(), request.y.begin());
  return status == RC_OK ? RC_STOP_CANCELLED : status;
}

const rc_solver timer = {
    sizeof(rc_solver), "product-timer", "times products, solves nothing", "BSD-3-Clause", 0, RC_CONTROL_DISPLACEMENT, 0, 0,
    nullptr,           multiply};
const rc_solver* const solvers[] = {&timer};
const rc_plugin plugin = {
    sizeof(rc_plugin), RC_PLUGIN_ABI_MAJOR, RC_PLUGIN_ABI_MINOR, "product-timer", "1", 0, 1, nullptr, solvers};

}  // namespace

CallTimes time_products(const rc_system& system, const rc_step& step, const ProductSetup& setup, std::vector<double>* y) {
  Context context;
  context.add(plugin);
  Options options(context.get());
  options.set(RC_OPT_SOLVER, timer.name).set(RC_OPT_BACKEND, setup.backend);
  options.set(RC_OPT_THREADS, static_cast<double>(setup.threads));
  if (setup.planning == "measure") options.set(RC_OPT_DETERMINISTIC, 0.0);
  if (!setup.planning.empty()) options.set("fft.planning", setup.planning);
  request = {};
  request.budget = setup.budget;
  request.single = setup.single;
  Contact(system, options).solve(step);
  if (y) *y = std::move(request.y);
  return request.times;
}

}  // namespace bench

#include "product_timer.h"

#include <algorithm>

namespace bench {

namespace {

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

}  // namespace

ProductTimes time_products(const rc_system& system, const double* gap, double approach, const ProductSetup& wanted) {
  rc_context* new_context = nullptr;
  check(rc_context_create(nullptr, &new_context));
  const Context context(new_context);
  check(rc_context_register(context.get(), &plugin));
  rc_options* new_options = nullptr;
  check(rc_options_create(context.get(), &new_options));
  const Options options(new_options);
  check(rc_options_parse(options.get(), RC_OPT_SOLVER, timer.name));
  check(rc_options_parse(options.get(), RC_OPT_BACKEND, wanted.backend));
  check(rc_options_set_int(options.get(), RC_OPT_THREADS, wanted.threads));
  const std::string planning = wanted.planning;
  if (planning == "measure") check(rc_options_set_int(options.get(), RC_OPT_DETERMINISTIC, 0));
  if (!planning.empty()) check(rc_options_parse(options.get(), "fft.planning", planning.c_str()));
  rc_contact* new_contact = nullptr;
  check(rc_contact_create(&system, options.get(), &new_contact));
  const Contact contact(new_contact);
  rc_step step = RC_STEP_INIT;
  step.gap = gap;
  step.target = approach;
  rc_result result;
  rc_result_init(&result);
  setup = wanted;
  found = {};
  check(rc_contact_solve(contact.get(), &step, &result));
  return std::move(found);
}

}  // namespace bench

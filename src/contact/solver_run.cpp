#include "contact/solver_run.h"

#include <new>

#include "core/error.h"

namespace rc {

namespace {

struct BoundProblem : rc_problem {
  Operator* op;
  Monitor* monitor;
};

const BoundProblem& bound(const rc_problem* problem) { return *static_cast<const BoundProblem*>(problem); }

rc_status apply(const rc_problem* problem, const double* x, double* y) { return bound(problem).op->apply(x, y); }

rc_status subset(const rc_problem* problem, std::int64_t na, const std::int64_t* a, const double* b, double* x) {
  // The solver may be C: no exception passes through it.
  try {
    return bound(problem).op->subset({a, static_cast<std::size_t>(na)}, b, x);
  } catch (const std::bad_alloc&) {
    set_message("out of memory for a system on a subset");
    return RC_ERR_MEMORY;
  }
}

rc_status poll(const rc_problem* problem, std::int64_t iteration, double kkt) {
  return bound(problem).monitor->poll(iteration, kkt, bound(problem).op->applications());
}

}  // namespace

rc_status SolverRun::operator()(std::int32_t control, std::span<const double> u, double load, double tol, std::vector<double>& p,
                                double& d) const {
  BoundProblem problem{};
  problem.struct_size = sizeof(rc_problem);
  problem.n = static_cast<std::int64_t>(u.size());
  problem.control = control;
  problem.u = u.data();
  problem.load = load;
  problem.tol = tol;
  problem.apply = apply;
  problem.subset = fallbacks || op.has_subset() ? subset : nullptr;
  problem.poll = poll;
  problem.op = &op;
  problem.monitor = &monitor;
  struct Watch {
    Operator& watched;
    ~Watch() { watched.watch(nullptr); }
  } watch{op};
  op.watch([this] { return monitor.ask(); });
  monitor.next_call();
  clear_message();
  const rc_status status = solver.solve(&context.host(), &problem, &options, p.data(), &d);
  raise_if_failed(status, solver.name);
  return status;
}

}  // namespace rc

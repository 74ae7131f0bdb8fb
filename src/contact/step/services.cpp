#include "contact/step/services.h"

#include <algorithm>
#include <limits>
#include <new>

#include "contact/choice.h"
#include "contact/operators.h"
#include "core/caught.h"

namespace rc {

// rc_kept_steps and rc_problem, and the state that their callbacks need.
struct BoundSteps : rc_kept_steps {
  KeptSteps* all;
  const rc_solver* by;
};

struct BoundProblem : rc_problem {
  explicit BoundProblem(SolverRun& solver_run) : rc_problem{}, run(solver_run) {}
  BoundProblem(const BoundProblem&) = delete;
  BoundProblem& operator=(const BoundProblem&) = delete;
  // The next problem may get the same address, and must not pass for the owner.
  ~BoundProblem() {
    if (run.owner == this) run.owner = nullptr;
  }

  SolverRun& run;
  SharedRows shared;
  TrialSet trial;
  rc_grid where{};
  BoundSteps steps{};
  std::int64_t most_iterations = std::numeric_limits<std::int64_t>::max();
};

namespace {

// Throws if this solver cannot run inside this run.
void require(const rc_solver& solver, const SolverRun& run, const char* as) {
  if ((solver.needs & RC_NEEDS_GRID) && run.grid.nx == 0)
    fail(RC_ERR_INCOMPATIBLE, as, ": solver \"", solver.name, "\" needs a half-space grid");
  if (const std::string missing = missing_cap(solver, run.problem.system); !missing.empty())
    fail(RC_ERR_INCOMPATIBLE, as, ": ", missing);
  if (const std::string missing = missing_operation(solver, run.op.capabilities(), run.fallbacks); !missing.empty())
    fail(RC_ERR_INCOMPATIBLE, as, ": ", missing);
}

const BoundProblem& bound(const rc_problem* problem) { return *static_cast<const BoundProblem*>(problem); }
const SolverRun& run_of(const rc_problem* problem) { return bound(problem).run; }

Operator& op_for(const BoundProblem& problem) {
  SolverRun& run = problem.run;
  if (run.owner != &problem) {
    run.owner = nullptr;
    run.op.bind(problem.trial);
    run.owner = &problem;
  }
  return run.op;
}
Operator& op_of(const rc_problem* problem) { return op_for(bound(problem)); }

rc_status apply(const rc_problem* problem, const double* x, double* y) {
  return caught([&]() -> rc_status { return op_of(problem).apply(x, y); });
}

rc_status apply_float(const rc_problem* problem, const float* x, float* y) {
  return caught([&]() -> rc_status { return op_of(problem).apply_float(x, y); });
}

rc_status subset(const rc_problem* problem, std::int64_t na, const std::int64_t* a, const double* b, double* x) {
  return caught([&]() -> rc_status {
    return op_of(problem).subset({a, static_cast<std::size_t>(na)}, b, x, 1e-3 * problem->tol);
  });
}

rc_status shifted(const rc_problem* problem, double rho, double tol, const double* b, double* x) {
  return caught([&]() -> rc_status { return op_of(problem).shifted(rho, tol, b, x); });
}

rc_status norm(const rc_problem* problem, double* out) {
  return caught([&]() -> rc_status { return op_of(problem).norm(*out); });
}

rc_status poll(const rc_problem* problem, std::int64_t iteration, double kkt) {
  const SolverRun& run = run_of(problem);
  return caught([&] {
    const rc_status stop = run.problem.company().agreed(run.attempt.monitor.poll(iteration, kkt, run.op.products()));
    return stop == RC_OK && iteration >= bound(problem).most_iterations ? RC_STOP_MAX_ITER : stop;
  });
}

rc_status coarse(const rc_problem* problem, rc_coarse* request) {
  return caught([&]() -> rc_status {
    const SolverRun& run = run_of(problem);
    if (!run.problem.coarse)
      fail(RC_ERR_INCOMPATIBLE, "rc_problem.coarse: this grid is a coarser one of the step and starts without others");
    return run.problem.coarse->solve(*request, run.problem, run.attempt);
  });
}

rc_status coefficients(const rc_problem* problem, std::int64_t mx, std::int64_t my, double* out) {
  return caught([&]() -> rc_status { return run_of(problem).problem.operators().coefficients(mx, my, out); });
}

void multiplied(const rc_problem* problem, std::int64_t products) { run_of(problem).op.count(products); }

void note(const rc_problem* problem, const char* text) {
  caught([&]() -> rc_status {
    run_of(problem).remarks.replace(text);
    return RC_OK;
  });
}

void keep(const rc_kept_steps* steps, void* object, void (*destroy)(void*)) {
  const BoundSteps& own = *static_cast<const BoundSteps*>(steps);
  try {
    own.all->own = {own.by, std::shared_ptr<void>(object, destroy)};
  } catch (const std::bad_alloc&) {
    // it is destroyed: the next step starts from the host's copy
  }
}

void connect(BoundProblem& problem);

rc_status solve(const rc_solver& solver, BoundProblem& problem, double* p, double* d) {
  if (problem.run.attempt.monitor.used_up()) return RC_STOP_MAX_ITER;
  const rc_options& options = problem.run.problem.options;
  const StepSurface& surface = problem.run.problem.surface;
  const bool in_single = (solver.needs & RC_READS_SINGLE_GAP) != 0;
  rc_grid& grid = problem.where;
  if (grid.nx > 0) grid.undeformed_gap = surface.gap_for_solver(in_single);
  const GapValues& gap = surface.gap();
  if (const GapOnDevice& there = problem.run.problem.gap_on_device; there.is_of(gap) && (in_single || gap.in_double()))
    grid.gap_on_device = {there.at, gap.array().type, 0, there.memory.c_str()};
  op_for(problem);
  return solver.solve(&problem.run.problem.host, &problem, &options, p, d);
}

// Runs another solver, with pressure at some of the unknowns only.
rc_status inner_solve(const BoundProblem& outer, const char* name, std::span<const std::int64_t> a, double tol, double* p,
                      double* product) {
  SolverRun& run = outer.run;
  if (outer.control != RC_CONTROL_APPROACH) fail(RC_ERR_INCOMPATIBLE, "a solver inside a solver needs approach control");
  const auto inside = static_cast<std::int64_t>(a.size());
  const StepFacts facts{.candidates = inside, .box = inside, .tol = tol};
  const rc_solver& solver = std::string_view(name) == "auto"
                                ? solver_inside(run.problem.options, run.problem.system, facts, *run.choice.backend)
                                : run.problem.options.context->solver(name);
  require(solver, run, "a solver inside a solver");

  BoundProblem problem(run);
  problem.trial.zero_mode = outer.trial.zero_mode;
  problem.trial.n = static_cast<std::int64_t>(a.size());
  if (problem.trial.n < outer.n || !outer.trial.index.empty())
    for (const std::int64_t i : a) problem.trial.index.push_back(outer.trial.point(i));
  std::vector<double> u, start;
  const auto penetration = [&](std::int64_t i) {
    return outer.u ? outer.u[i]
                   : (outer.where.approach - run.problem.surface.gap_at(static_cast<std::size_t>(outer.trial.point(i)))) /
                         outer.length;
  };
  for (const std::int64_t i : a) {
    u.push_back(penetration(i));
    start.push_back(p[i]);
  }
  problem.n = problem.trial.n;
  problem.control = outer.control;
  problem.u = u.data();
  problem.tol = tol;
  problem.where = outer.where;
  connect(problem);

  rc_status status = RC_OK;
  if (problem.n > 0) {
    const std::int64_t iteration = run.attempt.monitor.begin_call();
    double unused = 0;
    status = solve(solver, problem, start.data(), &unused);
    run.attempt.monitor.end_call(iteration);
    if (status < 0) return status;
  }
  std::fill(p, p + outer.n, 0.0);
  for (std::size_t k = 0; k < a.size(); ++k) p[a[k]] = start[k];
  if (product) {
    std::fill(product, product + outer.n, 0.0);
    if (problem.n > 0) {
      std::vector<double> everywhere(static_cast<std::size_t>(run.op.points()));
      op_for(problem).field(start, everywhere);
      for (std::int64_t i = 0; i < outer.n; ++i) product[i] = everywhere[static_cast<std::size_t>(outer.trial.point(i))];
    }
  }
  return status;
}

rc_status inner(const rc_problem* problem, const char* solver, std::int64_t na, const std::int64_t* a, double tol, double* p,
                double* product) {
  return caught([&]() -> rc_status {
    return inner_solve(bound(problem), solver, {a, static_cast<std::size_t>(na)}, tol, p, product);
  });
}

void connect(BoundProblem& problem) {
  const SolverRun& run = problem.run;
  const std::uint64_t caps = run.op.capabilities();
  problem.struct_size = sizeof(rc_problem);
  problem.apply = apply;
  problem.rows = run.problem.rows().seen(problem.shared);
  const bool all_here = !problem.rows;
  problem.subset = all_here && (run.fallbacks || (caps & RC_CAP_SUBSET)) ? subset : nullptr;
  problem.poll = poll;
  problem.lambda_min = run.problem.system.bounds.lambda_min;
  problem.positive = run.problem.system.positive;
  problem.factors = (caps & RC_CAP_SUBSET) != 0;
  problem.shifted = all_here && (run.fallbacks || (caps & RC_CAP_SHIFTED)) ? shifted : nullptr;
  problem.norm = all_here && (caps & RC_CAP_NORM) ? norm : nullptr;
  problem.inner = all_here && !run.problem.operators().multiply_by_rows() ? inner : nullptr;
  problem.apply_float = (caps & RC_CAP_FLOAT) ? apply_float : nullptr;
  problem.team = &run.problem.team();
  problem.length = run.length_unit;
  problem.pressure = run.pressure_unit;
  problem.cap = run.cap;
  problem.note = note;
  problem.multiplied = multiplied;
  problem.zero_mode = problem.trial.zero_mode;
  if (run.grid.nx > 0) {
    problem.where.index = problem.trial.index.empty() ? nullptr : problem.trial.index.data();
    problem.grid = &problem.where;
    problem.coarse = coarse;
    problem.coefficients = coefficients;
  }
}

bool warms_up(const rc_solver& solver, const rc_options& options) {
  const std::string& first = options.text(RC_OPT_WARMUP);
  return first != "none" && first != solver.name;
}

// The warm-up: some iterations of another solver come first. They need not converge.
rc_status warm_up(BoundProblem& problem, double* p, double* d) {
  const SolverRun& run = problem.run;
  if (!warms_up(*run.choice.solver, run.problem.options)) return RC_OK;
  const std::string& name = run.problem.options.text(RC_OPT_WARMUP);
  const rc_solver& solver = run.problem.options.context->solver(name);
  if (!(solver.controls & static_cast<std::uint32_t>(problem.control))) {
    run.remarks.replace(join("warmup: \"", name, "\" cannot prescribe the load and was left out"));
    return RC_OK;
  }
  require(solver, run, "warmup");
  problem.most_iterations = run.problem.options.integer(RC_OPT_WARMUP_ITERATIONS);
  const rc_status status = solve(solver, problem, p, d);
  problem.most_iterations = run.most_iterations;
  if (status != RC_OK) raise_if_failed(status, solver.name, {.backend = run.choice.backend->name});
  run.attempt.monitor.next_call();
  return status == RC_STOP_CANCELLED || status == RC_STOP_TIME ? status : RC_OK;
}

}  // namespace

bool takes_gap(const rc_solver& solver, const rc_options& options) {
  return (solver.needs & RC_READS_GAP) && !warms_up(solver, options);
}

SolverRun::SolverRun(const GridProblem& posed, Answer& answer, const Attempt& under, KeptSteps* history)
    : problem(posed),
      choice(answer.choice),
      op(*answer.op),
      attempt(under),
      remarks(answer.remarks),
      fallbacks(posed.options.integer(RC_OPT_ALLOW_FALLBACK) != 0),
      grid(posed.system.halfspace() ? grid_of(posed) : rc_grid{}),
      length_unit(posed.system.halfspace() ? answer.units.length : 0),
      pressure_unit(posed.system.halfspace() ? answer.units.pressure : 0),
      cap(answer.units.cap()),
      most_iterations(under.look > 0 ? under.look : std::numeric_limits<std::int64_t>::max()),
      history_(history),
      warmed_up_(under.look > 0) {}

rc_status SolverRun::operator()(std::int32_t control, std::span<const double> u, double load, double tol, double approach,
                                std::vector<double>& p, double& d) {
  BoundProblem posed(*this);
  posed.trial = op.trial();
  posed.n = static_cast<std::int64_t>(p.size());
  posed.control = control;
  posed.u = u.empty() ? nullptr : u.data();
  posed.load = load;
  posed.tol = tol;
  posed.where = grid;
  posed.where.approach = approach;
  posed.most_iterations = most_iterations;
  connect(posed);
  const Operator::Watch watch(op, [this] { return problem.company().stop().value_or(attempt.monitor.ask()); });
  attempt.monitor.next_call();
  clear_message();
  if (!warmed_up_) {
    warmed_up_ = true;
    if (const rc_status status = warm_up(posed, p.data(), &d); status != RC_OK) return status;
  }
  if (history_ && problem.goal.keeps_answers && grid.nx > 0 && !problem.rows().shared()) {
    const bool as_given = !warms_up(*choice.solver, problem.options);
    posed.steps = {{.struct_size = sizeof(rc_kept_steps),
                    .last = as_given ? history_->last.of(*choice.solver) : nullptr,
                    .before = as_given ? history_->before.of(*choice.solver) : nullptr,
                    .ahead = history_->ahead,
                    .hardness = problem.system.hardness,
                    .may_go_without = problem.company().may_pass_over(),
                    .reserved = 0,
                    .keep = keep},
                   history_,
                   choice.solver};
    posed.kept = &posed.steps;
    history_ = nullptr;
  }
  const rc_status status = solve(*choice.solver, posed, p.data(), &d);
  if (status != RC_OK)
    raise_if_failed(status, choice.solver->name, {choice.backend->name, op.failed() ? "" : choice.solver->name});
  op_for(posed);
  return status;
}

}  // namespace rc

#include "jobs.h"

#include "support/unit_system.h"

namespace threads {

namespace {

constexpr std::int64_t nx = 20, ny = 16, points = nx * ny;

// A chain of neighbours: positive definite, with negative entries.
std::int32_t apply(const double* x, double* y, std::int64_t n, void*) {
  for (std::int64_t i = 0; i < n; ++i) y[i] = 2.5 * x[i] - (i > 0 ? x[i - 1] : 0) - (i + 1 < n ? x[i + 1] : 0);
  return 0;
}

// Four bumps.
std::vector<double> surface() {
  std::vector<double> gap(points);
  for (std::int64_t i = 0; i < points; ++i) {
    const double x = static_cast<double>(i % nx % 10) - 4.5, y = static_cast<double>(i / nx % 8) - 3.5;
    gap[static_cast<std::size_t>(i)] = 0.01 * (x * x + y * y) + 0.001 * static_cast<double>(i % 7);
  }
  return gap;
}

}  // namespace

const std::vector<Job>& jobs() {
  const std::int32_t half_space = RC_OPERATOR_HALFSPACE, free = RC_BOUNDARY_FREE, periodic = RC_BOUNDARY_PERIODIC;
  const std::int32_t approach = RC_CONTROL_APPROACH, load = RC_CONTROL_LOAD;
  static const std::vector<Job> all = {
      {{{"backend", "fft"}, {"solver", "polonsky-keer"}, {"threads", "2"}}, half_space, free, approach},
      {{{"backend", "dense"}, {"solver", "nnls"}, {"kernel", "galerkin"}}, half_space, free, load},
      {{{"backend", "fft"}, {"solver", "polonsky-keer"}}, half_space, periodic, load},
      {{{"backend", "callback"}, {"solver", "polonsky-keer"}}, RC_OPERATOR_CALLBACK, free, approach},
      {{{"backend", "fft"}, {"solver", "nnls"}, {"kernel", "disc"}, {"stiffness", "1"}}, half_space, free, approach},
      {{{"backend", "dense"}, {"solver", "polonsky-keer"}, {"certify_backend", "fft"}}, half_space, free, load},
      {{{"backend", "dense"}, {"solver", "nnls"}}, half_space, periodic, approach},
      {{{"backend", "fft"}, {"solver", "polonsky-keer"}, {"threads", "2"}, {"fft.precision", "mixed"}, {"kernel", "punch"}},
       half_space,
       free,
       load},
  };
  return all;
}

Options options_for(const Job& job, rc_context* context) {
  rc_options* made = nullptr;
  if (rc_options_create(context, &made) != RC_OK) return nullptr;
  Options options(made);
  for (const auto& [key, value] : job.settings)
    if (rc_options_set_text(made, key, value) != RC_OK) return nullptr;
  return options;
}

Sequence solve(const Job& job, const rc_options* options, rc_progress_fn progress, void* user) {
  Sequence sequence;
  const std::vector<double> gap = surface();
  rc_system system = support::unit_system();
  system.op = job.op;
  system.boundary = job.boundary;
  system.nx = nx;
  system.ny = ny;
  system.apply = apply;
  rc_contact* made = nullptr;
  rc_status status = rc_contact_create(&system, options, &made);
  const Contact contact(made);
  if (status != RC_OK) return {{}, complain("rc_contact_create", status)};
  if (progress && (status = rc_contact_on_progress(made, progress, user, 1)) != RC_OK)
    return {{}, complain("rc_contact_on_progress", status)};
  sequence.p.resize(points);
  for (const double share : {0.3, 0.6, 1.0}) {
    rc_step step = RC_STEP_INIT;
    step.control = job.control;
    step.target = share * (job.control == RC_CONTROL_LOAD ? 6 : 0.12);
    step.undeformed_gap.data = gap.data();
    rc_result result = RC_RESULT_INIT;
    result.p.data = sequence.p.data();
    status = rc_contact_solve(made, &step, &result);
    if (status != RC_OK) return {{}, complain("rc_contact_solve", status)};
  }
  return sequence;
}

std::string complain(const char* where, rc_status status) {
  return std::string(where) + ": " + rc_status_name(status) + ": " + rc_last_error();
}

}  // namespace threads

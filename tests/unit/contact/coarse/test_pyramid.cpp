// The grids on which a step is solved: from the coarsest to the given one, none twice. Solvers that keep a list stand for
// haar-cg, also where it asks for coarser grids itself.
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "registry/options_handle.h"
#include "support/cmocka.hpp"

namespace {

using Side = std::int64_t;

rc_solver haar;                           // the solver that the listing ones run
rc_backend transforms;                    // the backend that the failing one copies
Side fails_at = 0;                        // side of the grid on which components named "failing" fail
std::vector<Side> solved;                 // sides of the grids of the current step that are solved; not twice in a row
std::vector<double> tolerances;           // of the same solves
decltype(rc_problem::coarse) own_coarse;  // of the core

rc_status listing_coarse(const rc_problem* problem, rc_coarse* request) {
  request->solver = "listing";
  return own_coarse(problem, request);
}

rc_status solve_and_list(const rc_host* host, const rc_problem* problem, const rc_options* options, double* p, double* d) {
  rc_problem& open = const_cast<rc_problem&>(*problem);  // the core's, which is not const
  if (open.coarse != listing_coarse) own_coarse = std::exchange(open.coarse, listing_coarse);
  const Side side = problem->grid->nx;
  const rc_status status = haar.solve(host, problem, options, p, d);
  if (status == RC_OK && (solved.empty() || solved.back() != side)) {
    solved.push_back(side);
    tolerances.push_back(problem->tol);
  }
  return status;
}

rc_status solve_or_fail(const rc_host* host, const rc_problem* problem, const rc_options* options, double* p, double* d) {
  if (problem->grid->nx == fails_at) return RC_ERR_MEMORY;
  return solve_and_list(host, problem, options, p, d);
}

rc_status create_or_fail(const rc_host* host, const rc_operator_spec* spec, void** self) {
  if (spec->system->nx == fails_at) return RC_ERR_MEMORY;
  return transforms.create(host, spec, self);
}

// "auto" prefers the estimates of the components that stand for others.
rc_status scaled(rc_status status, rc_estimate* out, double factor) {
  out->seconds *= factor;
  out->product *= factor;
  out->field *= factor;
  return status;
}
rc_status score_of_listing(const rc_facts* facts, rc_estimate* out) { return scaled(haar.score(facts, out), out, 1e-2); }
rc_status score_of_failing(const rc_facts* facts, rc_estimate* out) { return scaled(haar.score(facts, out), out, 1e-4); }
rc_status score_of_failing_backend(const rc_facts* facts, rc_estimate* out) {
  return scaled(transforms.score(facts, out), out, 1e-2);
}

// A context with the listing solver and, by their names, those that fail.
class Listing {
 public:
  explicit Listing(bool with_solver, bool with_backend) {
    rc_context* context = nullptr;
    assert_int_equal(rc_context_create(0, nullptr, nullptr, nullptr, &context), RC_OK);
    rc_options* options = nullptr;
    assert_int_equal(rc_options_create(context, &options), RC_OK);
    context_.reset(context);
    options_.reset(options);
    assert_int_equal(rc_options_set_number(options, RC_OPT_THREADS, 1), RC_OK);
    haar = options->context->solver("haar-cg");
    transforms = options->context->backend("fft");
    solvers_[0] = renamed(haar, "listing", solve_and_list, score_of_listing);
    solvers_[1] = renamed(haar, "failing", solve_or_fail, score_of_failing);
    backend_ = transforms;
    backend_.name = "failing";
    backend_.n_options = 0;
    backend_.create = create_or_fail;
    backend_.score = score_of_failing_backend;
    plugin_ = {sizeof plugin_,
               RC_PLUGIN_ABI_MAJOR,
               RC_PLUGIN_ABI_MINOR,
               "tests",
               "1",
               with_backend ? 1 : 0,
               with_solver ? 2 : 1,
               0,
               backends_,
               solver_list_,
               nullptr};
    if (rc_context_register(context, &plugin_) != RC_OK) fail_msg("%s", rc_last_error());
  }

  // Sides of the grids that each of the steps, by load, solves.
  std::vector<std::vector<Side>> grids_of(const std::vector<double>& gap, Side side, std::int32_t boundary,
                                          const std::vector<double>& mean_pressures) const {
    rc_system system = RC_SYSTEM_INIT;
    system.nx = system.ny = side;
    system.hx = system.hy = 1;
    system.modulus = 1;
    system.boundary = boundary;
    rc_contact* made = nullptr;
    assert_int_equal(rc_contact_create(&system, options_.get(), &made), RC_OK);
    const std::unique_ptr<rc_contact, void (*)(rc_contact*)> contact(made, rc_contact_destroy);
    std::vector<std::vector<Side>> all;
    for (const double mean : mean_pressures) {
      rc_step step = RC_STEP_INIT;
      step.undeformed_gap.data = gap.data();
      step.control = RC_CONTROL_LOAD;
      step.target = mean * static_cast<double>(side * side);
      rc_result result = RC_RESULT_INIT;
      solved.clear();
      tolerances.clear();
      if (rc_contact_solve(contact.get(), &step, &result) != RC_OK) fail_msg("%s", rc_last_error());
      constexpr double loose = 5e-3;  // coarser grids are solved to two digits
      for (std::size_t k = 0; k < solved.size(); ++k) assert_int_equal(tolerances[k] > loose, solved[k] < side);
      all.push_back(solved);
    }
    return all;
  }

 private:
  static rc_solver renamed(rc_solver solver, const char* name, decltype(rc_solver::solve) solve,
                           decltype(rc_solver::score) score) {
    solver.name = name;
    solver.needs &= ~RC_TAKES_ROWS;  // for built-in solvers
    solver.n_options = 0;
    solver.solve = solve;
    solver.score = score;
    solver.solve_many = nullptr;
    return solver;
  }

  std::unique_ptr<rc_context, void (*)(rc_context*)> context_{nullptr, rc_context_destroy};
  std::unique_ptr<rc_options, void (*)(rc_options*)> options_{nullptr, rc_options_destroy};
  rc_solver solvers_[2]{};
  rc_backend backend_{};
  const rc_solver* solver_list_[2] = {&solvers_[0], &solvers_[1]};
  const rc_backend* backends_[1] = {&backend_};
  rc_plugin plugin_{};
};

// Waves of several lengths, 1 high.
std::vector<double> rough(Side side) {
  std::vector<double> gap(static_cast<std::size_t>(side * side));
  for (Side y = 0; y < side; ++y)
    for (Side x = 0; x < side; ++x) {
      double height = 0;
      for (int k = 0; k < 6; ++k) {
        const double wave = std::exp2(k) * 6 / static_cast<double>(side), turn = 1 + 2.4 * k;
        height += std::exp2(-0.8 * k) *
                  std::cos(wave * (std::cos(turn) * static_cast<double>(x) + std::sin(turn) * static_cast<double>(y)) + k);
      }
      gap[static_cast<std::size_t>(y * side + x)] = -height;
    }
  return gap;
}

using Grids = std::vector<Side>;
constexpr double sparse = 1e-4, dense = 1e-2;  // mean pressures over the modulus

void expect_grids(const Grids& found, const Grids& expected) {
  std::string list;
  for (const Side side : found) list += " " + std::to_string(side);
  if (found != expected) fail_msg("solved on grids of%s", list.c_str());
}

void a_cold_step_solves_each_grid_once(void**) {
  const Listing listing(false, false);
  const std::vector<double> gap = rough(512);
  for (const double mean : {sparse, dense})
    for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC})
      expect_grids(listing.grids_of(gap, 512, boundary, {mean})[0], {64, 128, 256, 512});
}

// Also if the coarser grids are large enough for sparse contact, which is not there.
void a_step_to_half_the_load_solves_each_grid_once(void**) {
  const Listing listing(false, false);
  expect_grids(listing.grids_of(rough(512), 512, RC_BOUNDARY_FREE, {dense, dense / 2})[1], {64, 128, 256, 512});
  expect_grids(listing.grids_of(rough(1024), 1024, RC_BOUNDARY_FREE, {dense, dense / 2})[1], {64, 128, 256, 512, 1024});
}

// From the grid on which the component failed.
void a_component_that_is_skipped_leaves_the_grids_below_solved(void**) {
  const std::vector<double> gap = rough(512);
  for (const bool backend : {false, true}) {
    const Listing listing(!backend, backend);
    for (const Side side : {64, 256, 512}) {
      fails_at = side;
      expect_grids(listing.grids_of(gap, 512, RC_BOUNDARY_FREE, {dense})[0], {64, 128, 256, 512});
    }
    fails_at = 0;
  }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_cold_step_solves_each_grid_once),
      cmocka_unit_test(a_step_to_half_the_load_solves_each_grid_once),
      cmocka_unit_test(a_component_that_is_skipped_leaves_the_grids_below_solved),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}

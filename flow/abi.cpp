// The exported functions: they check arguments, call, and write results.
#include <roughcontact/flow.h>

#include <chrono>
#include <cmath>

#include "abi/own_guard.h"
#include "abi/steps.h"
#include "closing.h"
#include "layout.h"

namespace rc::flow {

namespace {

class Clock {
 public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count(); }

 private:
  const std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

// The answer's status becomes the call's, with a message for a usable one.
template <class Answer, class Body> rc_status answered(const char* where, Answer* out, const char* name, const Body& body) {
  rc_status status = RC_OK;
  const rc_status failed = own_guard<Library>(where, [&] {
    check_size(out, name);
    const Clock clock;
    Answer answer = body();
    answer.struct_size = sizeof(Answer);
    answer.seconds = clock.seconds();
    write(out, answer);
    status = answer.status;
  });
  if (failed != RC_OK) return failed;
  if (status == RC_STOP_STALLED)
    std::snprintf(own_message<Library>, sizeof own_message<Library>,
                  "%s: the interval is wider than wanted: the gap's error and round-off allow no narrower one", where);
  return status;
}

void check_length(const char* name, double value) {
  if (!(value > 0) || !std::isfinite(value)) fail(RC_ERR_ARGUMENT, name, " = ", value, " must be positive and finite");
}

void check_grid(std::int64_t nx, std::int64_t ny, double hx, double hy) {
  constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
  if (nx < 1 || ny < 1) fail(RC_ERR_SHAPE, "nx = ", nx, ", ny = ", ny, ": at least 1 x 1 cells are needed");
  if (nx > most / ny) fail(RC_ERR_SHAPE, "nx = ", nx, ", ny = ", ny, ": more than 2^31 - 1 cells");
  check_length("hx", hx);
  check_length("hy", hy);
}

rc_flow_spec read_spec(const rc_flow_spec* given) {
  const auto spec = read<rc_flow_spec>(given, "rc_flow_spec", RC_FLOW_SPEC_INIT);
  if (spec.along != RC_FLOW_X && spec.along != RC_FLOW_Y)
    fail(RC_ERR_ARGUMENT, "along = ", spec.along, " must be RC_FLOW_X or RC_FLOW_Y");
  if (!(spec.width >= 1e-12 && spec.width <= 1)) fail(RC_ERR_ARGUMENT, "width = ", spec.width, " is not in 1e-12 .. 1");
  if (!(spec.memory >= 0)) fail(RC_ERR_ARGUMENT, "memory = ", spec.memory, " must be at least 0");
  check_host_array(spec.gap, "gap");
  check_host_array(spec.gap_error, "gap_error");
  check_host_array(spec.mask, "mask");
  check_host_array(spec.potential, "potential");
  return spec;
}

void check_sides(std::int32_t sides, bool may_follow) {
  if (sides != RC_FLOW_CLOSED && sides != RC_FLOW_PERIODIC && !(may_follow && sides == 0))
    fail(RC_ERR_ARGUMENT, "sides = ", sides, " must be RC_FLOW_CLOSED or RC_FLOW_PERIODIC");
}

void check_fluid(const rc_flow_spec& spec) {
  check_length("viscosity", spec.viscosity);
  check_length("pressure_drop", spec.pressure_drop);
}

// Values of the caller, each finite and at least 0.
std::vector<double> checked(const rc_const_array& array, std::int64_t n, const char* name) {
  const auto* values = static_cast<const double*>(array.data);
  std::int64_t wrong = 0, first = -1;
  for (std::int64_t i = 0; i < n; ++i)
    if (!(values[i] >= 0 && std::isfinite(values[i]))) {
      if (wrong++ == 0) first = i;
    }
  if (wrong > 0)
    fail(RC_ERR_ARGUMENT, name, " has ", wrong, " values that are negative, infinite or NaN, the first at ", first, ": ",
         values[first], "; a closed cell has 0");
  return {values, values + n};
}

Gap given_gap(const rc_flow_spec& spec) {
  check_grid(spec.nx, spec.ny, spec.hx, spec.hy);
  if (!spec.gap.data) fail(RC_ERR_ARGUMENT, "gap is null");
  const std::int64_t n = spec.nx * spec.ny;
  Gap gap;
  gap.computed = checked(spec.gap, n, "gap");
  gap.least = gap.most = gap.computed;
  if (!spec.gap_error.data) return gap;
  const std::vector<double> error = checked(spec.gap_error, n, "gap_error");
  for (std::size_t i = 0; i < error.size(); ++i) {
    if (error[i] == 0) continue;
    gap.least[i] = std::max(0.0, (gap.computed[i] - error[i]) * (1 - epsilon));
    gap.most[i] = (gap.computed[i] + error[i]) * (1 + epsilon);
  }
  return gap;
}

rc_flow_result flow_of(const Layout& layout, const rc_flow_spec& spec, Gap gap, double error) {
  const Conductance found = conductance(layout.grid, layout.arranged(std::move(gap)), {spec.width, spec.memory});
  const double per_drop = spec.pressure_drop / (12 * spec.viscosity);
  rc_flow_result answer = RC_FLOW_RESULT_INIT;
  answer.lower = std::max(0.0, found.lower.xx) * per_drop * (1 - 8 * epsilon);
  answer.upper = found.upper.xx * per_drop * (1 + 8 * epsilon);
  answer.flow = std::clamp(found.computed.xx * per_drop, answer.lower, answer.upper);
  answer.crosses = found.place != outside;
  answer.iterations = found.iterations;
  answer.constriction = found.constriction;
  const auto place = found.place == outside ? -1 : static_cast<std::int64_t>(layout.of_caller(found.place));
  const std::int64_t wide = layout.turned ? layout.grid.ny : layout.grid.nx;
  answer.constriction_x = place < 0 ? -1 : place % wide;
  answer.constriction_y = place < 0 ? -1 : place / wide;
  answer.gap_error = error;
  answer.dropped = found.dropped;
  answer.status = found.narrow ? RC_OK : RC_STOP_STALLED;
  if (auto* const out = static_cast<double*>(spec.potential.data))
    for (std::size_t i = 0; i < found.potential.size(); ++i)
      out[layout.of_caller(static_cast<std::int64_t>(i))] = found.potential[i];
  return answer;
}

rc_system system_with_gaps(const rc_system* given) {
  const rc_system system = read_system(given);
  if (system.op != RC_OPERATOR_HALFSPACE && system.op != RC_OPERATOR_DENSE)
    fail(RC_ERR_INCOMPATIBLE,
         "the system's op must be RC_OPERATOR_HALFSPACE or RC_OPERATOR_DENSE: the gap's error is not known for others; "
         "give gap and gap_error to rc_flow_solve");
  check_grid(system.nx, system.ny, system.hx, system.hy);
  return system;
}

}  // namespace

}  // namespace rc::flow

using namespace rc;        // NOLINT: this file is the bridge
using namespace rc::flow;  // NOLINT

const char* rc_flow_last_error(void) { return own_message<rc::flow::Library>; }

void rc_flow_stop_when(const int32_t* flag) { stop_flag<rc::flow::Library> = flag; }

rc_status rc_flow_solve(const rc_flow_spec* given, rc_flow_result* out) {
  return answered("rc_flow_solve", out, "rc_flow_result", [&] {
    const rc_flow_spec spec = read_spec(given);
    check_sides(spec.sides, false);
    check_fluid(spec);
    Gap gap = given_gap(spec);
    double error = 0;
    for (std::size_t i = 0; i < gap.most.size(); ++i) error = std::max(error, gap.most[i] - gap.computed[i]);
    return flow_of(layout_of(spec.nx, spec.ny, spec.hx, spec.hy, spec), spec, std::move(gap), error);
  });
}

rc_status rc_flow_of_result(const rc_system* given_system, const rc_options* options, const rc_result* given_result,
                            const rc_flow_spec* given, rc_flow_result* out) {
  return answered("rc_flow_of_result", out, "rc_flow_result", [&] {
    const rc_system system = system_with_gaps(given_system);
    const rc_flow_spec spec = read_spec(given);
    const rc_result result = read_result(given_result);
    check_sides(spec.sides, true);
    check_fluid(spec);
    check_host_array(result.p, "rc_result.p");
    check_host_array(result.gap, "rc_result.gap");
    if (result.status < 0) fail(RC_ERR_ARGUMENT, "rc_result.status = ", result.status, ": the step has no answer");
    if (!result.p.data || !result.gap.data)
      fail(RC_ERR_ARGUMENT, "rc_result.p and rc_result.gap must be arrays that the step has written");
    if (!(spec.load >= 0)) fail(RC_ERR_ARGUMENT, "load = ", spec.load, " must be at least 0");
    const bool hard = system.hardness > 0 && std::isfinite(system.hardness);
    if (spec.load > 0 && hard)
      fail(RC_ERR_INCOMPATIBLE, "with a hardness the interval holds at the returned approach only; set load to 0");
    const auto* mask = static_cast<const std::uint8_t*>(spec.mask.data);
    const auto* gap = static_cast<const double*>(result.gap.data);
    for (std::int64_t i = 0; i < system.nx * system.ny; ++i)
      if ((!mask || mask[i] != 0) && !std::isfinite(gap[i]))
        fail(RC_ERR_ARGUMENT, "rc_result.gap is ", gap[i], " at ", i, ", where the mask excludes no point");
    const Layout layout = layout_of(system, spec);
    const double error = gap_error(system, options, result, mask, spec.load);
    if (!std::isnan(error)) return flow_of(layout, spec, contact_gap(system, result, mask, error, !(spec.load > 0)), error);
    rc_flow_result answer = flow_of(layout, spec, contact_gap(system, result, mask, 0, false), error);
    answer.lower = 0;
    answer.upper = std::numeric_limits<double>::infinity();
    answer.status = RC_STOP_STALLED;
    return answer;
  });
}

rc_status rc_flow_factors_find(const rc_flow_spec* given, rc_flow_factors* out) {
  return answered("rc_flow_factors_find", out, "rc_flow_factors", [&] {
    const rc_flow_spec spec = read_spec(given);
    Gap gap = given_gap(spec);
    const Grid grid{spec.nx, spec.ny, spec.hy / spec.hx, spec.hx / spec.hy, true, true};
    Sum sum;
    for (const double g : gap.computed) sum.add(g);
    const Conductance found = conductance(grid, std::move(gap), {spec.width, spec.memory});
    // A unit drop over the cell is a gradient of 1 over its length, and the flow crosses its width.
    const double wide = static_cast<double>(spec.nx) * spec.hx, high = static_cast<double>(spec.ny) * spec.hy;
    const double to_xx = wide / high, to_yy = high / wide;
    const double low = 1 - 8 * epsilon, up = 1 + 8 * epsilon;
    rc_flow_factors answer = RC_FLOW_FACTORS_INIT;
    answer.xx_lower = std::max(0.0, found.lower.xx) * to_xx * low;
    answer.xx_upper = found.upper.xx * to_xx * up;
    answer.yy_lower = std::max(0.0, found.lower.yy) * to_yy * low;
    answer.yy_upper = found.upper.yy * to_yy * up;
    const double xy = 0.5 * (found.lower.xy + found.upper.xy);
    const double apart =
        0.5 * std::sqrt(std::max(0.0, found.upper.xx - found.lower.xx) * std::max(0.0, found.upper.yy - found.lower.yy)) +
        64 * epsilon * std::sqrt(found.upper.xx * found.upper.yy);
    answer.xy_lower = xy - apart;
    answer.xy_upper = xy + apart;
    answer.xx = std::clamp(found.computed.xx * to_xx, answer.xx_lower, answer.xx_upper);
    answer.yy = std::clamp(found.computed.yy * to_yy, answer.yy_lower, answer.yy_upper);
    answer.xy = std::clamp(found.computed.xy, answer.xy_lower, answer.xy_upper);
    answer.mean_gap = sum.value() / static_cast<double>(spec.nx * spec.ny);
    answer.status = found.narrow ? RC_OK : RC_STOP_STALLED;
    return answer;
  });
}

rc_status rc_flow_closing_pressure(const rc_system* given_system, const rc_options* options, const rc_step* given_step,
                                   const rc_flow_spec* given, rc_flow_closing* out) {
  return answered("rc_flow_closing_pressure", out, "rc_flow_closing", [&] {
    const rc_system system = system_with_gaps(given_system);
    const rc_flow_spec spec = read_spec(given);
    check_sides(spec.sides, true);
    const rc_step step = read_step(given_step);
    check_host_array(step.mask, "rc_step.mask");
    if (!step.undeformed_gap.data) fail(RC_ERR_ARGUMENT, "rc_step.undeformed_gap is null");
    return closing_pressure(system, options, step, spec);
  });
}

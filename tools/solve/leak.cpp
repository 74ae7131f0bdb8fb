#include "solve/leak.h"

#include <cmath>
#include <cstdio>
#include <vector>

#include "formats/error.h"
#include "request/units.h"
#include "solve/interrupt.h"
#include "text.h"

namespace cli {

std::string line_of(const Problem& problem, const rc_flow_result& leak) {
  const std::string text = problem.view.along == RC_FLOW_X ? "leak along x " : "leak along y ";
  if (leak.upper == 0) return text + "0: no path through the gap is left, proven";
  if (!std::isfinite(leak.upper)) return text + format("%.4g m^3/s, no bound is known", leak.flow);
  return text + format("%.4g m^3/s, exact at this approach: %.6g .. %.6g", leak.flow, leak.lower, leak.upper) +
         "; lowest gap on the best path " + with_prefix(leak.constriction, "m");
}

#ifdef RC_COMMAND_FLOW

namespace {

void check_flow(rc_status status, const char* subject) {
  const std::string_view message = rc_flow_last_error();
  if (status < 0) throw Error(subject, message.substr(std::min(message.find(": "), message.size())));
}

}  // namespace

std::optional<rc_flow_result> leak_of(const Problem& problem, const rc_system& system, const std::uint8_t* mask,
                                      const rc_options* options, const rc_result& result) {
  rc_flow_spec spec = RC_FLOW_SPEC_INIT;
  spec.along = problem.view.along;
  spec.viscosity = problem.view.viscosity;
  spec.pressure_drop = problem.view.pressure_drop;
  spec.mask = RC_IN(mask);
  rc_flow_result found = RC_FLOW_RESULT_INIT;
  rc_flow_stop_when(stop_flag());
  const rc_status status = rc_flow_of_result(&system, options, &result, &spec, &found);
  check_flow(status, "--leak");
  return status == RC_STOP_CANCELLED ? std::nullopt : std::optional{found};
}

bool search_closing_pressure(const Problem& problem, const rc_options* options) {
  std::vector<double> gap{problem.input.surface.heights.begin(), problem.input.surface.heights.end()};
  rc_step step = RC_STEP_INIT;
  step.mask = RC_IN(problem.input.mask);
  check(rc_gap_from_heights(std::ssize(gap), RC_IN(gap.data()), step.mask, RC_OUT(gap.data())), "");
  step.undeformed_gap = RC_IN(gap.data());
  rc_flow_spec spec = RC_FLOW_SPEC_INIT;
  spec.along = problem.view.along;
  rc_flow_closing found = RC_FLOW_CLOSING_INIT;
  check_flow(rc_flow_closing_pressure(&problem.system, options, &step, &spec, &found), "--closing-pressure");
  const char* const axis = spec.along == RC_FLOW_X ? "x" : "y";
  if (found.upper == 0) {
    std::printf("the gap is closed along %s without a load, proven\n", axis);
    return true;
  }
  std::printf(
      "the gap closes along %s between %s (proven open, lowest gap on the best path %s) and %s (proven closed, %.3g %% in "
      "contact)\n",
      axis, with_prefix(found.lower, "Pa", 4).c_str(), with_prefix(found.constriction, "m").c_str(),
      with_prefix(found.upper, "Pa", 4).c_str(), 100 * found.area_fraction);
  if (found.status != RC_OK) report("the interval is wider than usual; a finer --tol narrows it");
  return found.status == RC_OK;
}

#else

namespace {

[[noreturn]] void refuse(const char* word) {
  throw Error(word,
              ": this command was built without CHOLMOD, which libroughcontact-flow needs; in Python's environment: pip install "
              "roughcontact-gpl");
}

}  // namespace

std::optional<rc_flow_result> leak_of(const Problem&, const rc_system&, const std::uint8_t*, const rc_options*,
                                      const rc_result&) {
  refuse("--leak");
}

bool search_closing_pressure(const Problem&, const rc_options*) { refuse("--closing-pressure"); }

#endif

}  // namespace cli

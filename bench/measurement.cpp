#include "measurement.h"

#include <algorithm>

#include "stopwatch.h"

namespace bench {

Json record_of(const rc_result& result) {
  return {{"status", rc_status_name(result.status)},
          {"displacement", result.displacement},
          {"load", result.load},
          {"kkt_primal", result.kkt_primal},
          {"kkt_dual", result.kkt_dual},
          {"kkt_complementarity", result.kkt_complementarity},
          {"kkt_control", result.kkt_control},
          {"solver", result.solver},
          {"backend", result.backend},
          {"kernel", result.kernel},
          {"note", result.note},
          {"points", result.points},
          {"candidates", result.candidates},
          {"modelled", result.modelled},
          {"contacts", result.contacts},
          {"iterations", result.iterations},
          {"products", result.applications},
          {"solve_seconds", result.seconds}};
}

TimedSolve time_solve(const rc_system& system, const rc_step& given, const Options& options, double budget, double* p) {
  rc_step step = given;
  step.borrow = 1;
  constexpr std::int64_t most_repeats = 20;
  const auto begun = Clock::now();
  TimedSolve fastest;
  double least = 0;
  for (std::int64_t k = 0; k == 0 || (k < most_repeats && seconds_since(begun) < budget); ++k) {
    const auto start = Clock::now();
    const double cpu_start = cpu_seconds();
    const rc_result result = Contact(system, options).solve(step, p);
    const double seconds = seconds_since(start);
    if (k == 0 || seconds < least) {
      least = seconds;
      fastest.result = result;
      fastest.cpu_seconds = cpu_seconds() - cpu_start;
      fastest.setup_seconds = std::max(0.0, seconds - result.seconds);
    }
    ++fastest.repeats;
  }
  return fastest;
}

}  // namespace bench

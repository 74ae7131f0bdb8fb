// The answer of a step before it is certified, and the estimate that it may start from.
#pragma once

#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "contact/choice.h"
#include "contact/kept_steps.h"
#include "contact/remarks.h"
#include "contact/surface/pressures.h"
#include "contact/system.h"
#include "core/chunks.h"
#include "operator/operator.h"

namespace rc {

struct AnswerUnits {
  double length = 1;                                          // [length]
  double pressure = 1;                                        // [force/length^2]
  double hardness = std::numeric_limits<double>::infinity();  // [force/length^2] the largest pressure

  double cap() const { return hardness / pressure; }  // the largest dimensionless pressure
  // A point at the cap has the hardness itself.
  double pressure_of(double value) const { return value < cap() ? value * pressure : hardness; }
};

// A solution on a trial set, before it is certified.
struct Answer {
  rc_status status = RC_OK;
  Choice choice = {};
  Operator* op = nullptr;      // bound to the trial set
  std::vector<double> p;       // on the trial set, dimensionless
  std::vector<double> before;  // [pressure] there, at an earlier approach; empty: not known
  AnswerUnits units = {};
  double compression = 0;                                   // [length] approach less the lowest gap
  double limit = -std::numeric_limits<double>::infinity();  // [length] every point below this height is in the trial set
  std::optional<Deflected> checked;                         // H p where it matters, if the operator screened all points
  bool handed_over = false;  // the solver's own load control stalled; an iteration on the approach took over
  double datum_shift = 0;    // [length] what the trial set's zero mode adds to H p
  KeptSteps history;         // of p
  Remarks remarks;           // of its solver

  Pressures pressures() const {
    Pressures result{op->trial(), p};
    for (double& value : result.p) value = units.pressure_of(value);
    return result;
  }
  // The same; afterwards p is empty.
  Pressures take_pressures(const rc_team& team) {
    Pressures result{op->trial(), std::move(p)};
    p = {};
    const auto take = [&](const auto& of) {
      each_chunk(static_cast<std::int64_t>(result.p.size()), team, [&](std::int64_t begin, std::int64_t count) {
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(begin + count); ++i)
          result.p[i] = of(result.p[i]);
      });
    };
    if (units.hardness < std::numeric_limits<double>::infinity())
      take([&](double value) { return units.pressure_of(value); });
    else
      take([unit = units.pressure](double value) { return value * unit; });
    return result;
  }
};

// The numbers of an answer without its operator and pressures. unit: 1 in dimensionless lengths [length].
inline Answer answer_in(double unit, const Choice& choice, const System& system) {
  Answer answer;
  answer.choice = choice;
  answer.units = {unit, unit / system.length_per_pressure, system.hardness};
  return answer;
}

// An estimate of the solution, from a coarser grid or an earlier step.
struct Estimate {
  Pressures pressures;  // on the points in contact
  double approach = 0;  // [length]
  bool dense = false;   // contact is not sparse: to look only at points near this approach would save nothing
};

}  // namespace rc

// The solves of a budget: a problem in, its quantities out.
#pragma once

#include <roughcontact/budget.h>
#include <roughcontact/derivatives.h>

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "request/budget/fields.h"
#include "request/request.h"

namespace rc::request {

namespace of {
enum Quantity : std::size_t { load, approach, area, mean_pressure, stiffness, mean_gap, conductance, further, count };
}
using Outcome = std::array<double, of::count>;

// A surface that is pressed. z: heights, NaN where a point is excluded; of an undeformed gap its negative.
struct Pressing {
  rc_system system;
  std::vector<double> z;
  std::optional<double> datum;  // the height that touches at approach 0; none: the highest
  std::int32_t control;
  double target;  // of rc_step

  Extent grid() const { return {system.nx, system.ny, system.hx, system.hy}; }
  double highest() const;
};

// The last target of a request.
Pressing pressing(const rc_request& request, bool of_gap);

using Options = std::unique_ptr<rc_options, decltype(&rc_options_destroy)>;
// The options of the caller and of the words. proven: intervals are computed (stiffness 2, bounds 1); else only values
// (stiffness 1, bounds 0).
Options options_of(const rc_budget_spec& spec, rc_context* context, const rc_request& request, bool proven);

// Thrown if a solve was stopped.
struct Stopped {
  rc_status status;
};

struct Progress {
  const rc_budget_spec& spec;
  std::int64_t ended = 0, all = 0;
};

// A contact of one system and its last solve.
class Press {
 public:
  Press(const rc_system& system, const rc_options* options, Progress& progress);

  // what: for the message of a solve that is not certified. Starts from the pressures of the last solve.
  Outcome solve(const Pressing& problem, const char* what);
  const rc_result& result() const { return result_; }
  // dJ/dz of the last solve at each point: of the load or approach that is not prescribed, or of the mean gap. Empty if there is
  // none.
  std::vector<double> derivative(const Pressing& problem, bool of_mean_gap);
  // Half the interval of rc_budget_spec.value that holds the exact one.
  double further_half() const { return (further_upper_ - further_lower_) / 2; }

 private:
  std::unique_ptr<rc_contact, decltype(&rc_contact_destroy)> contact_{nullptr, rc_contact_destroy};
  Progress& progress_;
  rc_result result_ = RC_RESULT_INIT;
  double further(const Pressing& problem);

  double further_lower_ = 0, further_upper_ = 0;
  std::vector<double> gap_, deformed_, pressures_;
  std::vector<std::uint8_t> mask_;
};

}  // namespace rc::request

// The stiffness dW/dd of a contact, and an interval of it.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "contact/answer.h"
#include "contact/problem.h"
#include "contact/slopes/contact_set_solve.h"

namespace rc {

// [force/length]
struct StiffnessInterval {
  double value = std::numeric_limits<double>::quiet_NaN();
  double lower = value, upper = value;
};

struct Stiffness : StiffnessInterval {
  // Where an interval may be asked for: the contact set, H^-1 1 on it, and the bound that these products gave it.
  std::vector<std::int64_t> points;
  std::vector<double> rate;
  const Operator* op = nullptr;
  ContactSetBound bound;
  double mean = 0;  // what the solve added to H
};

// hx hy 1' H_CC^-1 1 on the points C with 0 < p < hardness; NaN where a stop came before it was found.
Stiffness stiffness(const GridProblem& problem, const Answer& answer);
// The interval, from the points proven to be in contact below the hardness, and those possibly so: 1' H_SS^-1 1 grows with S,
// being the largest value of 2 1'x - x'Hx over all x that are 0 off S. So that of the points proven to carry less than the
// hardness is a lower bound, that of the points proven neither to be open nor to carry it an upper one, each widened by the error
// of its solve. op: whose products make the proof; null if no point is possibly in contact.
void prove_interval(const GridProblem& problem, Operator* op, const std::vector<std::int64_t>& contacts,
                    const std::vector<std::int64_t>& possible, Stiffness& stiffness);
// A rigid flat punch has this stiffness on these points, ascending: at least one, and in a period not all. op: bound to them.
// RC_STOP_STALLED: the error may exceed the tolerance, and the interval counts it.
rc_status stiffness_of_points(const GridProblem& problem, Operator& op, const std::vector<std::int64_t>& points,
                              StiffnessInterval& stiffness);

}  // namespace rc

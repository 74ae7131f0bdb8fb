// Solves the steps of a history: at the prescribed approach, load or mean pressure, or at the load that gives the prescribed
// area.
#pragma once

#include <string>
#include <vector>

#include "library.h"
#include "solve/contact_measures.h"
#include "solve/problem.h"
#include "solve/step_record.h"

namespace cli {

// A certified step, from which a later step starts.
struct CertifiedStep {
  std::vector<double> pressure;
  double approach = 0, load = 0;
};

class StepSolver {
 public:
  StepSolver(rc_contact* contact, const Problem& problem);

  // Goes on after a step of an earlier run. certified: the last two, newest first.
  void restore(std::vector<CertifiedStep> certified, std::vector<double> indentation);

  // Steps count from 1. The fields get what the step has found.
  StepRecord solve(int number, Fields& fields);

 private:
  StepRecord press(int number, int32_t control, double target, Fields& fields);
  StepRecord find_area(int number, Fields& fields);
  void restore_contact();
  double first_load(double share) const;

  rc_contact* contact_;
  const Problem& problem_;
  std::vector<double> gap_;
  bool gap_given_ = false;
  // If areas are prescribed: the state before the step, from which its search begins.
  std::vector<CertifiedStep> certified_;
  std::vector<double> indentation_;
};

}  // namespace cli

// Solves the steps of a history.
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

// The creep that a step has left.
struct Left {
  std::vector<double> creep;
  double time = 0;  // of the last certified step
};

class StepSolver {
 public:
  StepSolver(rc_contact* contact, const Problem& problem);

  // Goes on after a step of an earlier run. certified: the last two, newest first.
  void restore(const std::vector<CertifiedStep>& certified, const std::vector<double>& indentation, const Left& left);

  // Steps count from 1. The fields get what the step has found.
  StepRecord solve(int number, Fields& fields);

 private:
  rc_contact* contact_;
  const Problem& problem_;
  std::vector<double> gap_;
  bool gap_given_ = false;
};

}  // namespace cli

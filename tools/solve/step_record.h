// One complete step of the sequence.
#pragma once

#include <roughcontact/flow.h>

#include <algorithm>
#include <optional>
#include <string>

#include "solve/contact_measures.h"

namespace cli {

struct StepRecord {
  int number;  // 1, 2, ...
  rc_result result;
  ContactMeasures measures;
  std::string message;                   // why the step is not certified; "" if it is
  std::optional<rc_flow_result> leak{};  // if it is asked for

  bool good() const { return result.status == RC_OK || result.status == RC_WITHIN_GOAL; }
  double worst_residual() const {
    return std::max({result.kkt_primal, result.kkt_dual, result.kkt_complementarity, result.kkt_control});
  }
};

}  // namespace cli

// What a finished run has shown, in one line.
#pragma once

#include <string>

#include "problem.h"
#include "step_record.h"

namespace cli {

// "step 3 of 3: 11.3 % of the area carries 131 N; largest pressure 37 GPa, above the hardness of any steel: ..."
std::string conclusion(const Problem& problem, const StepRecord& last);

}  // namespace cli

// Steps in one line: what was asked, what was reached, what it shows.
#pragma once

#include <string>

#include "solve/problem.h"
#include "solve/step_record.h"

namespace cli {

// "load 62.5 uN" of this step, from 0 on, and the value that the answer has instead: "109 uN".
std::string asked(const Problem& problem, std::size_t step);
std::string reached(const Problem& problem, const StepRecord& step);

// That the contact of the given shape does not fit on the map, which then presses as a punch of its size; "" if it does, or
// without a shape.
std::string small_map(const Problem& problem, const rc_result& result);

// "step 3 of 3: contact area 11.3 % at 131 N; largest pressure 37 GPa; warning: above the hardness of any steel, ..."
std::string conclusion(const Problem& problem, const StepRecord& last);

}  // namespace cli

// Steps in one line: what was asked, what was reached, what it shows.
#pragma once

#include <optional>
#include <string>

#include "solve/problem.h"
#include "solve/step_record.h"

namespace cli {

// "load 62.5 uN" of this step, from 0 on, and the value that the answer has instead: "109 uN".
std::string asked(const Problem& problem, std::size_t step);
std::string reached(const Problem& problem, const StepRecord& step);

// The remarks of an answer, with the options that help.
std::string remarks(const Problem& problem, const rc_result& result);

// The answer for the given shape alone at this load; nothing without a shape.
std::optional<rc_smooth> smooth_answer(const Problem& problem, const rc_result& result);

// "Hertz, without roughness: radius 12.3 um, approach 151 nm, largest pressure 1.2 GPa"; "" without a shape that has such an
// answer.
std::string smooth_line(const Problem& problem, const rc_result& result);

// "step 3 of 3: contact area 11.3 % at 131 N; largest pressure 37 GPa; warning: above the hardness of any steel, ..."
std::string conclusion(const Problem& problem, const StepRecord& last);

}  // namespace cli

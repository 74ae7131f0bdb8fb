// `roughcontact solve`: solves the loading sequence, prints the table and fills the output folder step by step.
#pragma once

#include "solve/problem.h"

namespace cli {

enum ExitCode { exit_certified = 0, exit_error = 1, exit_uncertified = 2, exit_cancelled = 130 };

// Throws an Error for wrong input and failed calls; what earlier steps have written stays.
ExitCode run_solve(const SolveArguments& arguments);

}  // namespace cli

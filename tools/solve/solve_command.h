// `roughcontact solve`: solves the loading sequence, prints the table and fills the output folder step by step.
#pragma once

#include "exit_code.h"
#include "solve/problem.h"

namespace cli {

// Throws an Error for wrong input and failed calls; what earlier steps have written stays.
ExitCode run_solve(const SolveArguments& arguments);

}  // namespace cli

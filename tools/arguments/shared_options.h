// The options that several commands share. Parsing fills the arguments, which must live as long as the command.
#pragma once

#include "arguments/command.h"
#include "solve/problem.h"

namespace cli {

void add_set(Command& command, SolveArguments& arguments);
void add_resume(Command& command, SolveArguments& arguments);
void add_budget_sources(Command& command, SolveArguments& arguments);
void add_quiet(Command& command, SolveArguments& arguments);

}  // namespace cli

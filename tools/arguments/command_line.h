// The sub-commands and their options, and what a command line gave for them.
#pragma once

#include "arguments/command.h"
#include "law/law_arguments.h"
#include "solve/problem.h"
#include "surface/analyze_command.h"
#include "surface/generate_command.h"

namespace cli {

struct CommandLine {
  SolveArguments solve, report;
  std::optional<std::string> reported_law;
  GenerateArguments generate;
  AnalyzeArguments analyze;
  LawArguments law;
};

// Parsing fills the line, which must live as long as the command.
Command whole_command(CommandLine& line);

}  // namespace cli

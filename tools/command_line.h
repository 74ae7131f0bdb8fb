// The sub-commands and their options, and what a command line gave for them.
#pragma once

#include "analyze_command.h"
#include "generate_command.h"
#include "problem.h"

namespace CLI {
class App;
}

namespace cli {

struct CommandLine {
  SolveArguments solve;
  GenerateArguments generate;
  AnalyzeArguments analyze;
};

// Parsing by the app fills the line, which must live as long.
void add_commands(CLI::App& app, CommandLine& line);

}  // namespace cli

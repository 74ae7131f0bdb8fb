// The command `roughcontact`: arguments in, exit code out.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "arguments/command_line.h"
#include "arguments/completion.h"
#include "arguments/manual.h"
#include "arguments/parser.h"
#include "law/law_command.h"
#include "list_commands.h"
#include "platform/libraries.h"
#include "platform/terminal.h"
#include "report_command.h"
#include "solve/interrupt.h"
#include "solve/solve_command.h"
#include "text.h"

namespace cli {

const char command_name[] = "roughcontact";

}  // namespace cli

namespace {

std::string version() {
  int32_t major = 0, minor = 0, patch = 0, abi = 0;
  rc_version(&major, &minor, &patch, &abi);
  return cli::format("roughcontact %d.%d.%d (library ABI %d, %s)", major, minor, patch, abi,
                     rc_platform::loads_plugins() ? "plugin ABI " RC_PLUGIN_ABI : "linked statically, loads no plugins");
}

// words: what follows the name of the command.
int run(const std::vector<std::string>& words) {
  cli::CommandLine line;
  cli::Command command = cli::whole_command(line);
  command.version = version();
  if (!words.empty() && words[0] == "complete") {
    cli::complete(command, {words.begin() + 1, words.end()});
    return cli::exit_certified;
  }
  if (words == std::vector<std::string>{"manual"}) {
    std::fputs(cli::manual(command).c_str(), stdout);
    return cli::exit_certified;
  }

  const cli::Parsed parsed = cli::parse(command, words);
  if (!parsed.refusal.empty()) {
    cli::report(parsed.refusal);
    return cli::exit_error;
  }
  if (!parsed.answer.empty()) {
    std::fputs(parsed.answer.c_str(), stdout);
    return cli::exit_certified;
  }
  if (parsed.commands.empty()) {
    cli::report(
        "no command given, give solve, report, generate, analyze, law, backends, solvers, kernels, options or formats; see "
        "roughcontact "
        "--help");
    return cli::exit_error;
  }

  const std::string& name = parsed.commands.front();
  if (name == "solve") return cli::run_solve(line.solve);
  if (name == "report") return cli::run_report({words.begin() + 1, words.end()});
  if (name == "law") return cli::run_law(line.law);
  if (name == "generate") cli::generate(parsed.commands.back(), line.generate);
  if (name == "analyze") cli::analyze(line.analyze);
  if (name == "backends") cli::list_backends();
  if (name == "solvers") cli::list_solvers();
  if (name == "kernels") cli::list_kernels();
  if (name == "options") cli::list_options();
  if (name == "formats") cli::list_formats();
  return cli::exit_certified;
}

}  // namespace

int main(int argc, char** argv) {
  rc_platform::open_standard_streams();
  cli::handle_signals();
  int code = cli::exit_error;
  try {
    const std::vector<std::string> words = rc_platform::arguments(argc, argv);
    code = run({words.begin() + std::min<std::size_t>(words.size(), 1), words.end()});
  } catch (const std::bad_alloc&) {
    cli::report("out of memory");
  } catch (const std::exception& error) {
    cli::report(error.what());
  }
  const bool printed = cli::finish_standard_output();
  return printed || code != cli::exit_certified ? code : cli::exit_error;
}

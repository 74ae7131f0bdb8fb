// The command `roughcontact`: arguments in, exit code out.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "command_line.h"
#include "completion.h"
#include "interrupt.h"
#include "list_commands.h"
#include "platform/libraries.h"
#include "platform/terminal.h"
#include "refusal.h"
#include "solve_command.h"
#include "standard_streams.h"
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
  CLI::App app{"Normal contact of rough surfaces on an elastic half-space, every answer certified", "roughcontact"};
  app.allow_windows_style_options(false);  // "/x" is a path
  app.set_version_flag("--version", version());
  cli::CommandLine line;
  cli::add_commands(app, line);
  if (!words.empty() && words[0] == "complete") {
    cli::complete(app, {words.begin() + 1, words.end()});
    return cli::exit_certified;
  }

  try {
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));  // it takes the last one first
  } catch (const CLI::Success& success) {
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    cli::report(cli::refusal(app, words, error));
    return cli::exit_error;
  }

  if (app.got_subcommand("solve")) return cli::run_solve(line.solve);
  if (app.got_subcommand("generate")) {
    cli::generate(app.get_subcommand("generate")->get_subcommands().front()->get_name(), line.generate);
  }
  if (app.got_subcommand("analyze")) cli::analyze(line.analyze);
  if (app.got_subcommand("backends")) cli::list_backends();
  if (app.got_subcommand("solvers")) cli::list_solvers();
  if (app.got_subcommand("kernels")) cli::list_kernels();
  if (app.got_subcommand("options")) cli::list_options();
  if (app.got_subcommand("formats")) cli::list_formats();
  if (app.get_subcommands().empty()) {
    cli::report(
        "no command given, give solve, generate, analyze, backends, solvers, kernels, options or formats; see roughcontact "
        "--help");
    return cli::exit_error;
  }
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

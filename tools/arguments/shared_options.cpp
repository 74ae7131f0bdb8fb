#include "arguments/shared_options.h"

namespace cli {

void add_set(Command& command, SolveArguments& arguments) {
  command.add("Method", {{"--set", &arguments.set, "KEY=VALUE", "Any option, see roughcontact options; may be repeated"}});
}

void add_resume(Command& command, SolveArguments& arguments) {
  command.add("Output", {{"--resume", &arguments.resume, "", "Continue the earlier run in --out after its last finished step"}});
}

void add_quiet(Command& command, SolveArguments& arguments) {
  command.add("Output", {{"--quiet", &arguments.quiet, "", "No table and no progress"}});
}

}  // namespace cli

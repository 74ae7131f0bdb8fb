#include "arguments/shared_options.h"

namespace cli {

void add_set(Command& command, SolveArguments& arguments) {
  command.add("Method", {{"--set", &arguments.set, "KEY=VALUE", "Any option, see roughcontact options; may be repeated"}});
}

void add_resume(Command& command, SolveArguments& arguments) {
  command.add("Output", {{"--resume", &arguments.resume, "", "Continue the earlier run in --out after its last complete step"}});
}

void add_budget_sources(Command& command, SolveArguments& arguments) {
  command.add("Uncertainty",
              {{"--budget", &arguments.budget, "SOURCES",
                "How sure the last step is: noise=20nm, correlation=2um, bandwidth=2um, pitch=1%, height=1%, E=5% and "
                "other words, remove=quadric, missing, shift=2um, window=2, 'maps=b.gsf;c.gsf', grid; separated by commas"}});
}

void add_quiet(Command& command, SolveArguments& arguments) {
  command.add("Output", {{"--quiet", &arguments.quiet, "", "No table and no progress"}});
}

}  // namespace cli

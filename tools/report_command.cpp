#include "report_command.h"

#include "formats/error.h"
#include "platform/files.h"
#include "platform/process.h"
#include "text.h"

namespace cli {

namespace {

// The package of this installation goes before those of Python's path.
constexpr const char* script = R"(import sys
sys.path.insert(0, sys.argv.pop(1))
try:
  from roughcontact.report.command import main
except ImportError as error:
  sys.exit('roughcontact: report needs the Python package roughcontact, which comes with it: ' + str(error))
sys.exit(main(['report', *sys.argv[1:]])))";

}  // namespace

int run_report(const std::vector<std::string>& words) {
  const auto program = rc_platform::path_of(rc_platform::own_program());
  const auto package = program.parent_path().parent_path() / rc_platform::path_of(RC_PYTHON_DIR);
  std::vector<std::string> arguments{"-c", script, package.string()};
  arguments.insert(arguments.end(), words.begin(), words.end());
  const rc_platform::Ended ended = rc_platform::become("python3", arguments);
  if (ended.missing) throw Error("report needs Python 3 (python3), which was not found");
  if (!ended.error.empty()) throw Error("report: python3 does not run: ", ended.error);
  return ended.code;
}

}  // namespace cli

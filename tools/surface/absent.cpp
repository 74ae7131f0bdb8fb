// generate and analyze of a command that is built without libroughcontact-surface, which is under the GPL.
#include "formats/error.h"
#include "surface/analyze_command.h"
#include "surface/generate_command.h"

namespace cli {

namespace {

[[noreturn]] void refuse(const char* command) {
  throw Error(command,
              ": this command was built without libroughcontact-surface, which is under the GPL; in Python's environment: pip "
              "install roughcontact-gpl");
}

}  // namespace

void generate(const std::string&, const GenerateArguments&) { refuse("generate"); }
void analyze(const AnalyzeArguments&) { refuse("analyze"); }

}  // namespace cli

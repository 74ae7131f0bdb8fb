// `roughcontact law`: makes the contact law of a surface, or reads one, and prints, draws and exports it.
#pragma once

#include "exit_code.h"
#include "law/law_arguments.h"

namespace cli {

// Throws an Error for wrong input and failed calls. Nothing is written before the law is made.
ExitCode run_law(LawArguments arguments);

}  // namespace cli

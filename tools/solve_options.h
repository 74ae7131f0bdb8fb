// The options that several commands share. Parsing fills the arguments, which must live as long as the app.
#pragma once

#include "problem.h"

namespace CLI {
class App;
}

namespace cli {

// The surface. rows: only what a process can do that has a part of the rows of a .npy file.
void add_surface(CLI::App& command, SurfaceArguments& surface, const char* missing_help, bool rows = false);
void add_other_body(CLI::App& command, SurfaceArguments& surface);

// Elasticity, loading and boundary; the method.
void add_loading(CLI::App& command, SolveArguments& arguments);
void add_method(CLI::App& command, SolveArguments& arguments, const char* threads_help);

void add_resume(CLI::App& command, SolveArguments& arguments);
void add_quiet(CLI::App& command, SolveArguments& arguments);

}  // namespace cli

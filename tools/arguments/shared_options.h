// The options that several commands share. Parsing fills the arguments, which must live as long as the command.
#pragma once

#include "arguments/command.h"
#include "solve/problem.h"

namespace cli {

// The surface. rows: only what a process can do that has a part of the rows of a .npy file.
void add_surface(Command& command, SurfaceArguments& surface, const char* missing_help, bool rows = false);
void add_other_body(Command& command, SurfaceArguments& surface);
void add_shape(Command& command, SurfaceArguments& surface);

void add_elasticity(Command& command, SolveArguments& arguments);
void add_boundary(Command& command, SolveArguments& arguments);
// Elasticity, loading and boundary; the method.
void add_loading(Command& command, SolveArguments& arguments);
void add_method(Command& command, SolveArguments& arguments,
                const char* threads_help =
                    "Number of threads (default: one for each 16384 points, up to the cores that the "
                    "process may use)");

void add_resume(Command& command, SolveArguments& arguments);
void add_quiet(Command& command, SolveArguments& arguments);

}  // namespace cli

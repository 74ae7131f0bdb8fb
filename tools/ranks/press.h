// `roughcontact-mpi`: a loading history of which every rank has some rows.
#pragma once

#include <optional>
#include <string>

#include "communicator.h"
#include "solve/solve_command.h"

namespace cli {

struct RankArguments {
  SolveArguments solve;
  std::optional<std::string> checkpoint;  // iterations
};

// The same code, or the same Error, on every rank. Rank 0 alone prints.
ExitCode press(const Communicator& ranks, const RankArguments& arguments);

}  // namespace cli

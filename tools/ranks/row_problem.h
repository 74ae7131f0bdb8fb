// The problem of which every rank has some rows.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "communicator.h"
#include "row_files.h"
#include "solve/problem.h"

namespace cli {

struct RowProblem {
  Problem problem;  // without heights; its mask is of this rank's rows
  std::vector<std::uint8_t> mask;
  Rows rows;
  std::vector<double> gap;  // undeformed, of these rows
  std::string checksum;     // of all heights, on rank 0
};

// Reads the rows of this rank. Throws the same Error on every rank.
RowProblem read_problem(const Communicator& ranks, const SolveArguments& arguments);

// These rows of an array that an earlier run of the problem has written.
std::vector<double> read_step_rows(const Communicator& ranks, const std::string& file, const RowProblem& row);

}  // namespace cli

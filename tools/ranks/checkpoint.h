// The pressures in the middle of a step, from which an interrupted run continues: two arrays in turn, and a file that names the
// one that is whole.
#pragma once

#include <optional>
#include <vector>

#include "files/run_folder.h"
#include "row_problem.h"

namespace cli {

class Checkpoint {
 public:
  // run: on rank 0 alone; folder: on every rank.
  Checkpoint(const Communicator& ranks, RunFolder* run, const RowProblem& row, std::filesystem::path folder)
      : ranks_(ranks), run_(run), row_(row), folder_(std::move(folder)) {}

  void write(std::size_t step, std::int64_t iterations, const std::vector<double>& pressure);
  // The iterations after which the pressures were written, which are read; nothing if there are none of this step.
  std::optional<std::int64_t> read(std::size_t step, std::vector<double>& pressure);
  void remove();

 private:
  std::string array_name() const { return second_ ? "checkpoint-b.npy" : "checkpoint-a.npy"; }

  const Communicator& ranks_;
  RunFolder* run_;
  const RowProblem& row_;
  std::filesystem::path folder_;
  bool second_ = false;  // which array is written next
};

}  // namespace cli

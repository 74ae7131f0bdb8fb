// summary.json: the input and every complete step.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "files/json_text.h"
#include "solve/problem.h"

namespace cli {

// Shows whether heights differ from those of another run. It does not protect against manipulation.
class Checksum {
 public:
  void add(std::span<const double> heights);
  void add(std::uint64_t bits);
  std::uint64_t value() const { return sum_; }
  std::string text() const;

 private:
  std::uint64_t sum_ = 0;
};

class Summary {
 public:
  // The summary of a run of this problem. checksum: of the heights.
  Summary(const Problem& problem, const std::string& checksum);
  // The values of a step, as `step_fields` or an earlier summary has them.
  void add(std::span<const JsonEntry> step);
  // removing: steps of an earlier run, 1 to this number, whose files are about to go; 0: none.
  std::string text(std::size_t removing = 0) const;

 private:
  JsonText document_;
};

}  // namespace cli

// A step as the files of --write hold it: fields on the grid, and the numbers of the step.
#pragma once

#include <cstdint>
#include <cstdio>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "files/json_text.h"
#include "solve/contact_measures.h"

namespace cli {

struct Problem;

struct StepImage {
  struct Field {
    const char* name;
    const char* unit;
    const double* values;  // nx x ny, x fastest; NaN where a point is excluded
  };
  struct Number {
    std::string name;  // as in summary.json
    std::string unit;  // "" if it has none
    std::variant<std::int64_t, double, std::string> value;
  };

  std::int64_t nx, ny;
  double hx, hy;  // [m]; point i, j is at ((i + 1/2) hx, (j + 1/2) hy)
  std::vector<Field> fields;
  std::vector<Number> numbers;

  std::size_t points() const { return static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny); }
};

// Borrows the fields. step: as `step_fields` has it.
StepImage make_image(const Problem& problem, std::span<const JsonEntry> step, const Fields& fields);

// Writes a step to the file. Throws an Error.
using StepWriter = void (*)(const StepImage&, std::FILE*);

}  // namespace cli

// `roughcontact analyze`: the numbers of a surface, its spectrum, and whether plain cascade multi-resolution can be trusted on
// it.
#pragma once

#include <optional>
#include <string>

#include "surface/input.h"

namespace cli {

struct AnalyzeArguments {
  GivenWords words;
  std::optional<std::string> levels, approach, json, picture;
};

// Throws an Error for wrong input, failed calls, and files that cannot be written.
void analyze(const AnalyzeArguments& arguments);

}  // namespace cli

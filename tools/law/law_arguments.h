// The arguments of `roughcontact law` as given, and its options.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "arguments/command.h"
#include "solve/problem.h"

namespace cli {

inline constexpr std::string_view law_format_names[] = {"csv", "calculix", "abaqus", "moose", "table"};  // RC_LAW_CSV (1) ..

struct LawArguments {
  SolveArguments contact;  // the patch; its pressure is the range LOWER..UPPER
  std::optional<std::string> tolerance, conductance_tolerance, bulk, max_nodes;
  std::optional<std::string> output, json, picture, at, law_units;
  std::optional<std::string> rows, beyond, conductivity, friction, deck_units;
  std::vector<std::string> exports;  // FORMAT=FILE,...
};

// Parsing fills the arguments, which must live as long as the command.
Command law_command(LawArguments& arguments);

// The first option that was given and is about making a law, which a law that is read has behind it; "" if none.
std::string given_for_making(LawArguments arguments);

}  // namespace cli

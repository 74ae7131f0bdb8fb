// Flow through the gap, by libroughcontact-flow if the command is built with it.
#pragma once

#include <optional>
#include <string>

#include "solve/problem.h"

namespace cli {

// The leak that the word leak asks for, of a result of this system with this mask. None if a signal ended it; throws an Error if
// it fails.
std::optional<rc_flow_result> leak_of(const Problem& problem, const rc_system& system, const std::uint8_t* mask,
                                      const rc_options* options, const rc_result& result);

// "leak along x 7.87e-18 m^3/s, exact at this approach: 7.86e-18 .. 7.88e-18; ..."
std::string line_of(const Problem& problem, const rc_flow_result& leak);

// Searches and prints the pressure of the word closing-pressure. True if its interval is as narrow as usual.
bool search_closing_pressure(const Problem& problem, const rc_options* options);

}  // namespace cli

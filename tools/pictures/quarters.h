// A picture of four panels, two by two, as gnuplot's script.
#pragma once

#include <string>

namespace cli {

// The canvas with a line of text above its panels.
std::string quarters(const std::string& heading);

// Margins, title and labels of a panel: 0 and 1 in the upper row, 2 and 3 below. In the order of their numbers: the heading is
// drawn with panel 0.
std::string quarter(int place, const std::string& title, const std::string& x_label, const std::string& y_label);

}  // namespace cli

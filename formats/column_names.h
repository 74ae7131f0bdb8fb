// Names of columns and lengths with their units: "X [mm]", "Höhe (µm)", "Z/um", "heights in nm".
#pragma once

#include <string_view>
#include <vector>

namespace rc::formats {

enum class Axis { none, x, y, z, all };

struct Label {
  std::string_view name, unit;  // "" if there is none; the unit need not be known
  Axis axis;                    // what the name stands for
};

Label label_of(std::string_view text);

// Whether a unit beside the name is that of the axis: not in "cut-off length [mm]", a length of something else, nor in "x: 5 mm",
// a value.
bool is_clear(const Label& label);

struct Labels {
  std::vector<Label> each;
  char separator = ' ';

  bool all_named() const;  // all stand for an axis
  bool all_clear() const;
  bool all_or_no_units() const;  // of those that stand for an axis
};

// The labels in a line, separated by semicolons, tabs or commas; else by white space or the brackets around their units, if all
// are known names or have known units; else the line is one label.
Labels labels_of(std::string_view line);

// Whether a known unit stands in brackets, or as a word that is not beside a number, somewhere in the line.
bool mentions_unit(std::string_view line);

}  // namespace rc::formats

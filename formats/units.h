// Units of length: their names, those that a file names for its lengths, and the one for lengths without a unit.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include "formats/surface.h"

namespace rc::formats {

// The factor of an SI prefix; 1 for "". Micro is u, U+00B5, U+03BC or Latin-1. Nothing if the text is no prefix.
std::optional<double> prefix_factor(std::string_view prefix);

// Metres per unit: m with any SI prefix, A, angstrom, micron, or a metre spelt out. Nothing if the text is no such length.
std::optional<double> metres_per(std::string_view unit);

// For messages on texts that are none of them.
inline constexpr std::string_view known_lengths = "m with an SI prefix (mm, um, nm, pm), A (angstrom)";

// Throws an Error that begins with `key` if the name is no length.
BareUnit bare_unit(std::string_view key, const std::optional<std::string>& name);

// Throws an Error if the files name a unit for each of their lengths, and one of them is not the unit that was given; and if none
// was given, but a header has a unit of which it is unclear what it belongs to.
void check_units(const BareUnit& unit, std::initializer_list<const Surface*> surfaces);

// The lengths for which the file names no unit, "heights and pitch"; "" if it names all.
std::string bare_lengths(const Surface& surface);

// Whether two pitches are the same: files round them.
bool same_pitch(double a, double b);

// Throws an Error if the file has a pitch, and it is not the one [m] that the caller gives by `option`.
void refuse_another_pitch(std::string_view option, double hx, double hy, const Surface& surface);

}  // namespace rc::formats

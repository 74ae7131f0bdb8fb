// Form removal: subtracts a polynomial of low degree from the heights.
#pragma once

#include "formats/surface.h"

namespace rc::formats {

enum class Form { none, mean, plane, quadric };
inline constexpr std::string_view form_names[] = {"none", "mean", "plane", "quadric"};

// Takes off the least-squares fit over the points that are not missing: mean 1, plane 1 x y, quadric 1 x y x^2 xy y^2.
void remove_form(Form form, Surface& surface);

}  // namespace rc::formats

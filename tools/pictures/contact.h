// contact-K.png: the surface with its contact spots on the left, the pressure on the right.
#pragma once

#include <cstdio>
#include <vector>

#include "pictures/gnuplot.h"
#include "solve/step_record.h"
#include "surface/input.h"

namespace cli {

struct Picture {
  const Pressed& surface;
  const std::vector<double>& pressure;
  const StepRecord& step;
  std::size_t steps;
};

// Draws to the file with gnuplot. Labels take the modulus to be in Pa.
Gnuplot draw_picture(const Picture& picture, std::FILE* file);

}  // namespace cli

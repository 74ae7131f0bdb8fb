// MIRCO's input files: an XML ParameterList, and the topography that it names.
#pragma once

#include <optional>
#include <string>

#include "topography.h"

struct MircoInput {
  Topography topography;
  double lateral_length = 0, delta = 0, tolerance = 0;
  double modulus = 0;  // 1 / ((1 - nu1^2)/E1 + (1 - nu2^2)/E2)
  int max_iteration = 100;
  bool warm_starting = true, pressure_green_function = false;
  std::optional<double> expected_pressure;
};

// A relative topography path counts from the folder of the file. Throws std::runtime_error with file, parameter and what is
// wrong.
MircoInput read_mirco_input(const std::string& path);

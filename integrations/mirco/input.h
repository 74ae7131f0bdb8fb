// MIRCO's input files (YAML), and the surface that they name or describe.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace MIRCO {

struct Heights {
  std::int64_t side = 0;
  std::vector<double> values;  // a row after the other
  std::int64_t extent(int) const { return side; }
  double& operator()(std::int64_t row, std::int64_t column) { return values[static_cast<std::size_t>(row * side + column)]; }
  double operator()(std::int64_t row, std::int64_t column) const { return values[static_cast<std::size_t>(row * side + column)]; }
  double highest() const;
};

// Members have MIRCO's names. The elastic compliance correction is the stiffness of the whole square as a flat punch on its own
// grid.
struct InputParameters {
  // A relative topography path counts from the folder of the file. Throws std::runtime_error with file, parameter and what is
  // wrong.
  explicit InputParameters(const std::string& file);

  Heights topology;
  double lateral_length = 0, grid_size = 0, delta = 0, tolerance = 0;
  double composite_youngs = 0;  // 1 / ((1 - nu1^2)/E1 + (1 - nu2^2)/E2)
  double elastic_compliance_correction = 0;
  int max_iteration = 100;
  bool warm_starting_flag = true, pressure_green_funct_flag = false;
  std::optional<std::string> export_visualization_path;
  std::optional<double> expected_pressure, expected_area_fraction;  // of the section result_description
};

// MIRCO's random midpoint surface, 2^resolution + 1 heights a side, the lowest 0. The bits are MIRCO's if both are compiled with
// the same C++ library, whose default engine and normal distribution they draw from.
Heights random_topography(int resolution, double deviation, double hurst, unsigned seed);

}  // namespace MIRCO

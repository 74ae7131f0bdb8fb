// press_mirco FILE.xml: runs an input file of MIRCO's and prints the mean pressure and the share of the points in contact.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <vector>

#include "evaluate.h"
#include "input.h"

namespace {

struct Heights {
  const Topography& map;
  int numRows() const { return static_cast<int>(map.side); }
  double operator()(int row, int column) const {
    return map.heights[static_cast<std::size_t>(row) * static_cast<std::size_t>(map.side) + static_cast<std::size_t>(column)];
  }
};

// Force over displacement of the whole square as a flat punch, on the same grid: what the half-space below gives way.
double compliance_correction(const MircoInput& input, double pitch) {
  Topography flat = input.topography;
  std::fill(flat.heights.begin(), flat.heights.end(), 0.0);
  double pressure = 0, share = 0;
  const double unlimited = 1e300;
  MIRCO::Evaluate(pressure, share, 1.0, input.lateral_length, pitch, input.tolerance, input.max_iteration, input.modulus, true,
                  unlimited, Heights{flat}, 0.0, {}, input.pressure_green_function);
  return pressure * input.lateral_length * input.lateral_length;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    std::fprintf(stderr, "usage: %s FILE.xml\n", arguments[0]);
    return 2;
  }
  try {
    const MircoInput input = read_mirco_input(arguments[1]);
    const Topography& map = input.topography;
    const double pitch = input.lateral_length / static_cast<double>(map.side);
    const double correction = compliance_correction(input, pitch);
    double pressure = 0, share = 0;
    MIRCO::Evaluate(pressure, share, input.delta, input.lateral_length, pitch, input.tolerance, input.max_iteration,
                    input.modulus, input.warm_starting, correction, Heights{map},
                    *std::max_element(map.heights.begin(), map.heights.end()), {}, input.pressure_green_function);
    std::printf("%lld by %lld points, pitch %.9g, modulus %.9g, shape factor %.9g\n", static_cast<long long>(map.side),
                static_cast<long long>(map.side), pitch, input.modulus, input.lateral_length * input.modulus / correction);
    std::printf("mean pressure %.12e\ncontact area fraction %.12e\n", pressure, share);
    if (input.expected_pressure)
      std::printf("the file expects %.12e: %+.2e of it\n", *input.expected_pressure, pressure / *input.expected_pressure - 1);
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "%s\n", failure.what());
    return 1;
  }
  return 0;
}

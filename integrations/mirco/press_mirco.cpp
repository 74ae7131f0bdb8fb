// press_mirco FILE.yaml: runs an input file of MIRCO's and prints the mean pressure and the share of the points in contact.
#include <cstdio>
#include <exception>

#include "input.h"
#include "mirco_evaluate.h"

int main(int count, char** arguments) {
  if (count != 2) {
    std::fprintf(stderr, "usage: %s FILE.yaml\n", arguments[0]);
    return 2;
  }
  try {
    const MIRCO::InputParameters input(arguments[1]);
    double pressure = 0, share = 0;
    MIRCO::Evaluate(pressure, share, input, input.topology.highest(), {});
    const auto side = static_cast<long long>(input.topology.side);
    std::printf("%lld by %lld points, pitch %.9g, modulus %.9g, shape factor %.9g\n", side, side, input.grid_size,
                input.composite_youngs, input.lateral_length * input.composite_youngs / input.elastic_compliance_correction);
    std::printf("mean pressure %.12e\ncontact area fraction %.12e\n", pressure, share);
    if (input.expected_pressure)
      std::printf("the file expects %.12e: %+.2e of it\n", *input.expected_pressure, pressure / *input.expected_pressure - 1);
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "%s\n", failure.what());
    return 1;
  }
  return 0;
}

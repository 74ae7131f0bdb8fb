// MIRCO::Evaluate against what MIRCO itself finds for its regression tests, and what it says of wrong input.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "input.h"
#include "mirco_evaluate.h"
#include "support/cmocka.hpp"

namespace {

const char *input_file = nullptr, *regression_inputs = nullptr;

// As Kokkos::View<double**, LayoutLeft>: a column after the other, sizes without sign.
class View {
 public:
  explicit View(const MIRCO::Heights& heights) : side_(static_cast<std::size_t>(heights.side)), values_(side_ * side_) {
    for (std::size_t k = 0; k < values_.size(); ++k) values_[k] = heights.values[k % side_ * side_ + k / side_];
  }
  std::size_t extent(int) const { return side_; }
  const double& operator()(int row, int column) const {
    return values_[static_cast<std::size_t>(column) * side_ + static_cast<std::size_t>(row)];
  }

 private:
  std::size_t side_;
  std::vector<double> values_;
};

// As Teuchos::SerialDenseMatrix<int, double>.
struct Matrix {
  View view;
  int numRows() const { return static_cast<int>(view.extent(0)); }
  double operator()(int row, int column) const { return view(row, column); }
};

// Whatever holds the heights, and whether the warm start is asked for.
void takes_heights_in_every_form(void**) {
  const MIRCO::InputParameters input(input_file);
  const double zmax = input.topology.highest();
  double pressure = 0, share = 0;
  MIRCO::Evaluate(pressure, share, input, zmax, {});
  assert_true(pressure > 0 && share > 0 && share < 1);
  const View view(input.topology);
  const auto agrees = [&](bool warm, const auto& topology, const auto& meshgrid) {
    double again = 0, part = 0;
    MIRCO::Evaluate(again, part, input.delta, input.lateral_length, input.grid_size, input.tolerance, input.max_iteration,
                    input.composite_youngs, warm, input.elastic_compliance_correction, topology, zmax, meshgrid,
                    input.pressure_green_funct_flag);
    assert_true(std::abs(again / pressure - 1) < 1e-7);
    assert_true(part == share);
  };
  agrees(false, view, view);
  agrees(true, Matrix{view}, std::vector<double>());
}

// MIRCO's shape factor and pressure, both of commit de05a25, the pressure with its tolerance set to 1e-12.
struct Converged {
  const char* name;
  double shape_factor, pressure;
};

void finds_what_mirco_finds(void**) {
  constexpr Converged all[] = {
      {"sup2", 0.8055133886663757, 6.099801301909947e-03},  {"sup5", 0.8517330207256517, 8.716557392396698e-04},
      {"supN6", 0.8127671025256030, 3.209816849259069e-02}, {"sup6", 0.8583422342031545, 5.947429367525073e-04},
      {"sup7", 0.8701463093314787, 4.529058901269285e-04},  {"sup9", 0.8684174965138375, 1.181226023160202e-03},
  };
  for (const Converged& mirco : all) {
    MIRCO::InputParameters input(regression_inputs + std::string("/input_") + mirco.name + ".yaml");
    const double zmax = input.topology.highest(), stiffness = input.lateral_length * input.composite_youngs;
    double pressure = 0, share = 0;
    MIRCO::Evaluate(pressure, share, input, zmax, {});
    const double expected = pressure / input.expected_pressure.value() - 1,
                 area = share / input.expected_area_fraction.value() - 1;
    const double factor = stiffness / input.elastic_compliance_correction / mirco.shape_factor - 1;
    input.elastic_compliance_correction = stiffness / mirco.shape_factor;
    input.tolerance = 1e-12;
    MIRCO::Evaluate(pressure, share, input, zmax, {});
    print_message("%-5s %3d: expected %+.1e, area %+.1e, shape factor %+.1e; converged %+.1e\n", mirco.name,
                  static_cast<int>(input.topology.side), expected, area, factor, pressure / mirco.pressure - 1);
    assert_true(std::abs(expected) < 1.5e-2);  // its tolerance of .01 counts the change in the last iteration
    assert_true(std::abs(area) < 1e-2);
    assert_true(std::abs(factor) < 1e-8);
    assert_true(std::abs(pressure / mirco.pressure - 1) < 1e-11);
  }
}

void refuses(const char* part, const auto& call) {
  std::string message = "accepted";
  try {
    call();
  } catch (const std::runtime_error& failure) {
    message = failure.what();
  }
  if (message.find(part) == std::string::npos) fail_msg("\"%s\" is not in: %s", part, message.c_str());
}

void says_what_is_wrong_with_an_input(void**) {
  constexpr const char* all[][3] = {
      {"mirco_input:", "mirco_output:", "there is no mirco_input"},
      {"E1: 2", "E1: [2", "no YAML can be read, line "},
      {"E1: 2", "E9: 2", "E1 is missing"},
      {"900.0", "wide", "LateralLength = \"wide\" is not a number"},
      {"Delta: 9.0", "Delta: -9.0", "Delta = -9.0 must be positive"},
      {"MaxIteration: 50", "MaxIteration: 1.5", "MaxIteration = 1.5 must be a whole number"},
      {"GreenFunFlag: true", "GreenFunFlag: maybe", "is neither true nor false"},
      {"RandomTopologyFlag: false", "RandomTopologyFlag: true", "RandomGeneratorSeed is missing"},
      {"RandomTopologyFlag: false", "RandomTopologyFlag: true\n  RandomSeedFlag: true", "RandomSeedFlag = true"},
      {"RandomTopologyFlag: false", "ExportVisualization: true", "no VTK files are written"},
      {"heights.dat", "no-such.dat", "no-such.dat: cannot be opened"},
  };
  for (const auto& [from, to, part] : all) {
    std::ifstream file(input_file);
    std::string text((std::istreambuf_iterator<char>(file)), {});
    text.replace(text.find(from), std::string(from).size(), to);
    std::ofstream("mirco-spoilt.yaml") << text;
    refuses(part, [] { MIRCO::InputParameters{"mirco-spoilt.yaml"}; });
  }
  refuses("no-such.yaml: cannot be opened", [] { MIRCO::InputParameters{"no-such.yaml"}; });
}

void tells_what_it_cannot_do(void**) {
  MIRCO::InputParameters input(input_file);
  double pressure = -1, share = -1;
  const auto evaluated = [&] { MIRCO::Evaluate(pressure, share, input, input.topology.highest(), {}); };
  input.max_iteration = 1;
  refuses("MaxIteration = 1 iterations", evaluated);
  input.export_visualization_path = "pictures";
  refuses("no VTK files are written to pictures", evaluated);
  assert_true(pressure == -1 && share == -1);
}

}  // namespace

int main(int, char** arguments) {
  input_file = arguments[1];
  regression_inputs = arguments[2];
  const CMUnitTest tests[] = {
      cmocka_unit_test(takes_heights_in_every_form),
      cmocka_unit_test(finds_what_mirco_finds),
      cmocka_unit_test(says_what_is_wrong_with_an_input),
      cmocka_unit_test(tells_what_it_cannot_do),
  };
  return cmocka_run_group_tests_name("mirco", tests, nullptr, nullptr);
}

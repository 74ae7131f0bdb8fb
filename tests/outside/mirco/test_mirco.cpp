// MIRCO::Evaluate against a dense solution of its own: Love's coefficients and Gauss-Seidel sweeps, here in full.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include "evaluate.h"
#include "input.h"
#include "support/cmocka.hpp"

namespace {

const char* input_file = nullptr;

struct Heights {
  const Topography& map;
  int numRows() const { return static_cast<int>(map.side); }
  double operator()(int row, int column) const {
    return map.heights[static_cast<std::size_t>(row) * static_cast<std::size_t>(map.side) + static_cast<std::size_t>(column)];
  }
};

// Deflection at (x, y) of unit pressure on a square cell of this side (Love 1929), modulus 1.
double love(double x, double y, double side) {
  const auto term = [](double a, double b) {
    const double r = std::hypot(a, b);
    return a * std::log(b + r) + b * std::log(a + r);
  };
  const double h = side / 2;
  return (term(x + h, y + h) - term(x + h, y - h) - term(x - h, y + h) + term(x - h, y - h)) / std::numbers::pi;
}

struct Reference {
  double force = 0;
  int contacts = 0;
};

// p >= 0, g = H p - (d - h) >= 0, p g = 0.
Reference pressed(const std::vector<double>& gap, int side, double pitch, double modulus, double approach) {
  const std::size_t n = gap.size();
  std::vector<double> table(n), p(n, 0.0);
  const auto at = [&](std::size_t i, std::size_t j) -> double& {
    const auto w = static_cast<std::size_t>(side);
    const std::size_t dx = i % w > j % w ? i % w - j % w : j % w - i % w, dy = i / w > j / w ? i / w - j / w : j / w - i / w;
    return table[dy * w + dx];
  };
  for (std::size_t j = 0; j < n; ++j)
    at(0, j) = love(pitch * static_cast<double>(j % static_cast<std::size_t>(side)),
                    pitch * static_cast<double>(j / static_cast<std::size_t>(side)), pitch) /
               modulus;
  for (double change = 1; change > 1e-14;) {
    change = 0;
    for (std::size_t i = 0; i < n; ++i) {
      double rest = approach - gap[i];
      for (std::size_t j = 0; j < n; ++j)
        if (j != i) rest -= at(i, j) * p[j];
      const double before = p[i];
      p[i] = std::max(0.0, rest / table[0]);
      change = std::max(change, std::abs(p[i] - before) * table[0] / approach);
    }
  }
  Reference result;
  for (const double value : p) {
    result.force += value * pitch * pitch;
    result.contacts += value > 0;
  }
  return result;
}

void finds_what_a_dense_solution_finds(void**) {
  const MircoInput input = read_mirco_input(input_file);
  const Topography& map = input.topography;
  const int side = static_cast<int>(map.side);
  const double pitch = input.lateral_length / side, zmax = *std::max_element(map.heights.begin(), map.heights.end());
  std::vector<double> gap;
  for (const double z : map.heights) gap.push_back(zmax - z);
  const double correction = pressed(std::vector<double>(gap.size(), 0.0), side, pitch, input.modulus, 1).force;

  // d - F(d) / correction = Delta; the left side grows with d.
  double low = input.delta, high = 4 * input.delta;
  Reference expected;
  for (int step = 0; step < 40; ++step) {
    const double middle = (low + high) / 2;
    expected = pressed(gap, side, pitch, input.modulus, middle);
    (middle - expected.force / correction < input.delta ? low : high) = middle;
  }
  const double area = input.lateral_length * input.lateral_length;
  print_message("mean pressure %.12e, area fraction %.12e, shape factor %.9f\n", expected.force / area,
                static_cast<double>(expected.contacts) / (side * side), input.lateral_length * input.modulus / correction);
  for (const bool warm : {false, true}) {
    double pressure = 0, share = 0;
    MIRCO::Evaluate(pressure, share, input.delta, input.lateral_length, pitch, input.tolerance, input.max_iteration,
                    input.modulus, warm, correction, Heights{map}, zmax, {}, input.pressure_green_function);
    assert_true(std::abs(pressure / (expected.force / area) - 1) < 1e-5);
    assert_true(share == static_cast<double>(expected.contacts) / (side * side));
  }
}

std::string refusal_of(const std::string& from, const std::string& to) {
  std::ifstream file(input_file);
  std::string text((std::istreambuf_iterator<char>(file)), {});
  const std::size_t at = text.find(from);
  assert_true(at != std::string::npos);
  text.replace(at, from.size(), to);
  char path[] = "mirco-spoilt.xml";
  std::ofstream(path) << text;
  std::string message = "accepted";
  try {
    read_mirco_input(path);
  } catch (const std::runtime_error& failure) {
    message = failure.what();
  }
  std::remove(path);
  return message;
}

void says_what_is_wrong_with_an_input(void**) {
  const auto expect = [](const char* from, const char* to, const char* part) {
    const std::string message = refusal_of(from, to);
    if (message.find(part) == std::string::npos) fail_msg("\"%s\" is not in: %s", part, message.c_str());
  };
  expect("<ParameterList>", "<Parameters>", "no XML can be read");
  expect("\"E1\"", "\"E9\"", "E1 is missing");
  expect("value=\"900.0\"", "value=\"wide\"", "LateralLength = \"wide\" is not a number");
  expect("value=\"9.0\"", "value=\"-9.0\"", "Delta = -9.0 must be positive");
  expect("\"RandomTopologyFlag\" type=\"bool\" value=\"false\"", "\"RandomTopologyFlag\" type=\"bool\" value=\"true\"",
         "name it in TopologyFilePath");
  expect("heights.dat", "no-such.dat", "no-such.dat: cannot be opened");
}

void tells_when_the_displacement_is_not_reached(void**) {
  const MircoInput input = read_mirco_input(input_file);
  double pressure = -1, share = -1;
  try {
    MIRCO::Evaluate(pressure, share, input.delta, input.lateral_length, input.lateral_length / 9, 1e-8, 1, input.modulus, true,
                    1000, Heights{input.topography}, 26, {}, true);
    fail_msg("accepted");
  } catch (const std::runtime_error& failure) {
    assert_true(std::string(failure.what()).find("MaxIteration = 1 iterations") != std::string::npos);
  }
  assert_true(pressure == -1 && share == -1);
}

}  // namespace

int main(int, char** arguments) {
  input_file = arguments[1];
  const CMUnitTest tests[] = {
      cmocka_unit_test(finds_what_a_dense_solution_finds),
      cmocka_unit_test(says_what_is_wrong_with_an_input),
      cmocka_unit_test(tells_when_the_displacement_is_not_reached),
  };
  return cmocka_run_group_tests_name("mirco", tests, nullptr, nullptr);
}

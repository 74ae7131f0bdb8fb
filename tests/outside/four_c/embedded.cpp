// The two calls that 4C makes into integrations/4c, through an interpreter inside a C++ program: FOLDER has steel.py and
// steel.law.
#include <pybind11/embed.h>

#include <cmath>
#include <cstdio>

namespace py = pybind11;

int main(int, char** argv) {
  const py::scoped_interpreter interpreter;
  py::list path = py::module_::import("sys").attr("path");
  path.insert(0, argv[1]);
  const py::module_ steel = py::module_::import("steel");
  const auto number = [&](const char* function, double gap, double offset) {
    return steel.attr(function)(gap, offset).cast<double>();
  };
  const py::object law = steel.attr("LAW");
  const double most = py::dict(law.attr("info"))["x_upper"].cast<double>(), offset = 0.25 * most;
  int failed = 0;
  for (const double share : {0.01, 0.3, 0.7, 1.0}) {
    const double x = share * most, gap = -x - offset, step = 1e-5 * x;
    const double p = number("evaluate", gap, offset), slope = number("evaluate_derivative", gap, offset);
    const double change = (number("evaluate", gap + step, offset) - number("evaluate", gap - step, offset)) / (2 * step);
    const bool good = std::abs(p / -law(x).cast<double>() - 1) < 1e-9 && p < 0 && std::abs(slope / change - 1) < 1e-3;
    std::printf("overclosure %.3g: %.6g, derivative %.6g, by differences %.6g%s\n", x, p, slope, change, good ? "" : ": wrong");
    failed += !good;
  }
  if (const double open = number("evaluate", 1, 0); open != 0 || std::signbit(open)) ++failed;  // not in contact
  return failed;
}

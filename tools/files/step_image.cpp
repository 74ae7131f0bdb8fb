#include "files/step_image.h"

#include <limits>

#include "files/step_fields.h"
#include "solve/problem.h"

namespace cli {

StepImage make_image(const Problem& problem, std::span<const JsonEntry> step, const Fields& fields) {
  const rc_system& system = problem.system;
  StepImage image{system.nx, system.ny, system.hx, system.hy, {}, {}};
  image.fields = {{"heights", "m", problem.input.surface.heights.data()},
                  {"pressure", "Pa", fields.pressure.data()},
                  {"gap", "m", fields.gap.data()}};
  if (!fields.indentation.empty()) image.fields.push_back({"indentation", "m", fields.indentation.data()});
  for (const JsonEntry& entry : step) {
    StepImage::Number number{std::string(name_of(entry)), std::string(unit_of(name_of(entry))),
                             std::numeric_limits<double>::quiet_NaN()};
    if (const auto* const text = std::get_if<std::string>(&entry.value)) number.value = *text;
    if (const auto* const whole = std::get_if<std::int64_t>(&entry.value)) number.value = *whole;
    if (const auto* const real = std::get_if<double>(&entry.value)) number.value = *real;
    image.numbers.push_back(std::move(number));
  }
  return image;
}

}  // namespace cli

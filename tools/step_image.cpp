#include "step_image.h"

#include <limits>

#include "step_fields.h"

namespace cli {

StepImage make_image(const Problem& problem, std::span<const JsonEntry> step, const Fields& fields) {
  const rc_system& system = problem.system;
  StepImage image{system.nx, system.ny, system.hx, system.hy, {}, {}};
  image.fields = {{"heights", "m", problem.input.surface.heights.data()},
                  {"pressure", "Pa", fields.pressure.data()},
                  {"gap", "m", fields.gap.data()}};
  if (!fields.indentation.empty()) image.fields.push_back({"indentation", "m", fields.indentation.data()});
  for (const JsonEntry& entry : step) {
    StepImage::Number number{std::string(name_of(entry)), std::string(unit_of(name_of(entry))), 0.0};
    const JsonValue& value = entry.value;
    if (value.is_string()) {
      number.value = value.get<std::string>();
    } else if (value.is_number_integer()) {
      number.value = value.get<std::int64_t>();
    } else {
      number.value = value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
    }
    image.numbers.push_back(std::move(number));
  }
  return image;
}

}  // namespace cli

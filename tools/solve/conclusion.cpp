#include "solve/conclusion.h"

#include <algorithm>
#include <cmath>

#include "formats/error.h"
#include "request/units.h"
#include "text.h"

namespace cli {

namespace {

std::string limit(double pressure, double modulus) {
  const auto above = [](const char* body) {
    return format("; warning: above the hardness of %s, this is a purely elastic answer (add --hardness)", body);
  };
#define RC_HARDNESS(hardness, body) \
  if (pressure > hardness) return above(body);
#define RC_SMALL_STRAIN(share) const bool strained = pressure > share * modulus;
#include "solve/elastic_limits.def"
#undef RC_HARDNESS
#undef RC_SMALL_STRAIN
  if (strained)
    return format("; warning: that is %.2g E*, linear elasticity does not hold there (add --hardness)", pressure / modulus);
  return "";
}

// Which part of the contact is at the hardness, and what it carries.
std::string yielding(const rc_system& system, const rc_result& r) {
  const double capped = static_cast<double>(r.capped), load = capped * system.hardness * system.hx * system.hy;
  return format("; %.3g %% of the contact is at the hardness of ", 100 * capped / static_cast<double>(r.contacts)) +
         with_prefix(system.hardness, "Pa") + format(" and carries %.3g %% of the load", 100 * load / r.load);
}

}  // namespace

std::string asked(const Problem& problem, std::size_t step) {
  const double target = problem.targets[step];
  if (problem.control == "area") return format("area %.3g %%", 100 * target);
  if (problem.control == "load") return "load " + with_prefix(target, "N");
  if (problem.control == "pressure") return "mean pressure " + with_prefix(target, "Pa");
  return "approach " + with_prefix(target, "m");
}

std::string reached(const Problem& problem, const StepRecord& step) {
  if (problem.control == "area") return format("%.3g %%", 100 * step.result.area_fraction);
  if (problem.control == "load") return with_prefix(step.result.load, "N");
  if (problem.control == "pressure") return with_prefix(step.result.mean_pressure, "Pa");
  return with_prefix(step.result.approach, "m");
}

std::string remarks(const Problem& problem, const rc_result& r) {
  char text[2048];
  if (rc_request_note(problem.input.request.get(), r.note, r.contacts > 0 ? r.load : 0, sizeof text, text) != RC_OK)
    throw Error(rc_request_last_error());
  return text;
}

std::optional<rc_smooth> smooth_answer(const Problem& problem, const rc_result& r) {
  rc_smooth smooth = RC_SMOOTH_INIT;
  if (rc_request_smooth(problem.input.request.get(), r.load, &smooth) != RC_OK) return std::nullopt;  // no shape, or a layer
  return smooth;
}

std::string smooth_line(const Problem& problem, const rc_result& r) {
  const auto smooth = smooth_answer(problem, r);
  if (!smooth || r.contacts == 0) return "";
  const bool point = std::isfinite(smooth->approach), line = !point && std::isfinite(smooth->max_pressure);
  std::string text = point  ? "Hertz, without roughness: contact radius "
                     : line ? "Hertz, without roughness: contact width "
                            : "without roughness: contact width ";
  text += with_prefix(point ? smooth->width / 2 : smooth->width, "m");
  if (point) text += ", approach " + with_prefix(smooth->approach, "m");
  if (point || line) text += ", largest pressure " + with_prefix(smooth->max_pressure, "Pa");
  return text;
}

std::string conclusion(const Problem& problem, const StepRecord& last) {
  const rc_result& r = last.result;
  std::string line = problem.targets.size() > 1 ? format("step %d of %zu: ", last.number, problem.targets.size()) : "";
  if (!problem.times.empty()) line += format("after %.6g s: ", problem.step_time(static_cast<std::size_t>(last.number - 1)));
  if (!last.good()) {
    line += format("not certified (%s), ", rc_status_name(r.status)) + asked(problem, static_cast<std::size_t>(last.number - 1)) +
            " asked, " + reached(problem, last) + " reached: ";
  }
  if (r.contacts == 0) return line + "load " + with_prefix(r.load, "N") + ", no contact";
  line += format("contact area %.3g %% at ", 100 * r.area_fraction) + with_prefix(r.load, "N");
  const rc_system& system = problem.system;
  if (r.capped > 0) return line + yielding(system, r);
  line += "; largest pressure " + with_prefix(r.max_pressure, "Pa");
  if (system.hardness > 0) return line + ", below the hardness of " + with_prefix(system.hardness, "Pa");
  return line + limit(r.max_pressure, system.modulus);
}

}  // namespace cli

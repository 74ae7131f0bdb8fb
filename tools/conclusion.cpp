#include "conclusion.h"

#include "text.h"
#include "units.h"

namespace cli {

namespace {

// Hardest martensitic steels and single crystals of diamond are below these [Pa].
constexpr double hardest_steel = 10e9, hardest_diamond = 150e9;
constexpr double small_strain = 0.2;  // largest pressure over E*

std::string limit(double pressure, double modulus) {
  if (pressure > hardest_diamond)
    return ", above the hardness of diamond: real bodies yield, the answer is elastic; --hardness bounds it";
  if (pressure > hardest_steel)
    return ", above the hardness of any steel: most bodies yield, the answer is elastic; --hardness bounds it";
  if (pressure > small_strain * modulus)
    return format(", %.2g E*: strains are large, the answer is of small ones", pressure / modulus);
  return "";
}

// Which part of the contact is at the hardness, and what it carries.
std::string yielding(const rc_system& system, const rc_result& r) {
  const double capped = static_cast<double>(r.capped), load = capped * system.hardness * system.hx * system.hy;
  return format("; %.3g %% of the contact is at the hardness of ", 100 * capped / static_cast<double>(r.contacts)) +
         with_prefix(system.hardness, "Pa") + format(" and carries %.3g %% of the load", 100 * load / r.load);
}

}  // namespace

std::string conclusion(const Problem& problem, const StepRecord& last) {
  const rc_result& r = last.result;
  std::string line = problem.targets.size() > 1 ? format("step %d of %zu: ", last.number, problem.targets.size()) : "";
  if (!last.good()) line += format("not certified (%s): ", rc_status_name(r.status));
  if (r.contacts == 0) return line + "nothing carries pressure";
  line += format("%.3g %% of the area carries ", 100 * last.area_fraction()) + with_prefix(r.load, "N");
  const rc_system& system = problem.system;
  if (r.capped > 0) return line + yielding(system, r);
  line += "; largest pressure " + with_prefix(last.measures.max_pressure, "Pa");
  if (system.hardness > 0) return line + ", below the hardness of " + with_prefix(system.hardness, "Pa");
  return line + limit(last.measures.max_pressure, system.modulus);
}

}  // namespace cli

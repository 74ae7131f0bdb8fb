#include "files/summary.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "files/step_fields.h"
#include "solve/budget.h"
#include "text.h"

namespace cli {

namespace {

std::string library_version() {
  int32_t major = 0, minor = 0, patch = 0;
  rc_version(&major, &minor, &patch, nullptr);
  return format("%d.%d.%d", major, minor, patch);
}

// The meaning of x and y in contact_crosses and gap_crosses.
std::string crossing_of(std::int32_t boundary) {
  const bool x = boundary == RC_BOUNDARY_PERIODIC || boundary == RC_BOUNDARY_PERIODIC_X,
             y = boundary == RC_BOUNDARY_PERIODIC || boundary == RC_BOUNDARY_PERIODIC_Y;
  return std::string("along x") + (y ? " with y periodic" : "") + ", along y" + (x ? " with x periodic" : "");
}

}  // namespace

void Checksum::add(std::span<const double> heights) {
  for (const double z : heights) add(std::isnan(z) ? 1 : std::bit_cast<std::uint64_t>(z));
}

void Checksum::add(std::uint64_t bits) {
  sum_ = (sum_ ^ bits) * 0x9e3779b97f4a7c15;
  sum_ ^= sum_ >> 32;
}

std::string Checksum::text() const { return format("%016llx", static_cast<unsigned long long>(sum_)); }

Summary::Summary(const Problem& problem, const std::string& checksum) {
  const rc_system& system = problem.system;
  document_.begin("units");
  document_.add({{"length", "m"}, {"pressure", "Pa"}, {"force", "N"}, {"flow", "m^3/s"}, {"time", "s"}});
  document_.end();
  document_.begin("input");
  document_.add({{"file", problem.input.file},
                 {"format", problem.input.format},
                 {"nx", system.nx},
                 {"ny", system.ny},
                 {"hx", system.hx},
                 {"hy", system.hy},
                 {"removed", problem.input.removed},
                 {"missing", problem.input.missing},
                 {"missing_rule", problem.input.missing_rule},
                 {"checksum", checksum},
                 {"modulus", system.modulus},
                 {"boundary", name_of_boundary(system.boundary)},
                 {"crossing", crossing_of(system.boundary)},
                 {"control", problem.control}});
  if (system.hardness > 0) document_.add("hardness", system.hardness);
  if (system.creep_terms > 0) {
    const auto terms = static_cast<std::size_t>(system.creep_terms);
    document_.begin(system.creep_by == RC_CREEP_MODULI ? "relaxation" : "creep");
    for (const auto& [name, values] : {std::pair{"ratios", &system.creep_ratio}, {"times", &system.creep_time}}) {
      const auto* const first = static_cast<const double*>(values->data);
      document_.add(name, std::vector<double>(first, first + terms));
    }
    document_.end();
  }
  if (!problem.input.against.empty()) document_.add("against", problem.input.against);
  if (problem.view.viscosity > 0)
    document_.add({{"viscosity", problem.view.viscosity},
                   {"pressure_drop", problem.view.pressure_drop},
                   {"leak_along", problem.view.along == 1 ? "x" : "y"}});
  if (!problem.input.shape.empty()) document_.add("shape", problem.input.shape);
  document_.add("assumed", problem.input.assumed);
  document_.begin("words");
  for (const auto& [word, text] : problem.input.words) document_.add(word.c_str(), text);
  document_.end();
  document_.add("targets", problem.targets);
  if (!problem.times.empty()) document_.add("times", problem.times);
  document_.begin("options");
  for (auto option = problem.options.begin(); option != problem.options.end(); ++option) {
    const auto same = [&](const auto& other) { return other.first == option->first; };
    if (std::none_of(option + 1, problem.options.end(), same)) document_.add(option->first.c_str(), option->second);
  }
  document_.end();
  document_.add("library_version", library_version());
  document_.end();
  if (problem.budget) add_budget(*problem.budget, problem.budget_sources, document_);
  document_.begin("steps", '[');
}

std::string Summary::text(std::size_t removing) const {
  if (removing == 0) return document_.text();
  JsonText document = document_;
  document.end();
  document.add("removing", static_cast<std::int64_t>(removing));
  return document.text();
}

void Summary::add(std::span<const JsonEntry> step) {
  document_.begin(nullptr);
  for (const JsonEntry& field : step) document_.add(std::string(name_of(field)).c_str(), field.value);
  document_.end();
}

}  // namespace cli

#include "summary.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "text.h"

namespace cli {

namespace {

std::string library_version() {
  int32_t major = 0, minor = 0, patch = 0;
  rc_version(&major, &minor, &patch, nullptr);
  return format("%d.%d.%d", major, minor, patch);
}

// Shows whether heights differ from those of another run. It does not protect against manipulation.
std::string checksum(const std::vector<double>& heights) {
  std::uint64_t sum = 0;
  for (const double z : heights) {
    sum = (sum ^ (std::isnan(z) ? 1 : std::bit_cast<std::uint64_t>(z))) * 0x9e3779b97f4a7c15;
    sum ^= sum >> 32;
  }
  return format("%016llx", static_cast<unsigned long long>(sum));
}

}  // namespace

Summary::Summary(const Problem& problem) : hardness_(problem.system.hardness > 0) {
  const rc_system& system = problem.system;
  document_.begin("units");
  document_.add({{"length", "m"}, {"pressure", "Pa"}, {"force", "N"}});
  document_.end();
  document_.begin("input");
  document_.add({{"file", problem.input.file},
                 {"format", problem.input.surface.format},
                 {"nx", system.nx},
                 {"ny", system.ny},
                 {"hx", system.hx},
                 {"hy", system.hy},
                 {"removed", problem.input.removed},
                 {"missing", problem.input.missing},
                 {"missing_rule", problem.input.missing_rule},
                 {"checksum", checksum(problem.input.surface.heights)},
                 {"modulus", system.modulus},
                 {"boundary", system.boundary == RC_BOUNDARY_PERIODIC ? "periodic" : "free"},
                 {"control", problem.control}});
  if (hardness_) document_.add("hardness", system.hardness);
  if (!problem.input.against.empty()) document_.add("against", problem.input.against);
  if (!problem.input.shape.empty()) document_.add("shape", problem.input.shape);
  document_.add("targets", problem.targets);
  document_.begin("options");
  for (auto option = problem.options.begin(); option != problem.options.end(); ++option) {
    const auto same = [&](const auto& other) { return other.first == option->first; };
    if (std::none_of(option + 1, problem.options.end(), same)) document_.add(option->first.c_str(), option->second);
  }
  document_.end();
  document_.add("library_version", library_version());
  document_.end();
  document_.begin("steps", '[');
}

void Summary::add(const StepRecord& step) {
  const rc_result& r = step.result;
  document_.begin(nullptr);
  document_.add({{"status", rc_status_name(r.status)},
                 {"approach", r.approach},
                 {"load", r.load},
                 {"mean_pressure", r.mean_pressure},
                 {"area_fraction", step.area_fraction()},
                 {"max_pressure", step.measures.max_pressure},
                 {"mean_gap", step.measures.mean_gap},
                 {"corrected_area", step.measures.corrected_area},
                 {"patches", step.measures.patches},
                 {"largest_patch", step.measures.largest_patch},
                 {"contact_crosses", step.measures.contact.text()},
                 {"gap_crosses", step.measures.gap.text()},
                 {"contacts", r.contacts},
                 {"candidates", r.candidates},
                 {"stiffness", r.stiffness},
                 {"kkt_primal", r.kkt_primal},
                 {"kkt_dual", r.kkt_dual},
                 {"kkt_complementarity", r.kkt_complementarity},
                 {"kkt_control", r.kkt_control},
                 {"iterations", r.iterations},
                 {"applications", r.applications},
                 {"seconds", r.seconds},
                 {"setup_seconds", r.setup_seconds},
                 {"solver", r.solver},
                 {"backend", r.backend},
                 {"kernel", r.kernel},
                 {"points", r.points},
                 {"modelled", r.modelled},
                 {"energy", r.energy},
                 {"duality_gap", r.duality_gap},
                 {"load_lower", r.load_lower},
                 {"load_upper", r.load_upper},
                 {"area_lower", r.area_lower},
                 {"area_upper", r.area_upper},
                 {"stiffness_lower", r.stiffness_lower},
                 {"stiffness_upper", r.stiffness_upper},
                 {"proven_contacts", r.proven_contacts},
                 {"proven_open", r.proven_open},
                 {"undecided", r.undecided},
                 {"tolerance", r.tolerance},
                 {"model_nx", step.accuracy.model_nx},
                 {"model_ny", step.accuracy.model_ny},
                 {"error_estimate", step.accuracy.error_estimate},
                 {"left_out", step.accuracy.left_out},
                 {"area_estimate", step.accuracy.area_estimate},
                 {"note", r.note},
                 {"message", step.message}});
  if (hardness_) document_.add({{"capped", r.capped}, {"plastic_volume", r.plastic_volume}, {"proven_capped", r.proven_capped}});
  document_.end();
}

std::string Summary::text(std::size_t removing) const {
  if (removing == 0) return document_.text();
  JsonText document = document_;
  document.end();
  document.add("removing", removing);
  return document.text();
}

void Summary::add(std::span<const JsonEntry> step) {
  document_.begin(nullptr);
  for (const auto& [place, value] : step) document_.add(place.substr(place.rfind('/') + 1).c_str(), value);
  document_.end();
}

}  // namespace cli

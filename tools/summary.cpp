#include "summary.h"

#include "text.h"

namespace cli {

using Json = nlohmann::ordered_json;  // keys stay in the order in which they are explained

namespace {

std::string library_version() {
  int32_t major = 0, minor = 0, patch = 0;
  rc_version(&major, &minor, &patch, nullptr);
  return format("%d.%d.%d", major, minor, patch);
}

Json input(const Problem& problem) {
  const rc_system& system = problem.system;
  Json options = Json::object();
  for (const auto& [key, text] : problem.options) options[key] = text;
  return {{"file", problem.input.file},
          {"format", problem.input.surface.format},
          {"nx", system.nx},
          {"ny", system.ny},
          {"hx", system.hx},
          {"hy", system.hy},
          {"removed", problem.input.removed},
          {"missing", problem.input.missing},
          {"missing_rule", problem.input.missing_rule},
          {"modulus", system.modulus},
          {"boundary", system.boundary == RC_BOUNDARY_PERIODIC ? "periodic" : "free"},
          {"control", problem.control},
          {"targets", problem.targets},
          {"options", options},
          {"library_version", library_version()}};
}

Json units() {
  return {{"length", "m"},
          {"pressure", "the unit of the modulus: Pa if it was given in Pa"},
          {"force", "pressure m^2: N if the modulus was given in Pa"}};
}

}  // namespace

Summary::Summary(const Problem& problem) : document_{{"units", units()}, {"input", input(problem)}, {"steps", Json::array()}} {}

void Summary::add(const StepRecord& step) {
  const rc_result& r = step.result;
  document_["steps"].push_back({{"status", rc_status_name(r.status)},
                                {"displacement", r.displacement},
                                {"load", r.load},
                                {"mean_pressure", r.mean_pressure},
                                {"area_fraction", step.area_fraction()},
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
                                {"proven_contacts", r.proven_contacts},
                                {"proven_open", r.proven_open},
                                {"undecided", r.undecided},
                                {"tolerance", r.tolerance},
                                {"model_nx", r.model_nx},
                                {"model_ny", r.model_ny},
                                {"error_estimate", r.error_estimate},
                                {"left_out", r.left_out},
                                {"note", r.note},
                                {"message", step.message}});
}

// JSON has no NaN: the writer puts null for what is not finite. File names need not be UTF-8.
std::string Summary::text() const { return document_.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

int Summary::step_count(const std::string& text) {
  const Json document = Json::parse(text, nullptr, false);
  const bool ours =
      document.is_object() && document.contains("input") && document.contains("steps") && document["steps"].is_array();
  return ours ? static_cast<int>(document["steps"].size()) : 0;
}

}  // namespace cli

#include "files/step_fields.h"

#include <iomanip>
#include <sstream>
#include <utility>

#include "solve/conclusion.h"
#include "text.h"

namespace cli {

namespace {

constexpr std::pair<std::string_view, std::string_view> units[] = {{"approach", "m"},
                                                                   {"load", "N"},
                                                                   {"mean_pressure", "Pa"},
                                                                   {"max_pressure", "Pa"},
                                                                   {"mean_gap", "m"},
                                                                   {"stiffness", "N/m"},
                                                                   {"punch_stiffness", "N/m"},
                                                                   {"stiffness_lower", "N/m"},
                                                                   {"stiffness_upper", "N/m"},
                                                                   {"corrected_area", "m^2"},
                                                                   {"area_lower", "m^2"},
                                                                   {"area_upper", "m^2"},
                                                                   {"largest_patch", "m^2"},
                                                                   {"load_lower", "N"},
                                                                   {"load_upper", "N"},
                                                                   {"energy", "N m"},
                                                                   {"duality_gap", "N m"},
                                                                   {"seconds", "s"},
                                                                   {"setup_seconds", "s"},
                                                                   {"left_out", "m"},
                                                                   {"gap_error", "m"},
                                                                   {"plastic_volume", "m^3"},
                                                                   {"leak", "m^3/s"},
                                                                   {"leak_lower", "m^3/s"},
                                                                   {"leak_upper", "m^3/s"},
                                                                   {"constriction", "m"},
                                                                   {"time", "s"},
                                                                   {"smooth_width", "m"},
                                                                   {"smooth_approach", "m"},
                                                                   {"smooth_max_pressure", "Pa"}};

const char* crossed_axes(std::int32_t crosses) {
  if (crosses == RC_CROSSES_X) return "x";
  if (crosses == RC_CROSSES_Y) return "y";
  return crosses == RC_CROSSES_NONE ? "none" : "xy";
}

}  // namespace

std::vector<JsonEntry> step_fields(const StepRecord& step, const Problem& problem) {
  const rc_result& r = step.result;
  std::vector<JsonEntry> fields = {{"status", rc_status_name(r.status)},
                                   {"approach", r.approach},
                                   {"load", r.load},
                                   {"mean_pressure", r.mean_pressure},
                                   {"area_fraction", r.area_fraction},
                                   {"max_pressure", r.max_pressure},
                                   {"mean_gap", r.mean_gap},
                                   {"corrected_area", step.measures.corrected_area},
                                   {"patches", step.measures.patches},
                                   {"largest_patch", step.measures.largest_patch},
                                   {"contact_crosses", crossed_axes(step.measures.contact_crosses)},
                                   {"gap_crosses", crossed_axes(step.measures.gap_crosses)},
                                   {"contacts", r.contacts},
                                   {"candidates", r.candidates},
                                   {"stiffness", r.stiffness},
                                   {"punch_stiffness", r.punch_stiffness},
                                   {"kkt_primal", r.kkt_primal},
                                   {"kkt_dual", r.kkt_dual},
                                   {"kkt_complementarity", r.kkt_complementarity},
                                   {"kkt_control", r.kkt_control},
                                   {"iterations", r.iterations},
                                   {"products", r.products},
                                   {"seconds", r.seconds},
                                   {"setup_seconds", r.setup_seconds},
                                   {"solver", r.solver},
                                   {"backend", r.backend},
                                   {"kernel", r.kernel},
                                   {"points", r.points},
                                   {"modelled", r.modelled},
                                   {"energy", r.energy},
                                   {"duality_gap", r.duality_gap},
                                   {"gap_error", r.gap_error},
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
                                   {"model_nx", r.model_nx},
                                   {"model_ny", r.model_ny},
                                   {"error_estimate", r.error_estimate},
                                   {"left_out", r.left_out},
                                   {"area_estimate", r.area_estimate},
                                   {"note", remarks(problem, r)},
                                   {"message", step.message}};
  if (!problem.times.empty()) fields.push_back({"time", problem.step_time(static_cast<std::size_t>(step.number - 1))});
  if (step.leak) {
    const rc_flow_result& leak = *step.leak;
    fields.insert(fields.end(), {{"leak", leak.flow},
                                 {"leak_lower", leak.lower},
                                 {"leak_upper", leak.upper},
                                 {"constriction", leak.constriction},
                                 {"constriction_x", leak.constriction_x},
                                 {"constriction_y", leak.constriction_y}});
  }
  if (problem.system.hardness > 0) {
    fields.push_back({"capped", r.capped});
    fields.push_back({"plastic_volume", r.plastic_volume});
    fields.push_back({"proven_capped", r.proven_capped});
  }
  if (const auto smooth = smooth_answer(problem, r)) {
    fields.push_back({"smooth_width", smooth->width});
    fields.push_back({"smooth_approach", smooth->approach});
    fields.push_back({"smooth_max_pressure", smooth->max_pressure});
  }
  return fields;
}

std::string_view name_of(const JsonEntry& field) {
  const std::string_view place = field.place;
  return place.substr(place.rfind('/') + 1);  // npos + 1 = 0
}

std::string_view unit_of(std::string_view name) {
  for (const auto& [field, unit] : units) {
    if (field == name) return unit;
  }
  return "";
}

namespace {

// As RFC 4180 has it: a text that could be taken apart stands in quotes, and a quote in it is doubled.
std::string cell(const JsonValue& value) {
  if (!std::holds_alternative<std::string>(value)) {
    const std::string number = dumped(value);
    return number == "null" ? "" : number;  // also if it is not finite
  }
  const auto& text = std::get<std::string>(value);
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::ostringstream quoted;
  quoted << std::quoted(text, '"', '"');
  return quoted.str();
}

}  // namespace

void StepTable::add(std::span<const JsonEntry> step) {
  std::string header = "step", row = std::to_string(++rows_);
  for (const JsonEntry& field : step) {
    const std::string name{name_of(field)}, unit{unit_of(name)};
    header += format(unit.empty() ? ",%s" : ",%s [%s]", name.c_str(), unit.c_str());
    row.append(1, ',').append(cell(field.value));
  }
  if (text_.empty()) text_ = header + "\n";
  text_ += row + "\n";
}

}  // namespace cli

#include "law/law_command.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <tuple>
#include <utility>

#include "files/outputs.h"
#include "formats/error.h"
#include "formats/numbers.h"
#include "law/law_view.h"
#include "law/patch_law.h"
#include "pictures/law.h"
#include "pictures/picture_file.h"
#include "platform/files.h"
#include "request/choices.h"
#include "request/quantities.h"
#include "request/targets.h"
#include "request/units.h"
#include "text.h"

namespace cli {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view law_extension = ".law", law_head = "roughcontact-law ";

struct LawExport {
  std::string option, path;  // "--export csv=steel.csv"
  rc_law_export_spec spec;
};

// The overclosures or pressures of --at.
struct Places {
  bool pressures = false;
  std::vector<double> values{};
};

// Whether the file is a law: by its beginning, or by its name if that is damaged.
bool is_law(const std::string& file) {
  const fs::path path = rc_platform::path_of(file);
  std::error_code none;
  if (path.extension() == law_extension) return true;
  if (!fs::is_regular_file(path, none)) return false;
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream{rc_platform::open_to_read(path), std::fclose};
  std::string head(law_head.size(), '\0');
  return stream && std::fread(head.data(), 1, head.size(), stream.get()) == head.size() && head == law_head;
}

// A message of the library with the command's options instead of the members of its structs.
std::string in_options(std::string message) {
  constexpr std::pair<std::string_view, std::string_view> names[] = {
      {"rc_law_spec.max_nodes", "--max-nodes"},
      {"rc_law_export_spec.length and force", "--deck-units"},
      {"lower p_upper", "lower the upper --pressure"},
      {"beyond double precision", "beyond double precision (--deck-units, --beyond)"}};
  for (const auto& [name, option] : names) {
    if (const auto place = message.find(name); place != std::string::npos) message.replace(place, name.size(), option);
  }
  return message;
}

void check_law(rc_status status, const std::string& subject) {
  if (status < 0) throw Error(subject, subject.empty() ? "" : ": ", in_options(last_message()));
}

double share_or(const char* option, const std::optional<std::string>& text, double least, double most, double otherwise) {
  if (!text) return otherwise;
  const double share = read_quantity(option, *text, Dimension::share).si();
  if (!(share >= least && share <= most))
    throw Error(option, ": ", in_quotes(*text), " must be ", 100 * least, " % .. ", 100 * most, " %");
  return share;
}

std::int64_t whole_between(const char* option, const std::optional<std::string>& text, std::int64_t least, std::int64_t most) {
  if (!text) return 0;
  const auto value = to_integer(*text);
  if (!value || *value < least || *value > most)
    throw Error(option, ": ", in_quotes(*text), " is not a whole number from ", least, " to ", most);
  return *value;
}

LawUnits law_units(const char* option, const std::optional<std::string>& text) {
  if (!text) return {};
  const auto parts = split(*text, ',');
  const auto length = find_unit(parts.front()), force = find_unit(parts.back());
  if (parts.size() != 2 || !length || !force || length->dimension != Dimension::length || force->dimension != Dimension::force)
    throw Error(option, ": ", in_quotes(*text), " is no unit of length and of force, give them as mm,N");
  return {length->factor, force->factor};
}

std::pair<double, double> resistivities(const std::optional<std::string>& text) {
  if (!text) return {0, 0};
  const auto parts = split(*text, ',');
  if (parts.size() > 2) throw Error("--conductivity: ", in_quotes(*text), " has ", parts.size(), " numbers, give K or K1,K2");
  return {1 / positive_number("--conductivity", parts.front()), 1 / positive_number("--conductivity", parts.back())};
}

std::pair<double, double> friction(const std::optional<std::string>& text) {
  if (!text) return {0, 0};
  const auto parts = split(*text, ',');
  const double mu = positive_number("--friction", parts.front()), nu = finite_number("--friction", parts.back());
  if (parts.size() != 2 || !(nu >= 0 && nu <= 0.5))
    throw Error("--friction: ", in_quotes(*text),
                " is no coefficient of friction and Poisson's ratio (0 to 0.5), give them as 0.3,0.3");
  return {mu, nu};
}

std::vector<LawExport> exports_of(const LawArguments& arguments, const LawUnits& units) {
  std::vector<LawExport> found;
  const LawUnits deck = law_units("--deck-units", arguments.deck_units);
  for (const std::string& list : arguments.exports) {
    for (const std::string_view each : split(list, ',')) {
      const auto equals = each.find('=');
      if (equals == std::string_view::npos || equals == 0 || equals + 1 == each.size())
        throw Error("--export: ", in_quotes(each), " has not the form FORMAT=FILE");
      const std::size_t format = choice("--export", each.substr(0, equals), law_format_names);
      rc_law_export_spec spec = RC_LAW_EXPORT_SPEC_INIT;
      spec.format = RC_LAW_CSV + static_cast<int32_t>(format);
      spec.rows = whole_between("--rows", arguments.rows, 5, spec.format == RC_LAW_CALCULIX ? 200 : 1'000'000);
      spec.beyond = arguments.beyond ? finite_number("--beyond", *arguments.beyond) : 0;
      if (arguments.beyond && spec.beyond < 1) throw Error("--beyond: ", in_quotes(*arguments.beyond), " is not 1 or more");
      std::tie(spec.rho1, spec.rho2) = resistivities(arguments.conductivity);
      std::tie(spec.mu, spec.nu) = friction(arguments.friction);
      if (spec.format != RC_LAW_TABLE) {
        spec.length = units.length / deck.length;
        spec.force = units.force / deck.force;
      }
      found.push_back({"--export " + std::string(each), std::string(each.substr(equals + 1)), spec});
    }
  }
  const std::pair<const char*, bool> about_exports[] = {{"--deck-units", arguments.deck_units.has_value()},
                                                        {"--conductivity", arguments.conductivity.has_value()},
                                                        {"--friction", arguments.friction.has_value()},
                                                        {"--rows", arguments.rows.has_value()},
                                                        {"--beyond", arguments.beyond.has_value()}};
  for (const auto& [option, used] : about_exports) {
    if (used && found.empty()) throw Error(option, " is about the tables of --export, which is missing");
  }
  return found;
}

// A law may take long to make.
void check_files(const LawArguments& arguments, const std::vector<LawExport>& exports) {
  std::vector<std::string> inputs{arguments.contact.words.surface};
  if (const auto& against = arguments.contact.words["against"]) inputs.push_back(*against);
  std::vector<std::pair<std::string, std::string>> outputs;
  for (const auto& [option, path] : {std::pair{"--output", &arguments.output}, std::pair{"--json", &arguments.json},
                                     std::pair{"--picture", &arguments.picture}}) {
    if (*path) outputs.emplace_back(option, **path);
  }
  for (const LawExport& each : exports) outputs.emplace_back(each.option, each.path);
  check_outputs(inputs, outputs);
}

void set_bulk(const std::optional<std::string>& text, const rc_system& system, rc_law_spec& spec) {
  constexpr std::string_view names[] = {"auto", "none", "mean"};
  if (!text) return;
  if (const auto stiffness = leading_number(*text)) {
    if (!(stiffness->first > 0) || (!stiffness->second.empty() && trimmed(stiffness->second) != "N/m"))
      throw Error("--bulk: ", in_quotes(*text), " is not a positive stiffness in N/m");
    spec.bulk = RC_LAW_BULK_GIVEN;
    spec.bulk_stiffness = stiffness->first;
    return;
  }
  const std::size_t place = choice("--bulk", *text, names);
  spec.bulk = place == 2 ? RC_LAW_BULK_MEAN : static_cast<int32_t>(place);
  if (place == 2 && system.boundary != RC_BOUNDARY_FREE)
    throw Error("--bulk: mean is for --boundary free, and the approach of this boundary is the change of the mean gap already");
}

PatchLaw make_law(const LawArguments& arguments) {
  if (arguments.law_units) throw Error("--law-units is for a law that is read, and this command makes laws in m and N");
  rc_law_spec spec = RC_LAW_SPEC_INIT;
  spec.tolerance = share_or("--tolerance", arguments.tolerance, 1e-6, 0.1, spec.tolerance);
  spec.tolerance_conductance = share_or("--conductance-tolerance", arguments.conductance_tolerance, 1e-4, 1, 0);
  spec.max_nodes = whole_between("--max-nodes", arguments.max_nodes, 3, 10'000'000);
  const Problem problem = make_problem(arguments.contact, RC_CALL_LAW);
  spec.p_lower = problem.targets.front();
  spec.p_upper = problem.targets.back();
  set_bulk(arguments.bulk, problem.system, spec);
  const std::span<const double> heights = problem.input.surface.heights;
  std::vector<double> gap(heights.size());
  check(rc_gap_from_heights(std::ssize(gap), RC_IN(heights.data()), RC_IN(problem.input.mask), RC_OUT(gap.data())), "");
  spec.undeformed_gap = RC_IN(gap.data());
  spec.mask = RC_IN(problem.input.mask);
  Context context;
  const Options options = make_options(context, default_threads(problem.system.nx * problem.system.ny), problem.options);
  PatchLaw law;
  rc_law* handle = nullptr;
  law.status = rc_law_create(&problem.system, options.get(), &spec, &handle);
  law.handle.reset(handle);
  check_law(law.status, law.status == RC_ERR_INFEASIBLE ? "--pressure" : "");
  if (law.status > 0) law.remark = in_options(last_message());
  for (const std::string& note : problem.input.notes) report(note);
  law.asked_conductance = spec.tolerance_conductance;
  context.report_log();
  law.assumed = problem.input.assumptions();
  law.source = rc_platform::path_of(problem.input.file).filename().string() +
               format(", %lld x %lld points, pitch ", static_cast<long long>(problem.system.nx),
                      static_cast<long long>(problem.system.ny)) +
               with_prefix(problem.system.hx, "m", 4) +
               (problem.system.hx != problem.system.hy ? " x " + with_prefix(problem.system.hy, "m", 4) : "") +
               problem.input.preparation();
  return law;
}

PatchLaw read_law(const LawArguments& arguments) {
  const std::string& file = arguments.contact.words.surface;
  if (const std::string option = given_for_making(arguments); !option.empty())
    throw Error(option, " is about making a law, and ", in_quotes(file), " is one already");
  PatchLaw law;
  law.units = law_units("--law-units", arguments.law_units);
  rc_law* handle = nullptr;
  law.status = rc_law_load(file.c_str(), &handle);
  law.handle.reset(handle);
  check_law(law.status, "");
  if (law.status > 0) law.remark = in_options(last_message());
  law.source = rc_platform::path_of(file).filename().string();
  return law;
}

Places places_of(const LawArguments& arguments) {
  if (!arguments.at) return {};
  const bool pressures = arguments.at->find("Pa") != std::string::npos;
  const auto& unit = arguments.contact.words["unit"];
  Places places{pressures};
  for (const Quantity& each : read_targets("--at", *arguments.at, pressures ? Dimension::pressure : Dimension::length,
                                           pressures ? 1 : length_unit("--unit", unit ? unit->c_str() : nullptr)))
    places.values.push_back(each.si());
  return places;
}

std::vector<LawRow> rows_at(const PatchLaw& law, const Places& places) {
  constexpr int usual_rows = 9;
  if (places.values.empty()) return law.rows(usual_rows);
  std::vector<LawRow> rows;
  for (const double value : places.values) rows.push_back(places.pressures ? law.row_at_pressure(value) : law.row(value));
  return rows;
}

// Whether everything asked for is proven; reports what is not.
bool all_proven(const PatchLaw& law, const std::vector<LawRow>& rows) {
  if (law.asked_conductance > 0 && law.info.width_conductance > law.asked_conductance)
    report(
        format("note: the conductance is within %.2g %% somewhere, not within the %.2g %% of --conductance-tolerance: the slope "
               "jumps where points touch, and more nodes do not narrow a jump",
               100 * law.info.width_conductance, 100 * law.asked_conductance));
  if (law.status > 0) report(format("the law is not certified (%s): ", rc_status_name(law.status)) + law.remark);
  const auto outside = std::ranges::find_if(rows, &LawRow::beyond);
  if (outside == rows.end()) return law.status == RC_OK;
  report("--at: " + with_prefix(outside->at.x, "m", 4) + " is beyond the law, which ends at " +
         with_prefix(law.info.x_upper * law.units.length, "m", 4) + ": its last tangent goes on, and nothing is proven there");
  return false;
}

}  // namespace

ExitCode run_law(LawArguments arguments) {
  const bool known = is_law(arguments.contact.words.surface);
  const std::vector<LawExport> exports =
      exports_of(arguments, known ? law_units("--law-units", arguments.law_units) : LawUnits{});
  const Places places = places_of(arguments);
  check_files(arguments, exports);
  PatchLaw law = known ? read_law(arguments) : make_law(arguments);
  check(rc_law_describe(law.handle.get(), &law.info), "");
  const std::vector<LawRow> rows = rows_at(law, places);

  if (arguments.output) check_law(rc_law_save(law.handle.get(), arguments.output->c_str()), "--output");
  for (LawExport each : exports) {
    check_law(rc_law_export(law.handle.get(), each.path.c_str(), &each.spec), each.option);
    if (!arguments.contact.quiet && each.spec.format != RC_LAW_TABLE)
      report(format("note: straight lines between the rows of %s are within %.2g %% of the law", each.path.c_str(),
                    100 * each.spec.error));
  }
  if (arguments.json) write_output(rc_platform::path_of(*arguments.json), law_document(law, rows));
  if (arguments.picture) write_picture(*arguments.picture, [&](std::FILE* file) { return draw_law(law, file); });
  if (!arguments.contact.quiet) print_law(law, rows);
  return all_proven(law, rows) ? exit_certified : exit_uncertified;
}

}  // namespace cli

#include "list_commands.h"

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "formats/registry.h"
#include "library.h"
#include "platform/libraries.h"
#include "text.h"

namespace cli {

namespace {

using Row = std::vector<std::string>;

// Columns as wide as their widest entry; a column without entries is left out.
void print_rows(const std::vector<Row>& rows) {
  std::vector<std::size_t> widths(rows.front().size());
  for (std::size_t c = 0; c < widths.size(); ++c) {
    const bool used = std::any_of(rows.begin() + 1, rows.end(), [&](const Row& row) { return !row[c].empty(); });
    for (const Row& row : rows) widths[c] = std::max(widths[c], used ? row[c].size() : 0);
  }
  for (const Row& row : rows) {
    std::string line;
    for (std::size_t c = 0; c < widths.size(); ++c) {
      if (widths[c] > 0) line += row[c] + std::string(widths[c] - row[c].size() + 2, ' ');
    }
    std::printf("%s\n", line.substr(0, line.find_last_not_of(' ') + 1).c_str());
  }
}

void list_components(int32_t kind) {
  Context context;
  std::vector<Row> rows{{"name", "summary", "license", "origin"}};
  for (const rc_component& each : components(context, kind)) rows.push_back({each.name, each.summary, each.license, each.origin});
  context.report_log();
  print_rows(rows);
  if (!rc_platform::loads_plugins()) report("this command is linked statically and loads no plugins; these are all it has");
}

std::string type_name(int32_t type) {
  if (type == RC_TYPE_INT) return "int";
  return type == RC_TYPE_REAL ? "real" : "text";
}

std::string allowed_values(const rc_component& option) {
  if (option.type == RC_TYPE_TEXT) return option.choices ? option.choices : "";
  return format("%g .. %g", option.minimum, option.maximum);
}

}  // namespace

void list_backends() { list_components(RC_COMPONENT_BACKEND); }
void list_solvers() { list_components(RC_COMPONENT_SOLVER); }
void list_kernels() { list_components(RC_COMPONENT_KERNEL); }

std::vector<Row> option_rows() {
  Context context;
  std::vector<Row> rows;
  for (const rc_component& each : components(context, RC_COMPONENT_OPTION))
    rows.push_back({each.name, type_name(each.type), each.default_value, allowed_values(each), each.summary});
  context.report_log();
  return rows;
}

void list_options() {
  std::vector<Row> rows = option_rows();
  rows.insert(rows.begin(), {"key", "type", "default", "allowed", "meaning"});
  print_rows(rows);
}

void list_formats() {
  std::vector<Row> rows{{"name", "summary", "extensions", "recognised by", "the file says"}};
  for (const Format& f : surface_formats()) {
    rows.push_back({std::string(f.name), std::string(f.summary), std::string(f.extensions), f.matches ? "contents" : "extension",
                    std::string(f.lengths)});
  }
  print_rows(rows);
}

}  // namespace cli

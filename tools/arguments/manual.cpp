#include "arguments/manual.h"

#include <algorithm>

#include "core/text.h"
#include "list_commands.h"
#include "text.h"

namespace cli {

namespace {

constexpr const char* ending = R"(.SH ENVIRONMENT
.TP
.B RC_PLUGIN_PATH
Absolute directories, separated by colons, that are searched for backends and solvers (files rcb_NAME.so) before the installed
ones.
.SH SEE ALSO
.BR gnuplot (1),
which draws the pictures.
)";

// Text that troff leaves as it is.
std::string plain(std::string_view text) {
  std::string found = text.starts_with('.') || text.starts_with('\'') ? "\\&" : "";
  for (const char c : text) found += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
  return found;
}

std::string tagged(std::string_view name, std::string_view meaning) {
  return rc::join(".TP\n.B ", plain(name), "\n", plain(meaning), "\n");
}

std::string entry(const Option& option) {
  const bool required = std::holds_alternative<std::string*>(option.target);
  const std::string type = option.type;
  return tagged(option.name + (type.empty() ? "" : " " + type) + (required ? " REQUIRED" : ""), option.help);
}

std::string options_of(const Command& command) {
  std::vector<std::string_view> groups;
  for (const Option& option : command.options) {
    if (std::ranges::count(groups, option.group) == 0) groups.push_back(option.group);
  }
  std::string text;
  for (const std::string_view group : groups) {
    if (group != "Options") text += rc::join(".PP\n.I ", plain(group), "\n");
    for (const Option& option : command.options) text += option.group == group ? entry(option) : "";
  }
  return text;
}

// The last paragraphs of --help, without those that an earlier command has.
std::string footer_of(const Command& command, std::vector<std::string>& known) {
  std::string text;
  std::string_view rest = command.footer;
  while (!rest.empty()) {
    const std::string_view paragraph = rest.substr(0, rest.find("\n\n"));
    rest.remove_prefix(std::min(paragraph.size() + 2, rest.size()));
    if (std::ranges::count(known, trimmed(paragraph)) > 0) continue;
    known.emplace_back(trimmed(paragraph));
    text += ".PP\n" + plain(known.back()) + "\n";
  }
  return text;
}

std::string section(const Command& command, const std::string& path, std::vector<std::string>& known) {
  std::string usage = "roughcontact " + path + " [OPTIONS]" + (command.commands.empty() ? "" : " SUBCOMMAND");
  for (const Option& option : command.options) usage += option.name[0] == '-' ? "" : std::string(" ") + option.name;
  std::string text = rc::join(".SS \"", plain(path), "\"\n", plain(command.help), ".\n.PP\n.B ", plain(usage), "\n");
  text += options_of(command) + footer_of(command, known);
  for (const Command& below : command.commands) text += section(below, path + " " + below.name, known);
  return text;
}

}  // namespace

std::string manual(const Command& command) {
  std::string summary = command.help;
  summary[0] = lower_case(summary.substr(0, 1))[0];
  std::string text = rc::join(".TH ROUGHCONTACT 1 \"\" \"", command.version.substr(0, command.version.find(" (")),
                              "\" \"User Commands\"\n.SH NAME\nroughcontact \\- ", plain(summary),
                              "\n.SH SYNOPSIS\n.B roughcontact [OPTIONS] [SUBCOMMAND]\n.SH COMMANDS\n");
  std::string lists = ".SS \"What the library has\"\n";
  std::vector<std::string> known;
  for (const Command& below : command.commands) {
    if (below.options.empty() && below.commands.empty()) {
      lists += tagged(below.name, below.help);
    } else {
      text += section(below, below.name, known);
    }
  }
  text += lists + ".SH OPTIONS\n" + tagged("-h,--help", "Print this help message and exit") +
          tagged("--version", "Display program version information and exit") +
          ".SH LIBRARY OPTIONS\nFor\n.BR \\-\\-set ,\nwith type, default and values.\n";
  for (const auto& row : option_rows()) {
    const std::string value = row[2].empty() ? "empty" : row[2], allowed = row[3].empty() ? "" : ", " + row[3];
    text += rc::join(".TP\n.BR ", plain(row[0]), " \" (", plain(row[1] + ", " + value + allowed), ")\"\n", plain(row[4]), "\n");
  }
  return text + ending;
}

}  // namespace cli

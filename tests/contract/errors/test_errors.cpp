// Runs table.txt, the table of bad input: the documented status, a message that says what is wrong, nothing written, nothing
// printed. With --document, prints the table and the list of statuses of which docs/development/errors.md shows the messages.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <optional>

#include "calls.h"

namespace {

using namespace errors;

struct Row {
  std::string section, input, status;
  std::vector<std::string> says;   // parts of the message, in this order
  std::vector<std::string> words;  // the call, and what spoils it
  std::string plugin;              // a backend that must be there as a plugin, else the row is skipped
};

std::vector<std::string> split(const std::string& text, const std::string& by) {
  std::vector<std::string> parts;
  for (std::size_t from = 0, at; from <= text.size(); from = at + by.size()) {
    at = std::min(text.find(by, from), text.size());
    if (at > from) parts.push_back(text.substr(from, at - from));
  }
  return parts;
}

std::vector<Row> table() {
  std::ifstream file(RC_ERRORS_TABLE);
  std::vector<Row> rows;
  std::string section;
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("= ", 0) == 0) section = line.substr(2);
    if (line.empty() || line[0] == '#' || line[0] == '=') continue;
    const std::vector<std::string> cells = split(line, " | ");
    if (cells.size() < 3) fail_msg("%s: not a row", line.c_str());
    const bool silent = cells[1] == "RC_OK";
    Row row{section, cells[0], cells[1], {}, split(cells[silent ? 2 : 3], " "), cells.size() > 4 ? cells[4] : ""};
    if (!silent) row.says = split(cells[2], " ... ");
    // Where addresses have 32 bits such a grid is beyond what they can count.
    if (sizeof(void*) < 8 && row.status == "RC_ERR_MEMORY") row.status = "RC_ERR_SHAPE", row.says = {"is more than"};
    rows.push_back(row);
  }
  return rows;
}

const Calls& all_calls() {
  static const Calls all = [] {
    Calls joined;
    for (Calls each : {calls(), contact_calls(), history_calls(), derivative_calls(), plugin_calls()}) joined.merge(each);
    return joined;
  }();
  return all;
}

// Sends standard output and error to a file while it lives.
class Silence {
 public:
  Silence() : file_(open("errors_output.txt", O_RDWR | O_CREAT | O_TRUNC, 0600)) {
    std::fflush(nullptr);
    for (int stream : {1, 2}) {
      saved_[stream - 1] = dup(stream);
      dup2(file_, stream);
    }
  }
  ~Silence() {
    restore();
    close(file_);
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

  // Bytes that were printed.
  std::int64_t restore() {
    std::fflush(nullptr);
    for (int stream : {1, 2}) {
      if (saved_[stream - 1] < 0) continue;
      dup2(saved_[stream - 1], stream);
      close(saved_[stream - 1]);
      saved_[stream - 1] = -1;
    }
    struct stat info {};
    return fstat(file_, &info) == 0 ? info.st_size : -1;
  }

 private:
  int file_;
  int saved_[2] = {-1, -1};
};

std::optional<Silence> silence;  // ended by end_silence if a test fails within it

int end_silence(void**) {
  silence.reset();
  return 0;
}

bool has_plugin(const char* name) {
  for (std::int64_t i = 0; i < rc_component_count(nullptr, RC_COMPONENT_BACKEND); ++i) {
    rc_component component{};
    component.struct_size = sizeof component;
    if (rc_component_describe(nullptr, RC_COMPONENT_BACKEND, i, &component) == RC_OK && std::strcmp(component.name, name) == 0)
      return std::strcmp(component.origin, "built-in") != 0;
  }
  return false;
}

void run(void** state) {
  const Row& row = *static_cast<const Row*>(*state);
  if (!row.plugin.empty() && !has_plugin(row.plugin.c_str())) skip();
  const auto call = all_calls().find(row.words[0]);
  if (call == all_calls().end()) fail_msg("%s: no such call", row.words[0].c_str());
  answer().prepare();
  World world;
  for (std::size_t i = 1; i < row.words.size(); ++i) world.set(row.words[i]);
  world.begin_call();
  silence.emplace();
  const Outcome outcome = call->second(world);
  const std::int64_t printed = silence->restore();
  if (rc_status_name(outcome.status) != row.status)
    fail_msg("%s: %s, expected %s; message: %s", row.input.c_str(), rc_status_name(outcome.status), row.status.c_str(),
             outcome.message.c_str());
  std::size_t from = 0;
  for (const std::string& part : row.says) {
    const std::size_t found = outcome.message.find(part, from);
    if (found == std::string::npos) fail_msg("message: %s\nlacks:   %s", outcome.message.c_str(), part.c_str());
    from = found + part.size();
  }
  assert_int_equal(outcome.message.empty(), outcome.status == RC_OK);
  if (outcome.status < 0) {
    assert_true(answer().untouched());
    world.check_untouched();
  }
  assert_int_equal(printed, 0);
}

// Bars would end a table's cell.
std::string cell(const std::string& text) {
  std::string escaped;
  for (const char letter : text) {
    if (letter == '|') escaped += '\\';
    escaped += letter;
  }
  return escaped;
}

void print_document() {
  std::printf("## Statuses\n\n| value | name | meaning |\n|---:|---|---|\n");
  for (rc_status status = RC_WITHIN_GOAL; status >= RC_ERR_INTERNAL; --status)
    if (std::strcmp(rc_status_name(status), "RC_STATUS_UNKNOWN") != 0)
      std::printf("| %d | `%s` | %s |\n", static_cast<int>(status), rc_status_name(status), rc_status_text(status));
  std::string section;
  for (const Row& row : table()) {
    if (row.section != section) std::printf("\n## %s\n\n| input | status | message |\n|---|---|---|\n", row.section.c_str());
    section = row.section;
    std::string says;
    for (const std::string& part : row.says) says += (says.empty() ? "`" : " ... ") + part;
    if (!says.empty()) says += '`';
    std::printf("| %s | `%s` | %s |\n", cell(row.input).c_str(), row.status.c_str(), cell(says).c_str());
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count == 2 && std::strcmp(arguments[1], "--document") == 0) {
    print_document();
    return 0;
  }
  std::vector<Row> rows = table();
  std::vector<CMUnitTest> tests;
  for (Row& row : rows) tests.push_back({row.input.c_str(), run, nullptr, end_silence, &row});
  return _cmocka_run_group_tests("errors", tests.data(), tests.size(), nullptr, nullptr);
}

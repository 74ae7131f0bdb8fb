// Runs the table of bad input: the documented status, a message that says what is wrong, nothing written, nothing printed.
// With --document, prints the table and the list of statuses of which docs/development/errors.md shows the messages.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>

#include "case.h"
#include "scene.h"

namespace {

using namespace errors;

std::vector<Section> table() {
  return {null_pointers(),   struct_sizes(), shapes(),      values(),         dense_matrices(), callbacks(), steps(),
          options(),         names(),        plugins(),     order_of_calls(), paths(),          restores(),  batches(),
          direct_routines(), analyses(),     derivatives(), laws(),           products()};
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
  const Case& each = *static_cast<const Case*>(*state);
  if (each.plugin && !has_plugin(each.plugin)) skip();
  answer().prepare();
  Silence silence;
  const Outcome outcome = each.call();
  const std::int64_t printed = silence.restore();
  if (outcome.status != each.status)
    print_error("%s: %s, expected %s; message: %s\n", each.input, rc_status_name(outcome.status), rc_status_name(each.status),
                outcome.message.c_str());
  assert_int_equal(outcome.status, each.status);
  std::size_t from = 0;
  for (const std::string& part : each.says) {
    const std::size_t found = outcome.message.find(part, from);
    if (found == std::string::npos) print_error("message: %s\nlacks:   %s\n", outcome.message.c_str(), part.c_str());
    assert_true(found != std::string::npos);
    from = found + part.size();
  }
  assert_int_equal(outcome.message.empty(), each.status == RC_OK);
  if (each.status < 0) assert_true(answer().untouched());
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
  for (const Section& section : table()) {
    std::printf("\n## %s\n\n| input | status | message |\n|---|---|---|\n", section.title);
    for (const Case& each : section.cases) {
      std::string says;
      for (const std::string& part : each.says) {
        if (!says.empty()) says += " ... ";
        says += part;
      }
      const char* const quote = says.empty() ? "" : "`";
      std::printf("| %s | `%s` | %s%s%s |\n", cell(each.input).c_str(), rc_status_name(each.status), quote, cell(says).c_str(),
                  quote);
    }
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count == 2 && std::strcmp(arguments[1], "--document") == 0) {
    print_document();
    return 0;
  }
  std::vector<Section> sections = table();
  std::vector<CMUnitTest> tests;
  for (Section& section : sections)
    for (Case& each : section.cases) tests.push_back({each.input, run, nullptr, nullptr, &each});
  return _cmocka_run_group_tests("errors", tests.data(), tests.size(), nullptr, nullptr);
}

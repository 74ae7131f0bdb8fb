// The schema of the options made into runs: each value in each option for each kind of system, in a process of its own with
// limits of memory and time. Every run ends with an answer or an error that says why.
//
// test_options [KEY]     all, or one key
#include <roughcontact/registry.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <random>
#include <string>
#include <utility>

#include "support/cmocka.hpp"
#include "support/system.h"
#include "values.h"

namespace {

using namespace options;
namespace fs = std::filesystem;

#ifdef RC_SANITIZED
constexpr std::size_t most_memory = 0;  // no limit
#else
constexpr std::size_t most_memory = std::size_t{2} << 30;  // [bytes]
#endif
constexpr unsigned most_seconds = 10;  // of processor time for one value: solves that take milliseconds
const char* program = nullptr;

struct Case {
  std::string key, kind, name;
};

// Printed before it is tried, so that it is the last line where the process ends there.
void announce(const Option& option, const std::string& value) {
  std::printf("%s = \"%.60s\"\n", option.key.c_str(), value.c_str());
  std::fflush(stdout);
  support::limit_processor_time(most_seconds);
}

rc_options* fresh_options(rc_context* context, const Option& option, const Names& names) {
  rc_options* handle = nullptr;
  if (rc_options_create(context, &handle) != RC_OK) return nullptr;
  const std::string owner = option.owner();
  const auto has = [&](const std::vector<std::string>& list) { return std::find(list.begin(), list.end(), owner) != list.end(); };
  if (has(names.backends)) rc_options_set_text(handle, RC_OPT_BACKEND, owner.c_str());
  if (has(names.solvers)) rc_options_set_text(handle, RC_OPT_SOLVER, owner.c_str());
  rc_options_set_number(handle, RC_OPT_TIME_LIMIT, 5);
  return handle;
}

// One option on one kind of system; what is wrong is printed, "ok" where nothing is.
int run(const char* key, const char* kind) {
  support::limit_process(most_memory, 300);
  rc_context* const context = make_context();
  const Names names = all_names(context);
  const std::vector<Option> all = all_options(context);
  const auto option = std::find_if(all.begin(), all.end(), [&](const Option& each) { return each.key == key; });
  if (option == all.end()) return 1;
  const Values values = values_of(*option, names);
  const bool memory = option->key.ends_with("memory_limit") || option->key == RC_OPT_THREADS;  // of stacks
  for (const std::string& value : values.inside) {
    announce(*option, value);
    rc_options* const handle = fresh_options(context, *option, names);
    const rc_status set = rc_options_set_text(handle, key, value.c_str());
    const bool refused = set != RC_OK && option->type == RC_TYPE_TEXT && *rc_last_error() != '\0';
    const std::string fault = set == RC_OK ? judge(kind, handle, memory)
                              : refused    ? ""
                                           : "refused: " + std::string(rc_last_error());
    rc_options_destroy(handle);
    if (fault.empty()) continue;
    std::printf("%s\n", fault.c_str());
    return 1;
  }
  for (const std::string& value : values.outside) {
    announce(*option, value);
    rc_options* const handle = fresh_options(context, *option, names);
    const bool refused = rc_options_set_text(handle, key, value.c_str()) == RC_ERR_OPTION && std::strstr(rc_last_error(), key);
    rc_options_destroy(handle);
    if (refused) continue;
    std::printf("not refused\n");
    return 1;
  }
  rc_context_destroy(context);
  std::printf("ok\n");
  return 0;
}

struct Ended {
  int status = 0;
  std::string last;  // line that it printed
};

Ended run_apart(const Case& one) {
  const std::string command = std::string("\"") + program + "\" --run " + one.key + " " + one.kind;
  Ended ended;
  std::FILE* const output = popen(command.c_str(), "r");
  if (!output) return {-1, "popen"};
  char line[1000];
  std::string before;
  while (std::fgets(line, sizeof line, output)) {
    before = std::exchange(ended.last, line);
  }
  ended.status = pclose(output);
  if (ended.status != 0) ended.last = before + ended.last;
  return ended;
}

void ends_within_its_limits(void** state) {
  const Case& one = *static_cast<const Case*>(*state);
  const Ended ended = run_apart(one);
  if (ended.status != 0 || ended.last != "ok\n")
    fail_msg("%s: ended with %d after: %s", one.name.c_str(), ended.status, ended.last.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 4 && std::strcmp(argv[1], "--run") == 0) return run(argv[2], argv[3]);
  const std::string absolute = fs::absolute(argv[0]).string();
  const char* const emulated = std::getenv("RC_TEST_SELF");  // what starts this program under an emulator
  program = emulated ? emulated : absolute.c_str();
  // Texts may name files that are written.
  const fs::path before = fs::current_path(), scratch = before / ("options-" + std::to_string(std::random_device()()));
  fs::create_directory(scratch);
  fs::current_path(scratch);

  std::vector<Case> cases;
  rc_context* const context = make_context();
  for (const Option& option : all_options(context))
    for (const char* kind : kinds)
      if (argc < 2 || option.key == argv[1]) cases.push_back({option.key, kind, option.key + ", " + kind});
  rc_context_destroy(context);
  std::vector<CMUnitTest> tests;
  for (Case& one : cases) tests.push_back({one.name.c_str(), ends_within_its_limits, nullptr, nullptr, &one});
  const int failed = tests.empty() ? 1 : _cmocka_run_group_tests("options", tests.data(), tests.size(), nullptr, nullptr);
  std::error_code ignored;
  fs::current_path(before);
  fs::remove_all(scratch, ignored);
  return failed;
}

// Where plugins may lie, and names that must not become paths.
#include <filesystem>

#include "scratch.h"
#include "support/system.h"

namespace plugins {

namespace {

namespace fs = std::filesystem;

// RC_PLUGIN_PATH while it lives.
class PluginPath {
 public:
  explicit PluginPath(const std::string& path) { support::set_variable("RC_PLUGIN_PATH", path.c_str()); }
  ~PluginPath() { support::set_variable("RC_PLUGIN_PATH", nullptr); }
  PluginPath(const PluginPath&) = delete;
  PluginPath& operator=(const PluginPath&) = delete;
};

void the_environment_is_searched(void**) {
  const Scratch scratch;
  scratch.put({"toy"});
  const PluginPath path(scratch.path());
  assert_true(Registry("", 0).load("auto", "toy") > 0);
}

void the_environment_can_be_ignored(void**) {
  const Scratch scratch;
  scratch.put({"toy"});
  const PluginPath path(scratch.path());
  assert_int_equal(Registry("", RC_CONTEXT_NO_ENVIRONMENT).names("toy"), RC_ERR_NO_BACKEND);
}

void plugins_can_be_switched_off(void**) {
  const Scratch scratch;
  scratch.put({"toy"});
  const PluginPath path(scratch.path());
  const Registry registry(scratch.path(), RC_CONTEXT_NO_PLUGINS);
  assert_int_equal(registry.names("toy"), RC_ERR_NO_BACKEND);
  assert_false(registry.lists("toy"));
  assert_true(registry.load("auto", "auto") > 0);
}

void the_configured_path_comes_before_the_environment(void**) {
  const Scratch configured, environment;
  const std::string wanted = configured.put({"toy"});
  environment.put({"toy"});
  const PluginPath path(environment.path());
  assert_string_equal(Registry(configured.path(), 0).origin("toy").c_str(), wanted.c_str());
}

void the_first_directory_of_a_path_wins(void**) {
  const Scratch empty, first, second;
  const std::string wanted = first.put({"toy"});
  second.put({"toy"});
  const std::string next = support::folder_separator;
  const Registry registry(next + next + empty.path() + next + empty.path() + "/none" + next + first.path() + next +
                          second.path() + next);
  assert_string_equal(registry.origin("toy").c_str(), wanted.c_str());
}

void the_current_directory_is_not_searched(void**) {
  const Scratch scratch;
  scratch.put({"toy"});
  const fs::path before = fs::current_path();
  fs::current_path(scratch.path());
  const Registry registry("", 0);
  const rc_status status = registry.names("toy");
  const bool listed = registry.lists("toy");
  fs::current_path(before);
  assert_int_equal(status, RC_ERR_NO_BACKEND);
  assert_false(listed);
}

void relative_directories_are_ignored_and_logged(void**) {
  const Scratch scratch;
  scratch.put({"toy"});
  const fs::path before = fs::current_path();
  fs::current_path(scratch.path());
  const PluginPath path("./");
  const std::string beside = fs::path(scratch.path()).filename().string();
  const Registry registry(std::string(".") + support::folder_separator + "../" + beside, 0);
  const rc_status status = registry.names("toy");
  fs::current_path(before);
  assert_int_equal(status, RC_ERR_NO_BACKEND);
  assert_has(registry.log(), "warning: plugin directory \".\" from the context's plugin_path ignored: it is not absolute");
  assert_has(registry.log(), "plugin directory \"../");
  assert_has(registry.log(), "plugin directory \"./\" from RC_PLUGIN_PATH ignored: it is not absolute");
}

// Relative ones and, on Windows, those of other machines and devices.
void directories_by_other_names_are_ignored_and_logged(void**) {
  const Scratch scratch;
  scratch.put({"toy"});
  for (const std::string& name : support::other_names(scratch.path())) {
    const Registry registry(name);
    assert_int_equal(registry.names("toy"), RC_ERR_NO_BACKEND);
    assert_false(registry.lists("toy"));
    assert_has(registry.log(),
               "warning: plugin directory \"" + name + "\" from the context's plugin_path ignored: it is not absolute");
  }
}

void a_name_cannot_leave_the_directory(void**) {
  const Scratch scratch;
  // What the names would lead to if they were pasted into a path.
  fs::create_directory(scratch.path() + "/rcb_..");
  fs::create_directory(scratch.path() + "/rcb_a");
  scratch.put_as("toy", scratch.path() + "/toy" RC_PLUGIN_SUFFIX);
  scratch.put_as("toy", scratch.path() + "/rcb_a/toy" RC_PLUGIN_SUFFIX);
  scratch.put_as("toy", scratch.path() + "/rcb_" RC_PLUGIN_SUFFIX);
  scratch.put_as("toy", scratch.file("Toy"));
  scratch.put_as("toy", scratch.file("9toy"));
  scratch.put_as("toy", scratch.file(std::string(40, 'a')));
  const Registry registry(scratch.path());
  for (const std::string& name : {std::string("../toy"), std::string("a/toy"), std::string(), std::string("Toy"),
                                  std::string("9toy"), std::string("toy" RC_PLUGIN_SUFFIX), std::string("toy\n"),
                                  std::string("%s%n"), std::string(40, 'a'), std::string(100000, 'a')}) {
    assert_int_equal(registry.names(name), RC_ERR_NO_BACKEND);
    assert_message_has("rc_contact_create: backend \"" + name.substr(0, 50));
  }
  assert_string_equal(registry.log().c_str(), "");
}

void files_of_other_names_are_left_alone(void**) {
  const Scratch scratch;
  scratch.put_as("toy", scratch.path() + "/toy" RC_PLUGIN_SUFFIX);
  scratch.put_as("toy", scratch.path() + "/rcb_toy" RC_PLUGIN_SUFFIX ".1");
  scratch.put_as("toy", scratch.path() + "/librcb_toy" RC_PLUGIN_SUFFIX);
  const Registry registry(scratch.path());
  assert_false(registry.lists("toy"));
  assert_string_equal(registry.log().c_str(), "");
}

void a_missing_backend_says_how_to_get_it(void**) {
  const Registry registry("", RC_CONTEXT_NO_PLUGINS);
  if (registry.lists("fft")) skip();  // linked into the library
  assert_int_equal(registry.names("fft"), RC_ERR_NO_BACKEND);
  assert_message_has("backend \"fft\" is not installed: its plugin rcb_fft" RC_PLUGIN_SUFFIX
                     " is in no plugin directory (built by default)");
  assert_message_has("available: ");
  if (registry.lists("cholmod")) skip();
  assert_int_equal(registry.names("cholmod"), RC_ERR_NO_BACKEND);
  assert_message_has("backend \"cholmod\" is not installed: its plugin rcb_cholmod" RC_PLUGIN_SUFFIX
                     " is in no plugin directory (needs SuiteSparse");
}

void a_plugin_cannot_replace_what_is_built_in(void**) {
  const Scratch scratch;
  scratch.put_as("toy", scratch.file("dense"));
  const Registry registry(scratch.path());
  if (registry.origin("dense") != "built-in") skip();
  assert_true(registry.load("auto", "dense") > 0);
}

void a_plugin_that_appears_later_is_found_by_name(void**) {
  const Scratch scratch;
  const Registry registry(scratch.path());
  assert_int_equal(registry.names("toy"), RC_ERR_NO_BACKEND);
  scratch.put({"toy"});
  assert_int_equal(registry.names("toy"), RC_OK);
}

void a_deleted_working_directory_does_no_harm(void**) {
  const fs::path before = fs::current_path();
  {
    const Scratch scratch;
    fs::current_path(scratch.path());
  }
  const Registry registry("", 0);
  const double load = registry.load("auto", "auto");
  fs::current_path(before);
  assert_true(load > 0);
}

}  // namespace

const std::vector<CMUnitTest> place_tests = {
    cmocka_unit_test(the_environment_is_searched),
    cmocka_unit_test(the_environment_can_be_ignored),
    cmocka_unit_test(plugins_can_be_switched_off),
    cmocka_unit_test(the_configured_path_comes_before_the_environment),
    cmocka_unit_test(the_first_directory_of_a_path_wins),
    cmocka_unit_test(the_current_directory_is_not_searched),
    cmocka_unit_test(relative_directories_are_ignored_and_logged),
    cmocka_unit_test(directories_by_other_names_are_ignored_and_logged),
    cmocka_unit_test(a_name_cannot_leave_the_directory),
    cmocka_unit_test(files_of_other_names_are_left_alone),
    cmocka_unit_test(a_missing_backend_says_how_to_get_it),
    cmocka_unit_test(a_plugin_cannot_replace_what_is_built_in),
    cmocka_unit_test(a_plugin_that_appears_later_is_found_by_name),
    cmocka_unit_test(a_deleted_working_directory_does_no_harm),
};

}  // namespace plugins

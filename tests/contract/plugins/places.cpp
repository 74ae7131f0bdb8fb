// Where plugins may lie, and names that must not become paths.
#include <filesystem>

#include "scratch.h"
#include "support/system.h"

namespace plugins {

namespace {

namespace fs = std::filesystem;

// The current directory while it lives.
class Current {
 public:
  explicit Current(const fs::path& path) : before_(fs::current_path()) { fs::current_path(path); }
  ~Current() { fs::current_path(before_); }
  Current(const Current&) = delete;
  Current& operator=(const Current&) = delete;

 private:
  fs::path before_;
};

// RC_PLUGIN_PATH while it lives.
class PluginPath {
 public:
  explicit PluginPath(const std::string& path) { support::set_variable("RC_PLUGIN_PATH", path.c_str()); }
  ~PluginPath() { support::set_variable("RC_PLUGIN_PATH", nullptr); }
  PluginPath(const PluginPath&) = delete;
  PluginPath& operator=(const PluginPath&) = delete;
};

void the_environment_is_searched_unless_it_is_ignored() {
  const Scratch scratch;
  scratch.put({"toy"});
  const PluginPath path(scratch.path());
  assert_true(Registry("", 0).load("auto", "toy") > 0);
  assert_int_equal(Registry("", RC_CONTEXT_NO_ENVIRONMENT).names("toy"), RC_ERR_NO_BACKEND);
  const Registry none(scratch.path(), RC_CONTEXT_NO_PLUGINS);
  assert_int_equal(none.names("toy"), RC_ERR_NO_BACKEND);
  assert_false(none.lists("toy"));
  assert_true(none.load("auto", "auto") > 0);
}

void the_first_directory_of_the_configured_path_comes_before_all_others() {
  const Scratch empty, first, second, environment;
  const std::string wanted = first.put({"toy"});
  second.put({"toy"});
  environment.put({"toy"});
  const PluginPath path(environment.path());
  const std::string next = support::folder_separator;
  const Registry registry(
      next + next + empty.path() + next + empty.path() + "/none" + next + first.path() + next + second.path() + next, 0);
  assert_string_equal(registry.origin("toy").c_str(), wanted.c_str());
}

void neither_the_current_directory_nor_relative_ones_are_searched() {
  const Scratch scratch;
  scratch.put({"toy"});
  const Current here(scratch.path());
  const Registry nothing("", 0);
  assert_int_equal(nothing.names("toy"), RC_ERR_NO_BACKEND);
  assert_false(nothing.lists("toy"));
  const PluginPath path("./");
  const std::string beside = fs::path(scratch.path()).filename().string();
  const Registry registry(std::string(".") + support::folder_separator + "../" + beside, 0);
  assert_int_equal(registry.names("toy"), RC_ERR_NO_BACKEND);
  assert_has(registry.log(), "warning: plugin directory \".\" from the context's plugin_path ignored: it is not absolute");
  assert_has(registry.log(), "plugin directory \"../");
  assert_has(registry.log(), "plugin directory \"./\" from RC_PLUGIN_PATH ignored: it is not absolute");
}

// Relative ones and, on Windows, those of other machines and devices.
void directories_by_other_names_are_ignored_and_logged() {
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

void a_name_cannot_leave_the_directory() {
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

void files_of_other_names_are_left_alone() {
  const Scratch scratch;
  scratch.put_as("toy", scratch.path() + "/toy" RC_PLUGIN_SUFFIX);
  scratch.put_as("toy", scratch.path() + "/rcb_toy" RC_PLUGIN_SUFFIX ".1");
  scratch.put_as("toy", scratch.path() + "/librcb_toy" RC_PLUGIN_SUFFIX);
  const Registry registry(scratch.path());
  assert_false(registry.lists("toy"));
  assert_string_equal(registry.log().c_str(), "");
}

void a_missing_backend_says_how_to_get_it() {
  const Registry registry("", RC_CONTEXT_NO_PLUGINS);
  if (registry.lists("fft")) throw pairs::Skipped("not on this system");  // linked into the library
  assert_int_equal(registry.names("fft"), RC_ERR_NO_BACKEND);
  assert_message_has("backend \"fft\" is not installed: its plugin rcb_fft" RC_PLUGIN_SUFFIX
                     " is in no plugin directory (built by default)");
  assert_message_has("available: ");
  if (registry.lists("cholmod")) throw pairs::Skipped("not on this system");
  assert_int_equal(registry.names("cholmod"), RC_ERR_NO_BACKEND);
  assert_message_has("backend \"cholmod\" is not installed: its plugin rcb_cholmod" RC_PLUGIN_SUFFIX
                     " is in no plugin directory (needs SuiteSparse");
}

void a_plugin_cannot_replace_what_is_built_in() {
  const Scratch scratch;
  scratch.put_as("toy", scratch.file("dense"));
  const Registry registry(scratch.path());
  if (registry.origin("dense") != "built-in") throw pairs::Skipped("not on this system");
  assert_true(registry.load("auto", "dense") > 0);
}

void a_plugin_that_appears_later_is_found_by_name() {
  const Scratch scratch;
  const Registry registry(scratch.path());
  assert_int_equal(registry.names("toy"), RC_ERR_NO_BACKEND);
  scratch.put({"toy"});
  assert_int_equal(registry.names("toy"), RC_OK);
}

void a_deleted_working_directory_does_no_harm() {
  const Current before(fs::current_path());
  {
    const Scratch scratch;
    fs::current_path(scratch.path());
  }
  assert_true(Registry("", 0).load("auto", "auto") > 0);
}

}  // namespace

std::vector<pairs::Test> place_tests() {
  return {
      TEST(the_environment_is_searched_unless_it_is_ignored),
      TEST(the_first_directory_of_the_configured_path_comes_before_all_others),
      TEST(neither_the_current_directory_nor_relative_ones_are_searched),
      TEST(directories_by_other_names_are_ignored_and_logged),
      TEST(a_name_cannot_leave_the_directory),
      TEST(files_of_other_names_are_left_alone),
      TEST(a_missing_backend_says_how_to_get_it),
      TEST(a_plugin_cannot_replace_what_is_built_in),
      TEST(a_plugin_that_appears_later_is_found_by_name),
      TEST(a_deleted_working_directory_does_no_harm),
  };
}

}  // namespace plugins

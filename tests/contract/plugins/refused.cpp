// Plugins that must be refused: with RC_ERR_PLUGIN when named, with a line in the log when listed.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include "scratch.h"
#include "support/system.h"

namespace plugins {

namespace {

namespace fs = std::filesystem;

void assert_refused(const Scratch& scratch, const std::string& name, const std::string& reason, const char* level = "warning: ") {
  const Registry by_name(scratch.path());
  assert_int_equal(by_name.names(name), RC_ERR_PLUGIN);
  assert_message_has("rc_contact_create: ");
  assert_message_has(reason);
  const Registry listed(scratch.path());
  assert_false(listed.lists(name));
  assert_has(listed.log(), level);
  assert_has(listed.log(), reason);
  assert_true(listed.lists("dense"));
  assert_true(listed.load("auto", "auto") > 0);
}

struct Fixture {
  const char *name, *reason, *level = "warning: ";
};
constexpr Fixture fixtures[] = {
    {"bad_abi", "has plugin ABI 99, this library has 1; rebuild it against the installed headers"},
    {"no_symbol", "rcb_no_symbol" RC_PLUGIN_SUFFIX " does not export rc_plugin_query"},
    {"wrong_name", "rcb_wrong_name" RC_PLUGIN_SUFFIX " calls itself \"other\", not \"wrong_name\""},
    {"no_name", "rcb_no_name" RC_PLUGIN_SUFFIX " calls itself \"\", not \"no_name\""},
    {"refuses", "rcb_refuses" RC_PLUGIN_SUFFIX " refuses to be used: no accelerator here",
     "info: "},  // says itself that it cannot
    {"describes_nothing", "rcb_describes_nothing" RC_PLUGIN_SUFFIX " describes nothing"},
    {"second_is_bad", "a component is named \"No Name\"; names are [a-z][a-z0-9_-]*, at most 31 characters"},
};

void spoilt_files_are_refused() {
  for (const Fixture& each : fixtures) {
    const Scratch scratch;
    scratch.put({each.name});
    assert_refused(scratch, each.name, each.reason, each.level);
    assert_false(Registry(scratch.path()).lists(std::string("second-of-") + each.name));  // all or nothing
  }
}

void files_that_are_no_shared_objects_are_refused() {
  for (const std::size_t size : {0, 1000}) {
    const Scratch scratch;
    std::ofstream(scratch.file("text")) << std::string(size, 'x');
    assert_refused(scratch, "text", "rcb_text" RC_PLUGIN_SUFFIX " is not a shared object of this machine");
  }
}

// Wherever a copy breaks off, it is refused before the system's loader touches what is missing.
void a_truncated_shared_object_is_refused() {
  const Scratch scratch;
  const std::string file = scratch.put({"toy"});
  for (std::uintmax_t size = fs::file_size(file) / 2; size > 0; size /= 2) {
    fs::resize_file(file, size);
    assert_refused(scratch, "toy",
                   "plugin refused: " + file +
                       (size < 52     ? " is not a shared object"
                        : size < 1024 ? " is "
                                      : " is incomplete"));
  }
}

// A file for another processor, and a file that needs a missing library.
void files_that_the_system_cannot_load_are_refused() {
  for (const bool foreign : {true, false}) {
    const Scratch scratch;
    std::fstream file(scratch.put({"toy"}), std::ios::in | std::ios::out | std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    const std::size_t name = bytes.find(support::needed_by_all);
    assert_true(name != std::string::npos);
    file.seekp(foreign ? support::machine_in_library : static_cast<std::streamoff>(name)).write("\xff\xff", foreign ? 2 : 1);
    file.close();
    assert_refused(
        scratch, "toy",
        std::string("rcb_toy" RC_PLUGIN_SUFFIX) + (foreign ? " is not a shared object of this machine" : " cannot be loaded: "));
  }
}

// A pipe is not waited for.
void what_is_no_file_is_refused() {
  for (const bool pipe : {false, true}) {
    const Scratch scratch;
    if (pipe && !support::make_pipe(scratch.file("odd"))) continue;
    if (!pipe) fs::create_directory(scratch.file("odd"));
    assert_refused(scratch, "odd", "rcb_odd" RC_PLUGIN_SUFFIX " is not a regular file");
  }
}

void what_everybody_can_write_to_is_refused() {
  for (const bool folder : {false, true}) {
    const Scratch scratch;
    const std::string file = scratch.put({"toy"}), spoilt_path = folder ? scratch.path() : file;
    support::let_everybody_write(spoilt_path);
    assert_refused(scratch, "toy", "plugin refused: " + spoilt_path + support::writable_to_all);
  }
}

void a_link_to_a_world_writable_file_is_refused() {
  const Scratch scratch, elsewhere;
  const std::string target = elsewhere.put({"toy"});
  support::let_everybody_write(target);
  std::error_code impossible;
  fs::create_symlink(target, scratch.file("toy"), impossible);
  if (impossible) throw pairs::Skipped("not on this system");
  assert_refused(scratch, "toy", support::writable_to_all);
}

void what_belongs_to_another_user_is_refused() {
  for (const bool folder : {false, true}) {
    const Scratch scratch;
    const std::string file = scratch.put({"toy"});
    if (!support::give_away(folder ? scratch.path() : file)) throw pairs::Skipped("only for the superuser");
    assert_refused(scratch, "toy", support::owned_by_another);
  }
}

void one_bad_plugin_does_not_hide_the_good_ones() {
  const Scratch scratch;
  scratch.put({"bad_abi", "no_symbol", "second_is_bad", "toy", "wrong_name"});
  const Registry registry(scratch.path());
  assert_true(registry.lists("toy"));
  for (const char* name : {"bad_abi", "no_symbol", "second_is_bad", "wrong_name"}) assert_has(registry.log(), name);
}

void a_refused_plugin_leaves_no_options() {
  const Scratch scratch;
  scratch.put({"second_is_bad"});
  const Registry registry(scratch.path());
  for (int attempt = 0; attempt < 2; ++attempt) assert_int_equal(registry.names("second_is_bad"), RC_ERR_PLUGIN);
  for (std::int64_t i = 0; i < rc_component_count(registry.get(), RC_COMPONENT_OPTION); ++i) {
    rc_component option = RC_COMPONENT_INIT;
    assert_int_equal(rc_component_describe(registry.get(), RC_COMPONENT_OPTION, i, &option), RC_OK);
    assert_true(std::string(option.name).find("second_is_bad") == std::string::npos);
  }
}

}  // namespace

std::vector<pairs::Test> refused_tests() {
  return {
      TEST(spoilt_files_are_refused),
      TEST(files_that_are_no_shared_objects_are_refused),
      TEST(a_truncated_shared_object_is_refused),
      TEST(files_that_the_system_cannot_load_are_refused),
      TEST(what_is_no_file_is_refused),
      TEST(what_everybody_can_write_to_is_refused),
      TEST(a_link_to_a_world_writable_file_is_refused),
      TEST(what_belongs_to_another_user_is_refused),
      TEST(one_bad_plugin_does_not_hide_the_good_ones),
      TEST(a_refused_plugin_leaves_no_options),
  };
}

}  // namespace plugins

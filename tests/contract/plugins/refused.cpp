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

template <const auto& fixture> void is_refused(void**) {
  const Scratch scratch;
  scratch.put({fixture.name});
  assert_refused(scratch, fixture.name, fixture.reason, fixture.level);
  const Registry registry(scratch.path());
  assert_false(registry.lists(std::string("second-of-") + fixture.name));  // all or nothing
}

struct Spoilt {
  const char *name, *reason, *level = "warning: ";
};
constexpr Spoilt bad_abi{"bad_abi", "has plugin ABI 99, this library has 1; rebuild it against the installed headers"};
constexpr Spoilt no_symbol{"no_symbol", "rcb_no_symbol" RC_PLUGIN_SUFFIX " does not export rc_plugin_query"};
constexpr Spoilt wrong_name{"wrong_name", "rcb_wrong_name" RC_PLUGIN_SUFFIX " calls itself \"other\", not \"wrong_name\""};
constexpr Spoilt no_name{"no_name", "rcb_no_name" RC_PLUGIN_SUFFIX " calls itself \"\", not \"no_name\""};
constexpr Spoilt small_plugin{"small_plugin", "struct_size 8 is smaller than"};
constexpr Spoilt small_backend{"small_backend", "a backend has struct_size 8, smaller than"};
constexpr Spoilt no_backends{"no_backends", "a list of components is null"};
constexpr Spoilt null_apply{"null_apply", "backend \"null_apply\" lacks one of create, destroy, bind, apply, field, modelled"};
constexpr Spoilt cap_lies{"cap_lies", "backend \"cap_lies\" has no subset() but its caps say otherwise"};
constexpr Spoilt no_license{"no_license", "component \"no_license\" lacks a summary or a licence"};
constexpr Spoilt refuses{"refuses", "rcb_refuses" RC_PLUGIN_SUFFIX " refuses to be used: no accelerator here",
                         "info: "};  // it says itself that it cannot serve here
constexpr Spoilt describes_nothing{"describes_nothing", "rcb_describes_nothing" RC_PLUGIN_SUFFIX " describes nothing"};
constexpr Spoilt option_key_wrong{"option_key_wrong",
                                  "declares the option \"tol\"; its keys must start with \"option_key_wrong.\""};
constexpr Spoilt option_default_wrong{
    "option_default_wrong", "the default of an option does not fit: option \"option_default_wrong.order\" = \"diagonals\""};
constexpr Spoilt second_is_bad{"second_is_bad",
                               "a component is named \"No Name\"; names are [a-z][a-z0-9_-]*, at most 31 characters"};
constexpr Spoilt second_is_taken{"second_is_taken", "a component named \"dense\" is registered already"};

void a_text_file_is_refused(void**) {
  const Scratch scratch;
  std::ofstream(scratch.file("text")) << std::string(1000, 'x');
  assert_refused(scratch, "text", "rcb_text" RC_PLUGIN_SUFFIX " is not a shared object of this machine");
}

void an_empty_file_is_refused(void**) {
  const Scratch scratch;
  std::ofstream(scratch.file("empty")).flush();
  assert_refused(scratch, "empty", "rcb_empty" RC_PLUGIN_SUFFIX " is not a shared object of this machine");
}

// Wherever a copy breaks off, it is refused before the system's loader touches what is missing.
void a_truncated_shared_object_is_refused(void**) {
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

void a_shared_object_of_another_processor_is_refused(void**) {
  const Scratch scratch;
  const std::string path = scratch.put({"toy"});
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(support::machine_in_library).write("\xff\xff", 2);
  file.close();
  assert_refused(scratch, "toy", "rcb_toy" RC_PLUGIN_SUFFIX " is not a shared object of this machine");
}

void a_plugin_that_needs_a_missing_library_is_refused(void**) {
  const Scratch scratch;
  std::fstream file(scratch.put({"toy"}), std::ios::in | std::ios::out | std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  const std::size_t name = bytes.find(support::needed_by_all);
  assert_true(name != std::string::npos);
  file.seekp(static_cast<std::streamoff>(name)).put('x');
  file.close();
  assert_refused(scratch, "toy", "rcb_toy" RC_PLUGIN_SUFFIX " cannot be loaded: ");
}

void a_directory_in_place_of_a_file_is_refused(void**) {
  const Scratch scratch;
  fs::create_directory(scratch.file("folder"));
  assert_refused(scratch, "folder", "rcb_folder" RC_PLUGIN_SUFFIX " is not a regular file");
}

void a_pipe_is_refused_without_waiting_for_it(void**) {
  const Scratch scratch;
  if (!support::make_pipe(scratch.file("pipe"))) skip();
  assert_refused(scratch, "pipe", "rcb_pipe" RC_PLUGIN_SUFFIX " is not a regular file");
}

void a_world_writable_file_is_refused(void**) {
  const Scratch scratch;
  const std::string file = scratch.put({"toy"});
  support::let_everybody_write(file);
  assert_refused(scratch, "toy", "plugin refused: " + file + support::writable_to_all);
}

void a_world_writable_directory_is_refused(void**) {
  const Scratch scratch;
  scratch.put({"toy"});
  support::let_everybody_write(scratch.path());
  assert_refused(scratch, "toy", "plugin refused: " + scratch.path() + support::writable_to_all);
}

void a_link_to_a_world_writable_file_is_refused(void**) {
  const Scratch scratch, elsewhere;
  const std::string target = elsewhere.put({"toy"});
  support::let_everybody_write(target);
  std::error_code impossible;
  fs::create_symlink(target, scratch.file("toy"), impossible);
  if (impossible) skip();
  assert_refused(scratch, "toy", support::writable_to_all);
}

void a_file_of_another_user_is_refused(void**) {
  const Scratch scratch;
  if (!support::give_away(scratch.put({"toy"}))) skip();
  assert_refused(scratch, "toy", support::owned_by_another);
}

void a_directory_of_another_user_is_refused(void**) {
  const Scratch scratch;
  scratch.put({"toy"});
  if (!support::give_away(scratch.path())) skip();
  assert_refused(scratch, "toy", support::owned_by_another);
}

void one_bad_plugin_does_not_hide_the_good_ones(void**) {
  const Scratch scratch;
  scratch.put({"bad_abi", "no_symbol", "second_is_bad", "toy", "wrong_name"});
  const Registry registry(scratch.path());
  assert_true(registry.lists("toy"));
  for (const char* name : {"bad_abi", "no_symbol", "second_is_bad", "wrong_name"}) assert_has(registry.log(), name);
}

void a_refused_plugin_leaves_no_options(void**) {
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

#define REFUSED(fixture) \
  { #fixture "_is_refused", is_refused < fixture>, nullptr, nullptr, nullptr }

}  // namespace

const std::vector<CMUnitTest> refused_tests = {
    REFUSED(bad_abi),
    REFUSED(no_symbol),
    REFUSED(wrong_name),
    REFUSED(no_name),
    REFUSED(small_plugin),
    REFUSED(small_backend),
    REFUSED(no_backends),
    REFUSED(null_apply),
    REFUSED(cap_lies),
    REFUSED(no_license),
    REFUSED(refuses),
    REFUSED(describes_nothing),
    REFUSED(option_key_wrong),
    REFUSED(option_default_wrong),
    REFUSED(second_is_bad),
    REFUSED(second_is_taken),
    cmocka_unit_test(a_text_file_is_refused),
    cmocka_unit_test(an_empty_file_is_refused),
    cmocka_unit_test(a_truncated_shared_object_is_refused),
    cmocka_unit_test(a_shared_object_of_another_processor_is_refused),
    cmocka_unit_test(a_plugin_that_needs_a_missing_library_is_refused),
    cmocka_unit_test(a_directory_in_place_of_a_file_is_refused),
    cmocka_unit_test(a_pipe_is_refused_without_waiting_for_it),
    cmocka_unit_test(a_world_writable_file_is_refused),
    cmocka_unit_test(a_world_writable_directory_is_refused),
    cmocka_unit_test(a_link_to_a_world_writable_file_is_refused),
    cmocka_unit_test(a_file_of_another_user_is_refused),
    cmocka_unit_test(a_directory_of_another_user_is_refused),
    cmocka_unit_test(one_bad_plugin_does_not_hide_the_good_ones),
    cmocka_unit_test(a_refused_plugin_leaves_no_options),
};

}  // namespace plugins

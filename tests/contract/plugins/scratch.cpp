#include "scratch.h"

#include <cstring>
#include <filesystem>
#include <random>
#include <system_error>

#include "support/system.h"
#include "support/unit_system.h"

namespace plugins {

namespace fs = std::filesystem;

Scratch::Scratch() {
  static std::random_device number;
  do path_ = (fs::current_path() / ("plugins-" + std::to_string(number()))).string();
  while (!fs::create_directory(path_));
}

Scratch::~Scratch() {
  std::error_code loaded;  // some systems keep the file of a plugin that is in use
  fs::remove_all(path_, loaded);
}

std::string Scratch::put(const std::vector<std::string>& fixtures) const {
  std::string last;
  for (const std::string& fixture : fixtures) last = put_as(fixture, file(fixture));
  return last;
}

std::string Scratch::put_as(const std::string& fixture, const std::string& file) const {
  static const std::string fixtures = RC_FIXTURE_DIRECTORY;
  fs::copy_file(fixtures + "/rcb_" + fixture + RC_PLUGIN_SUFFIX, file);
  support::let_owner_alone_write(file);
  return file;
}

Registry::Registry(const std::string& plugin_path, std::uint32_t flags) {
  const auto log = [](std::int32_t level, const char* message, void* user) {
    *static_cast<std::string*>(user) += (level == RC_LOG_WARNING ? "warning: " : "info: ") + std::string(message) + "\n";
  };
  assert_int_equal(rc_context_create(flags, plugin_path.c_str(), log, &log_, &context_), RC_OK);
}

Registry::~Registry() { rc_context_destroy(context_); }

namespace {

constexpr std::int64_t nx = 6, ny = 5;

rc_system small_grid(std::int32_t boundary) {
  rc_system system = support::unit_system();
  system.nx = nx;
  system.ny = ny;
  system.boundary = boundary;
  return system;
}

}  // namespace

rc_status Registry::names(const std::string& backend) const {
  rc_options* options = nullptr;
  assert_int_equal(rc_options_create(context_, &options), RC_OK);
  assert_int_equal(rc_options_set_text(options, RC_OPT_BACKEND, backend.c_str()), RC_OK);
  const rc_system system = small_grid(RC_BOUNDARY_FREE);
  rc_contact* contact = nullptr;
  const rc_status status = rc_contact_create(&system, options, &contact);
  rc_contact_destroy(contact);
  rc_options_destroy(options);
  return status;
}

double Registry::load(const std::string& solver, const std::string& backend, std::int32_t boundary, std::int32_t control) const {
  rc_options* options = nullptr;
  assert_int_equal(rc_options_create(context_, &options), RC_OK);
  assert_int_equal(rc_options_set_text(options, RC_OPT_SOLVER, solver.c_str()), RC_OK);
  assert_int_equal(rc_options_set_text(options, RC_OPT_BACKEND, backend.c_str()), RC_OK);
  assert_int_equal(rc_options_set_number(options, RC_OPT_TOL, 1e-10), RC_OK);
  std::vector<double> gap(nx * ny);
  for (std::int64_t i = 0; i < nx * ny; ++i) {
    const double x = static_cast<double>(i % nx) - 2.5, y = static_cast<double>(i / nx) - 2;
    gap[static_cast<std::size_t>(i)] = 0.05 * (x * x + y * y);
  }
  const rc_system system = small_grid(boundary);
  rc_step step = RC_STEP_INIT;
  step.control = control;
  step.target = control == RC_CONTROL_LOAD ? 2 : 0.2;
  step.undeformed_gap.data = gap.data();
  result_ = RC_RESULT_INIT;
  const rc_status status = rc_solve(&system, &step, options, &result_);
  if (status != RC_OK) print_message("%s on %s: %s\n", solver.c_str(), backend.c_str(), rc_last_error());
  rc_options_destroy(options);
  return status == RC_OK ? result_.load : 0;
}

std::string Registry::origin(const std::string& backend) const {
  for (std::int64_t i = 0; i < rc_component_count(context_, RC_COMPONENT_BACKEND); ++i) {
    rc_component component{};
    component.struct_size = sizeof component;
    assert_int_equal(rc_component_describe(context_, RC_COMPONENT_BACKEND, i, &component), RC_OK);
    if (backend == component.name) return component.origin;
  }
  return {};
}

void assert_has(const std::string& text, const std::string& part) {
  if (text.find(part) == std::string::npos) print_error("text:  %s\nlacks: %s\n", text.c_str(), part.c_str());
  assert_true(text.find(part) != std::string::npos);
}

void assert_message_has(const std::string& part) { assert_has(rc_last_error(), part); }

}  // namespace plugins

#include "scratch.h"

#include <filesystem>
#include <random>
#include <system_error>

#include "support/surfaces.h"
#include "support/system.h"

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
  rc_context* made = nullptr;
  assert_int_equal(rc_context_create(flags, plugin_path.c_str(), log, log_.get(), &made), RC_OK);
  context_.reset(made);
}

namespace {

pairs::Problem small_problem(std::int32_t boundary, std::int32_t control) {
  pairs::Problem problem;
  problem.system.nx = 6;
  problem.system.ny = 5;
  problem.system.boundary = boundary;
  problem.gap = pairs::paraboloid(6, 5, 1, 2.5, 2, 10);
  problem.control = control;
  problem.target = control == RC_CONTROL_LOAD ? 2 : 0.2;
  return problem;
}

}  // namespace

rc_status Registry::names(const std::string& backend) const {
  const pairs::Problem problem = small_problem(RC_BOUNDARY_FREE, RC_CONTROL_APPROACH);
  rc_contact* contact = nullptr;
  const rc_status status =
      rc_contact_create(&problem.system, pairs::make_options({"auto", backend}, "auto", {}, get()).get(), &contact);
  rc_contact_destroy(contact);
  return status;
}

double Registry::load(const std::string& solver, const std::string& backend, std::int32_t boundary, std::int32_t control) const {
  const Pressed pressed(*this, small_problem(boundary, control), {{"solver", solver}, {"backend", backend}, {"tol", "1e-10"}});
  result_ = pressed.result;
  if (pressed.status != RC_OK) print_message("%s on %s: %s\n", solver.c_str(), backend.c_str(), rc_last_error());
  return pressed.status == RC_OK ? result_.load : 0;
}

Pressed::Pressed(const Registry& registry, const pairs::Problem& problem, const pairs::Settings& settings)
    : p(problem.points(), -7), gap(problem.points(), -7), problem_(problem) {
  const pairs::Options options = pairs::make_options(pairs::automatic, problem.kernel, settings, registry.get());
  rc_contact* made = nullptr;
  status = rc_contact_create(&problem_.system, options.get(), &made);
  contact_.reset(made);
  if (status != RC_OK) return;
  assert_string_equal(explanation().c_str(), "");
  again();
}

void Pressed::again() {
  const rc_step step = problem_.step();
  result = RC_RESULT_INIT;
  result.p.data = p.data();
  result.gap.data = gap.data();
  status = rc_contact_solve(contact_.get(), &step, &result);
}

std::string Pressed::explanation() const {
  const char* text = nullptr;
  assert_int_equal(rc_contact_explain(contact_.get(), &text), RC_OK);
  return text;
}

std::string Registry::origin(const std::string& backend) const {
  for (std::int64_t i = 0; i < rc_component_count(get(), RC_COMPONENT_BACKEND); ++i) {
    rc_component component = RC_COMPONENT_INIT;
    assert_int_equal(rc_component_describe(get(), RC_COMPONENT_BACKEND, i, &component), RC_OK);
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

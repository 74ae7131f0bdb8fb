#include "library.h"

#include <charconv>

namespace bench {

namespace {

std::vector<std::string> names(std::int64_t count, rc_status (*describe)(rc_context*, std::int64_t, rc_component*)) {
  std::vector<std::string> result;
  for (std::int64_t i = 0; i < count; ++i) {
    rc_component component{};
    component.struct_size = sizeof component;
    check(describe(nullptr, i, &component));
    result.emplace_back(component.name);
  }
  return result;
}

}  // namespace

rc_status check(rc_status status) {
  if (status < 0) throw Failure(std::string(rc_status_name(status)) + ": " + rc_last_error());
  return status;
}

Context::Context() {
  rc_context* context = nullptr;
  check(rc_context_create(nullptr, &context));
  handle_.reset(context);
}

Options::Options(rc_context* context) {
  rc_options* options = nullptr;
  check(rc_options_create(context, &options));
  handle_.reset(options);
}

Options& Options::set(const char* key, const std::string& value) {
  check(rc_options_parse(handle_.get(), key, value.c_str()));
  return *this;
}

Options& Options::set(const char* key, double value) {
  char text[32];
  const auto [end, error] = std::to_chars(text, text + sizeof text, value);
  return set(key, std::string(text, end));
}

Options& Options::set(const Settings& settings) {
  for (const auto& [key, value] : settings) set(key.c_str(), value);
  return *this;
}

Contact::Contact(const rc_system& system, const Options& options) {
  rc_contact* contact = nullptr;
  check(rc_contact_create(&system, options.get(), &contact));
  handle_.reset(contact);
}

rc_result Contact::solve(const rc_step& step, double* p) {
  rc_result result;
  rc_result_init(&result);
  result.p = p;
  check(rc_contact_solve(handle_.get(), &step, &result));
  return result;
}

std::vector<std::string> solver_names() { return names(rc_solver_count(nullptr), rc_solver_describe); }
std::vector<std::string> backend_names() { return names(rc_backend_count(nullptr), rc_backend_describe); }
std::vector<std::string> kernel_names() { return names(rc_kernel_count(nullptr), rc_kernel_describe); }

rc_system unit_square(std::int64_t n) {
  rc_system system = RC_SYSTEM_INIT;
  system.nx = system.ny = n;
  system.hx = system.hy = 1.0 / static_cast<double>(n);
  return system;
}

}  // namespace bench

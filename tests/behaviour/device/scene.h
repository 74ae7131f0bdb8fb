// A contact on the host build of the plugin for devices.
#pragma once

#include <roughcontact/plugin.h>

#include <cmath>
#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

#include "runtime/host_faults.h"
#include "support/cmocka.hpp"
#include "support/unit_system.h"

extern "C" rc_status rc_builtin_cuda_host(const rc_host*, const rc_plugin**);

namespace device {

constexpr std::int64_t side = 24;
constexpr double untouched = -7;

inline std::vector<double> hills_of(std::int64_t n) {
  std::vector<double> h;
  for (std::int64_t i = 0; i < n * n; ++i) {
    const double x = static_cast<double>(i % n), y = static_cast<double>(i / n);
    h.push_back(2 - std::cos(0.9 * x) * std::cos(0.5 * y) - std::cos(0.2 * x + 0.1 * y));
  }
  return h;
}

inline const std::vector<double>& hills() {
  static const std::vector<double> gap = hills_of(side);
  return gap;
}

inline rc_step cold_step() {
  rc_step step = RC_STEP_INIT;
  step.control = RC_CONTROL_APPROACH;
  step.target = 0.6;
  step.warm_start = 0;
  return step;
}

inline const rc_plugin* plugin() {
  const rc_plugin* plugin = nullptr;
  assert_int_equal(rc_builtin_cuda_host(nullptr, &plugin), RC_OK);
  return plugin;
}

inline rc_system grid_of(std::int64_t n) {
  rc_system system = support::unit_system();
  system.nx = system.ny = n;
  return system;
}

inline std::int64_t& last_calls() {
  static std::int64_t calls = 0;
  return calls;
}

// A context that has the plugin, and a contact on it.
class Contact {
 public:
  explicit Contact(double memory_limit = 1048576, std::int64_t n = side, const rc_plugin* plugin = device::plugin())
      : Contact(memory_limit, grid_of(n), plugin) {}
  Contact(double memory_limit, const rc_system& system, const rc_plugin* plugin) {
    const auto hear = [](std::int32_t, const char* message, void* user) { static_cast<Contact*>(user)->hear(message); };
    assert_int_equal(rc_context_create(RC_CONTEXT_NO_PLUGINS, nullptr, hear, this, &context_), RC_OK);
    assert_int_equal(rc_context_register(context_, plugin), RC_OK);
    assert_int_equal(rc_options_create(context_, &options_), RC_OK);
    assert_int_equal(rc_options_set_number(options_, "cuda-host.memory_limit", memory_limit), RC_OK);
    use("haar-cuda-host", "cuda-host");
    assert_int_equal(rc_contact_create(&system, options_, &contact_), RC_OK);
  }
  ~Contact() {
    rc_contact_destroy(contact_);
    rc_options_destroy(options_);
    rc_context_destroy(context_);
  }
  Contact(const Contact&) = delete;
  Contact& operator=(const Contact&) = delete;

  void use(const char* solver, const char* backend) {
    rc_options_set_text(options_, RC_OPT_SOLVER, solver);
    rc_options_set_text(options_, RC_OPT_BACKEND, backend);
    if (contact_) assert_int_equal(rc_contact_set_options(contact_, options_), RC_OK);
  }

  rc_status solve(std::vector<double>& p) {
    p.assign(hills().size(), untouched);
    rc_step step = cold_step();
    step.undeformed_gap.data = hills().data();
    rc_result result = RC_RESULT_INIT;
    result.p.data = p.data();
    return solve(step, result);
  }
  rc_status solve(const rc_step& step, rc_result& result) {
    const rc_status status = rc_contact_solve(contact_, &step, &result);
    words_ = rc_last_error();
    return status;
  }
  rc_contact* get() const { return contact_; }
  const rc_options* options() const { return options_; }
  const std::string& words() const { return words_; }
  // The last message in the context's log, from any thread.
  std::string logged() const {
    const std::lock_guard guarded(hearing_);
    return logged_;
  }

 private:
  void hear(const char* message) {
    const std::lock_guard guarded(hearing_);
    logged_ = message;
  }

  rc_context* context_ = nullptr;
  rc_options* options_ = nullptr;
  rc_contact* contact_ = nullptr;
  std::string words_;
  mutable std::mutex hearing_;
  std::string logged_;
};

// The layer below fails in its call number `at` of what act() does; its calls are counted, and 0 lets all succeed.
template <class Act> auto with_fault(rc_cuda::Fault fault, std::int64_t at, const Act& act) {
  rc_cuda::host_faults() = {.fault = fault, .at = at};
  const auto result = act();
  last_calls() = rc_cuda::host_faults().calls;
  rc_cuda::host_faults() = {};
  return result;
}

// The plugin with estimates by which "auto" takes it; at_once: for several contacts together alone.
template <bool at_once> const rc_plugin* cheap() {
  static rc_backend backend = *plugin()->backends[0];
  static rc_solver solver = *plugin()->solvers[0];
  static const rc_backend* const backends[] = {&backend};
  static const rc_solver* const solvers[] = {&solver};
  static rc_plugin copy = *plugin();
  backend.score = solver.score = [](const rc_facts* facts, rc_estimate* estimate) -> rc_status {
    estimate->seconds = at_once && facts->at_once <= 1 ? 1 : 1e-12;
    estimate->product = 1;  // other solvers make their products by it
    return RC_OK;
  };
  copy.backends = backends;
  copy.solvers = solvers;
  return &copy;
}

inline void expect_failed(const Contact& contact, rc_cuda::Fault fault) {
  const char* const words = fault == rc_cuda::Fault::lost ? "the device is lost" : "the kernel failed";
  if (contact.words().find(words) == std::string::npos) fail_msg("\"%s\" does not have \"%s\"", contact.words().c_str(), words);
}

inline void expect_untouched(const std::vector<double>& p) {
  for (const double value : p) assert_true(value == untouched);
}

inline void goes_on_elsewhere(Contact& contact) {
  std::vector<double> p;
  contact.use("haar-cg", "dense");
  assert_int_equal(contact.solve(p), RC_OK);
}

inline void expect_words(const Contact& contact, const char* words) {
  if (contact.words().find(words) == std::string::npos) fail_msg("\"%s\" does not have \"%s\"", contact.words().c_str(), words);
}

}  // namespace device

// What can go wrong with a device: each time a status, the driver's words, pressures that are not touched, and a contact that
// goes on with another backend.
#include <roughcontact/plugin.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "runtime/host_faults.h"
#include "support/cmocka.hpp"
#include "support/unit_system.h"

extern "C" rc_status rc_builtin_cuda_host(const rc_host*, const rc_plugin**);

namespace {

using rc_cuda::Fault, rc_cuda::host_faults;

constexpr std::int64_t side = 24;
constexpr double untouched = -7;

const std::vector<double>& hills() {
  static const std::vector<double> gap = [] {
    std::vector<double> h;
    for (std::int64_t i = 0; i < side * side; ++i) {
      const double x = static_cast<double>(i % side), y = static_cast<double>(i / side);
      h.push_back(2 - std::cos(0.9 * x) * std::cos(0.5 * y) - std::cos(0.2 * x + 0.1 * y));
    }
    return h;
  }();
  return gap;
}

// A context that has the plugin, and a contact on it.
class Contact {
 public:
  explicit Contact(double memory_limit = 1048576) {
    const rc_context_config config = {sizeof config, RC_CONTEXT_NO_PLUGINS, 0, nullptr, nullptr, nullptr};
    assert_int_equal(rc_context_create(&config, &context_), RC_OK);
    const rc_plugin* plugin = nullptr;
    assert_int_equal(rc_builtin_cuda_host(nullptr, &plugin), RC_OK);
    assert_int_equal(rc_context_register(context_, plugin), RC_OK);
    assert_int_equal(rc_options_create(context_, &options_), RC_OK);
    assert_int_equal(rc_options_set_real(options_, "cuda-host.memory_limit", memory_limit), RC_OK);
    use("haar-cuda-host", "cuda-host");
    rc_system system = support::unit_system();
    system.nx = system.ny = side;
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
    rc_step step = RC_STEP_INIT;
    step.control = RC_CONTROL_DISPLACEMENT;
    step.target = 0.6;
    step.warm_start = 0;
    step.undeformed_gap = hills().data();
    rc_result result{};
    result.struct_size = sizeof result;
    result.p = p.data();
    const rc_status status = rc_contact_solve(contact_, &step, &result);
    words_ = rc_last_error();
    return status;
  }
  const std::string& words() const { return words_; }

 private:
  rc_context* context_ = nullptr;
  rc_options* options_ = nullptr;
  rc_contact* contact_ = nullptr;
  std::string words_;
};

void expect_untouched(const std::vector<double>& p) {
  for (const double value : p) assert_true(value == untouched);
}

void goes_on_elsewhere(Contact& contact) {
  std::vector<double> p;
  contact.use("haar-cg", "dense");
  assert_int_equal(contact.solve(p), RC_OK);
}

void expect_words(const Contact& contact, const char* words) {
  if (contact.words().find(words) == std::string::npos) fail_msg("\"%s\" does not have \"%s\"", contact.words().c_str(), words);
}

std::int64_t calls_of_a_solve() {
  Contact contact;
  std::vector<double> p;
  host_faults() = {.fault = Fault::once, .at = 0};
  assert_int_equal(contact.solve(p), RC_OK);
  const std::int64_t calls = host_faults().calls;
  host_faults() = {};
  return calls;
}

// Each of the first calls, and later ones at growing distances.
void any_call_may_fail(void**) {
  const std::int64_t all = calls_of_a_solve();
  int failures = 0;
  for (const Fault fault : {Fault::once, Fault::lost})
    for (std::int64_t k = 1; k <= all; k += 1 + k / 16) {
      Contact contact;
      std::vector<double> p;
      host_faults() = {.fault = fault, .at = k};
      const rc_status status = contact.solve(p);
      host_faults() = {};
      if (status != RC_ERR_EXTERNAL) fail_msg("call %lld of %lld: status %d", (long long)k, (long long)all, status);
      expect_words(contact, fault == Fault::lost ? "the device is lost" : "the kernel failed");
      expect_words(contact, "cuda-host: ");
      expect_untouched(p);
      // The device again, where it was one kernel that failed; another backend in any case.
      if (fault == Fault::once) assert_int_equal(contact.solve(p), RC_OK);
      goes_on_elsewhere(contact);
      ++failures;
    }
  std::printf("%d of %lld calls failed, one at a time\n", failures, static_cast<long long>(all));
}

void a_missing_device_is_told_in_the_drivers_words(void**) {
  for (const char* reason :
       {"no CUDA-capable device is detected", "CUDA driver version is insufficient for CUDA runtime version"}) {
    Contact contact;
    std::vector<double> p;
    host_faults() = {.device = reason};
    assert_int_equal(contact.solve(p), RC_ERR_EXTERNAL);
    host_faults() = {};
    expect_words(contact, reason);
    expect_untouched(p);
    goes_on_elsewhere(contact);
  }
}

// The bytes are told before anything is allocated.
void too_little_memory_is_told_in_bytes(void**) {
  for (const bool by_limit : {true, false}) {
    Contact contact(by_limit ? 0.01 : 1048576);
    std::vector<double> p;
    if (!by_limit) host_faults() = {.memory = 16384};
    assert_int_equal(contact.solve(p), RC_ERR_MEMORY);
    assert_int_equal(host_faults().allocated, 0);
    host_faults() = {};
    expect_words(contact, "bytes");
    expect_words(contact, by_limit ? "cuda-host.memory_limit" : "on device 0");
    expect_untouched(p);
    goes_on_elsewhere(contact);
  }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(any_call_may_fail),
                              cmocka_unit_test(a_missing_device_is_told_in_the_drivers_words),
                              cmocka_unit_test(too_little_memory_is_told_in_bytes)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}

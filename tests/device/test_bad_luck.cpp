// What can go wrong with a device: each time a status, the driver's words, pressures that are not touched, and a contact that
// goes on with another backend.
#include <cstdio>
#include <roughcontact/plugin.hpp>

#include "lengths.h"
#include "scene.h"

namespace {

using namespace device;
using rc_cuda::Fault, rc_cuda::host_faults;

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

// Places are found by 32-bit divisions: all numbers of a pass must have one.
void grids_beyond_what_a_pass_counts_are_refused(void**) {
  constexpr rc_cuda::Index k = 1024;
  for (const rc_cuda::Index side : {32 * k, 44 * k}) assert_true(rc_cuda::free_torus(side, side).height >= 2 * side - 1);
  assert_int_equal(rc_cuda::periodic_torus(32 * k, 64 * k).height, 64 * k);
  const auto refused = [](const auto& make) {
    try {
      make();
    } catch (const roughcontact::Failure& failure) {
      return failure.code == RC_ERR_SHAPE && failure.message.find("4294967295") != std::string::npos;
    }
    return false;
  };
  assert_true(refused([] { rc_cuda::free_torus(48 * k, 48 * k); }));
  assert_true(refused([] { rc_cuda::periodic_torus(64 * k, 64 * k); }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(any_call_may_fail), cmocka_unit_test(a_missing_device_is_told_in_the_drivers_words),
      cmocka_unit_test(too_little_memory_is_told_in_bytes), cmocka_unit_test(grids_beyond_what_a_pass_counts_are_refused)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}

// What can go wrong with a device: each time a status, the driver's words, pressures that are not touched, and a contact that
// goes on with another backend.
#include <roughcontact/derivatives.h>

#include <cstdio>
#include <cstring>
#include <roughcontact/plugin.hpp>

#include "lengths.h"
#include "scene.h"

namespace {

using namespace device;
using rc_cuda::Fault, rc_cuda::host_faults;

// Each of the first calls, and later ones at growing distances.
void any_call_may_fail(void**) {
  const auto solved = [](Contact& contact, Fault fault, std::int64_t at) {
    std::vector<double> p;
    const rc_status status = with_fault(fault, at, [&] { return contact.solve(p); });
    if (status != RC_OK) expect_untouched(p);
    return status;
  };
  {
    Contact contact;
    assert_int_equal(solved(contact, Fault::once, 0), RC_OK);
  }
  const std::int64_t all = last_calls();
  int failures = 0;
  for (const Fault fault : {Fault::once, Fault::lost})
    for (std::int64_t k = 1; k <= all; k += 1 + k / 16) {
      Contact contact;
      const rc_status status = solved(contact, fault, k);
      if (status != RC_ERR_EXTERNAL) fail_msg("call %lld of %lld: status %d", (long long)k, (long long)all, status);
      expect_failed(contact, fault);
      expect_words(contact, "cuda-host: ");
      // The device again, where it was one kernel that failed; another backend in any case.
      if (fault == Fault::once) assert_int_equal(solved(contact, Fault::once, 0), RC_OK);
      goes_on_elsewhere(contact);
      ++failures;
    }
  std::printf("%d of %lld calls failed, one at a time\n", failures, static_cast<long long>(all));
}

void a_missing_device_is_told_in_the_drivers_words(void**) {
  for (const char* reason : {"no CUDA-capable device is detected", "CUDA driver version is insufficient for CUDA runtime version",
                             "system not yet initialized", "all CUDA-capable devices are busy or unavailable"}) {
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

// The bytes are known before anything is allocated.
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

// A cold step begins on a coarser grid. Where that alone fails, it begins without.
void coarser_grids_may_fail(void**) {
  constexpr std::int64_t n = 130;
  const std::vector<double> gap = hills_of(n);
  std::vector<double> p(gap.size());
  rc_step step = cold_step();
  step.undeformed_gap.data = gap.data();
  rc_result result = RC_RESULT_INIT;
  result.p.data = p.data();
  const auto solved = [&](Contact& contact, Fault fault, std::int64_t at) {
    p.assign(gap.size(), untouched);
    return with_fault(fault, at, [&] { return contact.solve(step, result); });
  };
  std::int64_t without = 0;
  {
    Contact contact(1048576, n);
    assert_int_equal(solved(contact, Fault::once, 0), RC_OK);
  }
  const std::int64_t all = last_calls();
  const std::vector<double> wanted = p;
  for (const Fault fault : {Fault::once, Fault::lost})
    for (std::int64_t k = 1; k <= all; k += 23) {
      Contact contact(1048576, n);
      const rc_status status = solved(contact, fault, k);
      if (fault == Fault::once && status == RC_OK) {
        for (std::size_t i = 0; i < p.size(); ++i) assert_true(std::abs(p[i] - wanted[i]) < 1e-6);
        ++without;
        continue;
      }
      assert_int_equal(status, RC_ERR_EXTERNAL);
      expect_failed(contact, fault);
      expect_untouched(p);
    }
  assert_true(without > 0);
}

// Derivatives of a step make products on the device.
void derivatives_may_fail(void**) {
  for (const bool of_tangent : {false, true}) {
    Contact contact;
    std::vector<double> p, weight(hills().size(), 1), out(hills().size());
    assert_int_equal(contact.solve(p), RC_OK);
    const auto derive = [&] {
      out.assign(hills().size(), untouched);
      rc_gradient gradient = RC_GRADIENT_INIT;
      gradient.dJ_dp = RC_IN(weight.data());
      gradient.dJ_dundeformed_gap = RC_OUT(out.data());
      rc_tangent tangent = RC_TANGENT_INIT;
      tangent.dundeformed_gap = RC_IN(weight.data());
      tangent.dp = RC_OUT(out.data());
      return of_tangent ? rc_contact_tangent(contact.get(), &tangent) : rc_contact_gradient(contact.get(), &gradient);
    };
    assert_int_equal(with_fault(Fault::once, 0, derive), RC_OK);
    const std::int64_t all = last_calls();
    const std::vector<double> wanted = out;
    assert_true(all > 10);
    for (std::int64_t k = 1; k <= all; k += 1 + k / 8) {
      assert_int_equal(with_fault(Fault::once, k, derive), RC_ERR_EXTERNAL);
      assert_non_null(std::strstr(rc_last_error(), "the kernel failed"));
      expect_untouched(out);
      assert_int_equal(derive(), RC_OK);
      for (std::size_t i = 0; i < out.size(); ++i) assert_true(std::abs(out[i] - wanted[i]) <= 1e-6 * (1 + std::abs(wanted[i])));
    }
  }
}

void auto_passes_over_a_device_that_fails(void**) {
  for (const Fault fault : {Fault::none, Fault::once, Fault::lost}) {
    Contact contact(1048576, side, cheap<false>());
    contact.use("auto", "auto");
    std::vector<double> p(hills().size());
    rc_step step = cold_step();
    step.undeformed_gap.data = hills().data();
    rc_result result = RC_RESULT_INIT;
    result.p.data = p.data();
    if (with_fault(fault, 60, [&] { return contact.solve(step, result); }) != RC_OK) fail_msg("%s", contact.words().c_str());
    const bool on_device = std::string(result.backend) == "cuda-host" && std::string(result.solver) == "haar-cuda-host";
    assert_true(on_device == (fault == Fault::none));
    assert_true((std::string(result.note).find("cuda-host") != std::string::npos) == (fault != Fault::none));
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
  const CMUnitTest tests[] = {cmocka_unit_test(any_call_may_fail),
                              cmocka_unit_test(a_missing_device_is_told_in_the_drivers_words),
                              cmocka_unit_test(too_little_memory_is_told_in_bytes),
                              cmocka_unit_test(coarser_grids_may_fail),
                              cmocka_unit_test(derivatives_may_fail),
                              cmocka_unit_test(auto_passes_over_a_device_that_fails),
                              cmocka_unit_test(grids_beyond_what_a_pass_counts_are_refused)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}

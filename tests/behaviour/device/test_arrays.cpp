// Arrays in the memory of a device: the host build has addresses there that nothing else can read.
#include <algorithm>
#include <cstdio>
#include <cstring>

#include "scene.h"

namespace {

using namespace device;
using rc_cuda::Fault, rc_cuda::host_faults;

constexpr char memory[] = "cuda-host";
constexpr std::int64_t points = side * side;

template <class Value> class OnDevice {
 public:
  explicit OnDevice(std::vector<Value> values) : values_(std::move(values)) {}
  explicit OnDevice(Value value) : values_(static_cast<std::size_t>(points), value) {}
  Value* at() { return reinterpret_cast<Value*>(reinterpret_cast<std::uintptr_t>(values_.data()) + rc_cuda::device_addresses); }
  const std::vector<Value>& values() const { return values_; }

 private:
  std::vector<Value> values_;
};

const std::vector<float>& hills_in_single() {
  static const std::vector<float> gap(hills().begin(), hills().end());
  return gap;
}

struct Answer {
  std::vector<double> p, gap;
  rc_result result = RC_RESULT_INIT;
};

// The arrays on the host.
Answer host_answer(Contact& contact, rc_step step, rc_status wanted = RC_OK) {
  Answer answer;
  answer.p.assign(points, untouched);
  answer.gap.assign(points, untouched);
  answer.result.p.data = answer.p.data();
  answer.result.gap.data = answer.gap.data();
  if (contact.solve(step, answer.result) != wanted) fail_msg("%s", contact.words().c_str());
  return answer;
}

rc_step pressed_on_host() {
  rc_step step = cold_step();
  step.undeformed_gap.data = hills().data();
  return step;
}

template <class Value> rc_array on_device(OnDevice<Value>& array) {
  return {array.at(), std::is_same_v<Value, float> ? RC_SINGLE : RC_NATIVE, 0, memory};
}
rc_const_array read_only(const rc_array& array) { return {array.data, array.type, 0, array.memory}; }

rc_step pressed_on_device(OnDevice<double>& gap) {
  rc_step step = cold_step();
  step.undeformed_gap = read_only(on_device(gap));
  return step;
}

// Bytes that a solve moves.
struct Travelled {
  std::int64_t to_device, to_host;
};
template <class Act> Travelled travelled(const Act& act) {
  host_faults() = {.counts = true};
  act();
  const Travelled all{host_faults().to_device, host_faults().to_host};
  host_faults() = {};
  return all;
}

void answers_are_those_of_arrays_on_the_host(void**) {
  for (const std::int32_t control : {RC_CONTROL_APPROACH, RC_CONTROL_LOAD})
    for (const char* solver : {"haar-cuda-host", "haar-cg", "nnls"}) {
      Contact there, here;
      for (Contact* each : {&there, &here}) each->use(solver, solver == std::string("nnls") ? "dense" : "cuda-host");
      OnDevice<double> gap(hills()), p(untouched), deformed(untouched);
      rc_step step = pressed_on_device(gap);
      step.control = control;
      step.target = control == RC_CONTROL_LOAD ? 3 : 0.6;
      rc_result result = RC_RESULT_INIT;
      result.p = on_device(p);
      result.gap = on_device(deformed);
      if (there.solve(step, result) != RC_OK) fail_msg("%s: %s", solver, there.words().c_str());
      assert_ptr_equal(result.p.data, p.at());
      assert_ptr_equal(result.gap.data, deformed.at());
      step.undeformed_gap = {hills().data(), RC_NATIVE, 0, nullptr};
      const Answer wanted = host_answer(here, step);
      assert_true(p.values() == wanted.p && deformed.values() == wanted.gap && result.load == wanted.result.load);
    }
}

void single_precision_starts_and_masks_are_taken_too(void**) {
  Contact there, here;
  std::vector<std::uint8_t> excluded(points, 1);
  std::fill_n(excluded.begin() + 200, 40, std::uint8_t{0});
  std::vector<float> with_holes(hills_in_single());
  std::fill_n(with_holes.begin() + 200, 40, std::nanf(""));
  OnDevice<float> gap(with_holes), p(-7.0F), deformed(-7.0F);
  OnDevice<double> start(0.01);
  OnDevice<std::uint8_t> mask(excluded);
  rc_step step = cold_step();
  step.undeformed_gap = read_only(on_device(gap));
  step.p0 = read_only(on_device(start));
  step.mask = read_only(on_device(mask));
  rc_result result = RC_RESULT_INIT;
  result.p = on_device(p);
  result.gap = on_device(deformed);
  if (there.solve(step, result) != RC_OK) fail_msg("%s", there.words().c_str());
  step.undeformed_gap = {with_holes.data(), RC_SINGLE, 0, nullptr};
  step.p0 = {start.values().data(), RC_NATIVE, 0, nullptr};
  step.mask = {excluded.data(), RC_NATIVE, 0, nullptr};
  const Answer wanted = host_answer(here, step);
  for (std::size_t i = 0; i < points; ++i) {
    assert_true(p.values()[i] == static_cast<float>(wanted.p[i]));
    assert_true(std::isnan(wanted.gap[i]) ? excluded[i] == 0 : deformed.values()[i] == static_cast<float>(wanted.gap[i]));
  }
}

// A step's gap goes to the host, where it is certified, and need not come back. That holds for parts of the grid, too.
void a_solver_of_the_device_reads_the_gap_where_it_is(void**) {
  for (const std::int32_t control : {RC_CONTROL_LOAD, RC_CONTROL_APPROACH}) {
    Contact here, there;
    OnDevice<double> gap(hills());
    const auto of = [&](rc_step step) {
      step.control = control;
      step.target = control == RC_CONTROL_LOAD ? 3 : 0.6;
      return step;
    };
    rc_step step = of(pressed_on_host());
    const Travelled usual = travelled([&] { host_answer(here, step); });
    step = of(pressed_on_device(gap));
    step.borrow = 1;
    const Travelled direct = travelled([&] { host_answer(there, step); });
    const std::int64_t saved = usual.to_device - direct.to_device;
    assert_int_equal(direct.to_host - usual.to_host, points * 8);
    assert_true(saved > points * 4 && saved <= points * 8);
    // A later step may still read it, where it was lent for longer than a step.
    step = of(cold_step());
    const auto next = [&](Contact& contact) { return travelled([&] { host_answer(contact, step); }); };
    assert_int_equal(next(here).to_device - next(there).to_device, saved);
    host_answer(there, of(pressed_on_device(gap)));
    assert_int_equal(next(here).to_device, next(there).to_device);
    const auto share = [](std::int64_t bytes) { return static_cast<double>(bytes) / points; };
    std::printf("bytes a point to the device and back: gap on the host %.1f and %.1f, on the device %.1f and %.1f\n",
                share(usual.to_device), share(usual.to_host), share(direct.to_device), share(direct.to_host));
  }
}

void pressures_on_the_device_are_certified(void**) {
  Contact there, here;
  Answer answer = host_answer(here, pressed_on_host());
  OnDevice<double> gap(hills()), p(answer.p), deformed(untouched), wrong(0.5);
  rc_step step = pressed_on_host();
  assert_int_equal(rc_contact_certify(here.get(), &step, &answer.result), RC_OK);
  step = pressed_on_device(gap);
  rc_result result = RC_RESULT_INIT;
  result.p = on_device(p);
  result.gap = on_device(deformed);
  assert_int_equal(rc_contact_certify(there.get(), &step, &result), RC_OK);
  assert_true(p.values() == answer.p && deformed.values() == answer.gap);
  result.p.data = wrong.at();
  assert_int_not_equal(rc_contact_certify(there.get(), &step, &result), RC_OK);
}

void what_is_not_on_a_device_is_refused(void**) {
  const std::vector<double> here(hills());
  const struct {
    const char* memory;
    const double* gap;
    rc_status status;
    const char* words;
  } cases[] = {{"dense", here.data(), RC_ERR_INCOMPATIBLE, "no device with a memory of its own"},
               {"nowhere", here.data(), RC_ERR_NO_BACKEND, "nowhere"},
               {memory, here.data(), RC_ERR_ARGUMENT, "is not an address in the memory of device 0"}};
  for (const auto& each : cases)
    for (const bool of_result : {false, true}) {
      Contact contact;
      std::vector<double> p(points, untouched);
      rc_step step = pressed_on_host();
      rc_result result = RC_RESULT_INIT;
      result.p.data = p.data();
      if (of_result)
        result.p.memory = each.memory;
      else
        step.undeformed_gap.memory = each.memory;
      assert_int_equal(contact.solve(step, result), each.status);
      expect_words(contact, each.words);
      if (each.status == RC_ERR_INCOMPATIBLE)
        expect_words(contact, of_result ? "rc_result.p.memory" : "rc_step.undeformed_gap.memory");
      expect_untouched(p);
      assert_int_equal(contact.solve(p), RC_OK);
    }
}

// What is refused leaves the surface of the step before, which is a copy of what was on a device.
void a_refused_step_keeps_the_gap_of_the_one_before(void**) {
  Contact contact;
  OnDevice<double> gap(hills()), spoilt(std::nan(""));
  const Answer before = host_answer(contact, pressed_on_device(gap));
  host_answer(contact, pressed_on_device(spoilt), RC_ERR_ARGUMENT);
  expect_words(contact, "not finite");
  rc_step step = cold_step();
  const Answer after = host_answer(contact, step);
  assert_true(before.p == after.p);
  assert_int_equal(rc_contact_reset(contact.get()), RC_OK);
  host_answer(contact, step, RC_ERR_ARGUMENT);
  expect_words(contact, "no earlier step gave one");
}

void copies_may_fail(void**) {
  for (const Fault fault : {Fault::once, Fault::lost})
    for (const std::int64_t call : {1, 2, 3}) {
      Contact contact;
      OnDevice<double> gap(hills()), p(untouched);
      rc_result result = RC_RESULT_INIT;
      result.p = on_device(p);
      assert_int_equal(with_fault(fault, call, [&] { return contact.solve(pressed_on_device(gap), result); }), RC_ERR_EXTERNAL);
      expect_failed(contact, fault);
      expect_untouched(p.values());
      goes_on_elsewhere(contact);
    }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(answers_are_those_of_arrays_on_the_host),
                              cmocka_unit_test(single_precision_starts_and_masks_are_taken_too),
                              cmocka_unit_test(a_solver_of_the_device_reads_the_gap_where_it_is),
                              cmocka_unit_test(pressures_on_the_device_are_certified),
                              cmocka_unit_test(what_is_not_on_a_device_is_refused),
                              cmocka_unit_test(a_refused_step_keeps_the_gap_of_the_one_before),
                              cmocka_unit_test(copies_may_fail)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}

// Contacts of one context with the same system share what depends on the system alone, with the bits of a contact alone.
#include <malloc.h>
#include <roughcontact/plugin.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "support/cmocka.hpp"
#include "support/unit_system.h"

namespace {

constexpr std::int64_t side = 64;

struct Destroy {
  void operator()(rc_context* context) const { rc_context_destroy(context); }
  void operator()(rc_options* options) const { rc_options_destroy(options); }
  void operator()(rc_contact* contact) const { rc_contact_destroy(contact); }
};
template <class T> using Owned = std::unique_ptr<T, Destroy>;

Owned<rc_context> context() {
  rc_context* made = nullptr;
  assert_int_equal(rc_context_create(0, nullptr, nullptr, nullptr, &made), RC_OK);
  return Owned<rc_context>(made);
}

struct Setting {
  const char* key;
  const char* value;
};

Owned<rc_contact> contact(rc_context* in, const std::vector<Setting>& settings, double pitch = 1,
                          std::int32_t boundary = RC_BOUNDARY_FREE) {
  rc_options* options = nullptr;
  if (rc_options_create(in, &options) != RC_OK) return nullptr;
  const Owned<rc_options> owned(options);
  for (const Setting& each : settings)
    if (rc_options_set_text(options, each.key, each.value) != RC_OK) return nullptr;
  rc_system system = support::unit_system();
  system.nx = system.ny = side;
  system.hx = pitch;
  system.boundary = boundary;
  rc_contact* made = nullptr;
  rc_contact_create(&system, options, &made);
  return Owned<rc_contact>(made);
}

// Hills of several widths, some two to six percent of which touch below.
const std::vector<double>& hills() {
  static const std::vector<double> gap = [] {
    std::vector<double> z;
    for (std::int64_t i = 0; i < side * side; ++i) {
      const double x = static_cast<double>(i % side), y = static_cast<double>(i / side);
      z.push_back(3.2 - std::cos(0.9 * x) * std::cos(0.5 * y) - std::cos(0.2 * x + 0.1 * y) - 0.6 * std::cos(1.7 * x - 1.1 * y));
    }
    const double lowest = *std::min_element(z.begin(), z.end());
    for (double& value : z) value -= lowest;
    return z;
  }();
  return gap;
}

struct Answer {
  rc_status status = RC_OK;
  std::vector<double> p;
  double load = 0, stiffness = 0;
  std::int64_t points = 0;
  bool operator==(const Answer&) const = default;
};

Answer pressed(rc_contact* contact, double approach) {
  Answer answer;
  answer.p.resize(static_cast<std::size_t>(side * side));
  rc_step step = RC_STEP_INIT;
  step.control = RC_CONTROL_APPROACH;
  step.target = approach;
  step.undeformed_gap.data = hills().data();
  rc_result result = RC_RESULT_INIT;
  result.p.data = answer.p.data();
  answer.status = contact ? rc_contact_solve(contact, &step, &result) : RC_ERR_ARGUMENT;
  answer.load = result.load;
  answer.stiffness = std::isnan(result.stiffness) ? 0 : result.stiffness;
  answer.points = result.contacts;
  return answer;
}

// Two steps, the second one warm.
std::vector<Answer> history(rc_contact* contact) { return {pressed(contact, 0.9), pressed(contact, 1.0)}; }

double bytes_in_use() {
  const struct mallinfo2 all = mallinfo2();
  return static_cast<double>(all.uordblks + all.hblkhd);
}

// Bytes that one contact more takes, beyond what is shared, after a step with 2.7 percent of the points in contact.
double bytes_of_one_more(const std::vector<Setting>& settings) {
  constexpr int more = 40;
  const Owned<rc_context> shared = context();
  std::vector<Owned<rc_contact>> all;
  double before = 0;
  for (int i = 0; i <= more; ++i) {
    all.push_back(contact(shared.get(), settings));
    const Answer answer = pressed(all.back().get(), 1.25);
    assert_int_equal(answer.status, RC_OK);
    assert_in_range(static_cast<std::uint64_t>(answer.points), 100, 120);
    if (i == 0) before = bytes_in_use();
  }
  return (bytes_in_use() - before) / more;
}

void each_contact_takes_little(void**) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  skip();
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
  skip();
#endif
#endif
  const auto check = [](double most, const std::vector<Setting>& settings) {
    const double bytes = bytes_of_one_more(settings);
    print_message("%-5s %s: %.0f bytes\n", settings[0].value, settings[1].value, bytes);
    assert_true(bytes < most);
  };
  check(60e3, {{"backend", "dense"}, {"resumable", "1"}, {"stiffness", "1"}});
  check(60e3, {{"backend", "fft"}, {"resumable", "0"}, {"stiffness", "1"}});
  // The solver's factor stays, for the next step: half of 110 squared numbers.
  check(120e3, {{"backend", "dense"}, {"resumable", "0"}, {"stiffness", "1"}});
}

void the_bits_are_those_of_a_contact_alone(void**) {
  for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC})
    for (const char* const backend : {"dense", "fft", "split"}) {
      if (boundary == RC_BOUNDARY_PERIODIC && std::string(backend) == "split") continue;
      const std::vector<Setting> settings = {{"backend", backend}, {"stiffness", "1"}};
      const Owned<rc_context> alone = context(), shared = context();
      const std::vector<Answer> expected = history(contact(alone.get(), settings, 1, boundary).get());
      assert_int_equal(expected[1].status, RC_OK);
      const Owned<rc_contact> a = contact(shared.get(), settings, 1, boundary), b = contact(shared.get(), settings, 1, boundary);
      const Owned<rc_contact> wider = contact(shared.get(), settings, 1.5, boundary);
      for (std::size_t k = 0; k < 2; ++k)
        for (rc_contact* const each : {a.get(), b.get(), wider.get()}) {
          const Answer answer = pressed(each, k == 0 ? 0.9 : 1.0);
          if (each == wider.get())
            assert_true(answer.load != expected[k].load);
          else
            assert_true(answer == expected[k]);
        }
    }
}

// A kernel that counts the coefficients that it is asked for.
std::atomic<std::int64_t> asked{0};

rc_status counted_window(const rc_host*, const rc_kernel_spec* spec, std::int64_t first_x, std::int64_t first_y, std::int64_t mx,
                         std::int64_t my, double* out) {
  asked += mx * my;
  for (std::int64_t iy = first_y; iy < first_y + my; ++iy)
    for (std::int64_t ix = first_x; ix < first_x + mx; ++ix)
      *out++ = std::exp(-std::hypot(spec->system->hx * static_cast<double>(ix), spec->system->hy * static_cast<double>(iy)));
  return RC_OK;
}

void contacts_of_another_system_do_not_share(void**) {
  static const rc_kernel kernel = {.struct_size = sizeof(rc_kernel),
                                   .name = "counted",
                                   .summary = "a test's",
                                   .license = "BSD-3-Clause",
                                   .caps = RC_KERNEL_FREE | RC_KERNEL_POSITIVE,
                                   .n_options = 0,
                                   .options = nullptr,
                                   .window = counted_window,
                                   .symbol = nullptr,
                                   .bounds = nullptr,
                                   .user = nullptr};
  static const rc_kernel* const kernels[] = {&kernel};
  static const rc_plugin plugin = {.struct_size = sizeof(rc_plugin),
                                   .abi_major = RC_PLUGIN_ABI_MAJOR,
                                   .abi_minor = RC_PLUGIN_ABI_MINOR,
                                   .name = "counted",
                                   .version = "1.0",
                                   .n_kernels = 1,
                                   .kernels = kernels};
  const Owned<rc_context> shared = context();
  assert_int_equal(rc_context_register(shared.get(), &plugin), RC_OK);
  const std::vector<Setting> settings = {{"kernel", "counted"}, {"backend", "dense"}, {"certify_backend", "dense"}};
  const auto windows_of = [&](double pitch, Owned<rc_contact>& made) {
    asked = 0;
    made = contact(shared.get(), settings, pitch);
    assert_int_equal(pressed(made.get(), 0.5).status, RC_OK);
    return asked.load();
  };
  Owned<rc_contact> first, same, other, again;
  const std::int64_t alone = windows_of(1, first);
  assert_true(alone > side * side);
  assert_true(windows_of(1, same) < alone / 8);  // each contact looks at a small patch itself
  assert_int_equal(windows_of(1.5, other), alone);
  // What nobody holds is gone.
  other.reset();
  assert_int_equal(windows_of(1.5, again), alone);
}

void contacts_come_and_go_on_two_threads(void**) {
  const std::vector<std::vector<Setting>> all = {{{"backend", "dense"}, {"stiffness", "1"}}, {{"backend", "fft"}}};
  Owned<rc_context> shared = context();
  std::vector<std::vector<Answer>> expected;
  for (const auto& settings : all) expected.push_back(history(contact(shared.get(), settings).get()));
  std::atomic<int> wrong{0};
  const auto work = [&](std::size_t begin) {
    Owned<rc_contact> older;  // overlaps with the next one, so that objects are held and dropped in turns
    for (std::size_t k = 0; k < 8; ++k) {
      const std::size_t which = (begin + k / 2) % all.size();
      Owned<rc_contact> next = contact(shared.get(), all[which]);
      if (history(next.get()) != expected[which]) ++wrong;
      older = std::move(next);
    }
  };
  std::thread other(work, 1);
  work(0);
  other.join();
  assert_int_equal(wrong.load(), 0);
}

void a_context_may_go_before_its_contacts(void**) {
  Owned<rc_context> shared = context();
  const std::vector<Setting> settings = {{"backend", "dense"}};
  Owned<rc_contact> a = contact(shared.get(), settings), b = contact(shared.get(), settings);
  shared.reset();
  const std::vector<Answer> first = history(a.get());
  assert_int_equal(first[1].status, RC_OK);
  a.reset();
  assert_true(history(b.get()) == first);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(each_contact_takes_little),
      cmocka_unit_test(the_bits_are_those_of_a_contact_alone),
      cmocka_unit_test(contacts_of_another_system_do_not_share),
      cmocka_unit_test(contacts_come_and_go_on_two_threads),
      cmocka_unit_test(a_context_may_go_before_its_contacts),
  };
  return cmocka_run_group_tests_name("sharing", tests, nullptr, nullptr);
}

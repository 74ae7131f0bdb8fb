// Contacts of one context with the same system share what depends on the system alone, with the bits of a contact alone.
#include <malloc.h>
#include <roughcontact/plugin.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <thread>

#include "support/contact.h"

namespace {

using namespace pairs;

constexpr std::int64_t side = 64;

Context context() {
  rc_context* made = nullptr;
  check(rc_context_create(0, nullptr, nullptr, nullptr, &made) == RC_OK, rc_last_error());
  return Context(made);
}

// Hills of several widths, some two to six percent of which touch below.
Problem hills(double pitch = 1, std::int32_t boundary = RC_BOUNDARY_FREE) {
  static const Field gap = [] {
    Field z;
    for (std::int64_t i = 0; i < side * side; ++i) {
      const double x = static_cast<double>(i % side), y = static_cast<double>(i / side);
      z.push_back(3.2 - std::cos(0.9 * x) * std::cos(0.5 * y) - std::cos(0.2 * x + 0.1 * y) - 0.6 * std::cos(1.7 * x - 1.1 * y));
    }
    const double lowest = *std::ranges::min_element(z);
    for (double& value : z) value -= lowest;
    return z;
  }();
  Problem problem;
  problem.system.nx = problem.system.ny = side;
  problem.system.hx = pitch;
  problem.system.boundary = boundary;
  problem.gap = gap;
  return problem;
}

using Owned = std::unique_ptr<Contact>;
Owned contact(const Context& in, const Problem& problem, const char* backend, const Settings& settings = {}) {
  return std::make_unique<Contact>(problem, Pair{"auto", backend}, settings, in.get());
}

Answer pressed(const Contact& contact, double approach) {
  static const Problem problem = hills();
  rc_step step = problem.step();
  step.target = approach;
  Answer answer = contact.solve(step);
  check_status(answer, RC_OK);
  return answer;
}

void check_same(const Answer& a, const Answer& b) {
  pairs::check_same(a.p, b.p, "p");
  pairs::check_same({a.result.load, a.result.stiffness}, {b.result.load, b.result.stiffness}, "load, stiffness");
}

// Two steps, the second one warm.
std::vector<Answer> history(const Contact& contact) { return {pressed(contact, 0.9), pressed(contact, 1.0)}; }

double bytes_in_use() {
  const struct mallinfo2 all = mallinfo2();
  return static_cast<double>(all.uordblks + all.hblkhd);
}

// Bytes that one contact more takes, beyond what is shared, after a step with 2.7 percent of the points in contact.
double bytes_of_one_more(const char* backend, const Settings& settings) {
  constexpr int more = 40;
  const Problem problem = hills();
  const Context shared = context();
  std::vector<Owned> all;
  double before = 0;
  for (int i = 0; i <= more; ++i) {
    all.push_back(contact(shared, problem, backend, settings));
    const std::int64_t contacts = pressed(*all.back(), 1.25).result.contacts;
    check(contacts >= 100 && contacts <= 120, "points in contact");
    if (i == 0) before = bytes_in_use();
  }
  return (bytes_in_use() - before) / more;
}

void each_contact_takes_little() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  throw Skipped("the sanitizer has its own memory");
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
  throw Skipped("the sanitizer has its own memory");
#endif
#endif
  const auto little = [](double most, const char* backend, const Settings& settings) {
    const double bytes = bytes_of_one_more(backend, settings);
    check(bytes < most, std::string(backend) + ": " + text(bytes) + " bytes");
  };
  little(60e3, "dense", {{"resumable", "1"}, {"stiffness", "1"}});
  little(60e3, "fft", {{"resumable", "0"}, {"stiffness", "1"}});
  // The solver's factor stays, for the next step: half of 110 squared numbers.
  little(120e3, "dense", {{"resumable", "0"}, {"stiffness", "1"}});
}

void the_bits_are_those_of_a_contact_alone() {
  const Settings settings = {{"stiffness", "1"}};
  for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC})
    for (const char* const backend : {"dense", "fft", "split"}) {
      if (boundary == RC_BOUNDARY_PERIODIC && std::string(backend) == "split") continue;
      const Context alone = context(), shared = context();
      const Problem problem = hills(1, boundary);
      const std::vector<Answer> expected = history(*contact(alone, problem, backend, settings));
      const Owned a = contact(shared, problem, backend, settings), b = contact(shared, problem, backend, settings);
      const Owned wider = contact(shared, hills(1.5, boundary), backend, settings);
      for (std::size_t k = 0; k < 2; ++k) {
        const double approach = k == 0 ? 0.9 : 1.0;
        check_same(pressed(*a, approach), expected[k]);
        check_same(pressed(*b, approach), expected[k]);
        check(pressed(*wider, approach).result.load != expected[k].result.load, "other cells");
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

void contacts_of_another_system_do_not_share() {
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
  const Context shared = context();
  check(rc_context_register(shared.get(), &plugin) == RC_OK, rc_last_error());
  const auto windows_of = [&](double pitch, Owned& made) {
    asked = 0;
    Problem problem = hills(pitch);
    problem.kernel = "counted";
    made = contact(shared, problem, "dense", {{"certify_backend", "dense"}});
    pressed(*made, 0.5);
    return asked.load();
  };
  Owned first, same, other, again;
  const std::int64_t alone = windows_of(1, first);
  check(alone > side * side, "coefficients");
  check(windows_of(1, same) < alone / 8, "shared coefficients");  // each contact looks at a small patch itself
  check_equal(windows_of(1.5, other), alone, "coefficients of other cells");
  // What nobody holds is gone.
  other.reset();
  check_equal(windows_of(1.5, again), alone, "coefficients after the last contact");
}

void contacts_come_and_go_on_two_threads() {
  const auto made = [](const Context& in, std::size_t which) {
    return contact(in, hills(), which == 0 ? "dense" : "fft", {{"stiffness", which == 0 ? "1" : "0"}});
  };
  const Context shared = context();
  const std::vector<Answer> expected[] = {history(*made(shared, 0)), history(*made(shared, 1))};
  std::atomic<int> wrong{0};
  const auto work = [&](std::size_t begin) {
    Owned older;  // overlaps with the next one, so that objects are held and dropped in turns
    for (std::size_t k = 0; k < 8; ++k) {
      const std::size_t which = (begin + k / 2) % 2;
      Owned next = made(shared, which);
      const std::vector<Answer> found = history(*next);
      wrong += found[0].p != expected[which][0].p || found[1].p != expected[which][1].p;
      older = std::move(next);
    }
  };
  std::thread other(work, 1);
  work(0);
  other.join();
  check_equal(wrong.load(), 0, "contacts with other pressures");
}

void a_context_may_go_before_its_contacts() {
  Context shared = context();
  Owned a = contact(shared, hills(), "dense"), b = contact(shared, hills(), "dense");
  shared.reset();
  const std::vector<Answer> first = history(*a);
  a.reset();
  check_same(history(*b)[1], first[1]);
}

}  // namespace

int main(int argc, char** argv) {
  return run_group(
      "sharing",
      RC_TESTS(each_contact_takes_little, the_bits_are_those_of_a_contact_alone, contacts_of_another_system_do_not_share,
               contacts_come_and_go_on_two_threads, a_context_may_go_before_its_contacts),
      argc, argv);
}

// Contacts, options, contexts and messages in eight threads at once.
#include <roughcontact/plugin.h>

#include <atomic>
#include <chrono>
#include <cstring>
#include <thread>

#include "crowd.h"
#include "jobs.h"
#include "support/cmocka.hpp"
#include "support/unit_system.h"

extern "C" rc_status rc_builtin_linked(const rc_host* host, const rc_plugin** out);

namespace {

using namespace threads;

const Job& job_of(int member) { return jobs()[static_cast<std::size_t>(member)]; }

bool has_fft() {
  rc_options* options = nullptr;
  assert_int_equal(rc_options_create(nullptr, &options), RC_OK);
  const bool known = rc_options_set_text(options, "fft.precision", "mixed") == RC_OK;
  rc_options_destroy(options);
  return known;
}

// First one after the other, for the expected results; then all at once, each set of options read by two threads.
void eight_contacts_at_once_give_the_bits_of_each_alone(void**) {
  if (!has_fft()) skip();
  std::vector<Options> shared;
  std::vector<Sequence> alone;
  for (const Job& job : jobs()) {
    shared.push_back(options_for(job, nullptr));
    assert_non_null(shared.back().get());
    alone.push_back(solve(job, shared.back().get()));
    if (!alone.back().complaint.empty()) print_error("%s\n", alone.back().complaint.c_str());
    assert_true(alone.back().complaint.empty());
  }
  for (int round = 0; round < rounds(8); ++round)
    together([&](int member) -> std::string {
      for (const int which : {member, (member + 1) % crowd}) {
        const auto i = static_cast<std::size_t>(which);
        const Sequence sequence = solve(job_of(which), shared[i].get());
        if (!sequence.complaint.empty()) return sequence.complaint;
        if (std::memcmp(sequence.p.data(), alone[i].p.data(), sequence.p.size() * sizeof(double)) != 0)
          return "job " + std::to_string(which) + ": other pressures than alone";
      }
      return {};
    });
}

void contexts_come_and_go_in_every_thread(void**) {
  for (int round = 0; round < rounds(8); ++round)
    together([](int member) -> std::string {
      rc_context* context = nullptr;
      if (const rc_status status = rc_context_create(0, nullptr, nullptr, nullptr, &context); status != RC_OK)
        return complain("rc_context_create", status);
      const Options options = options_for(jobs()[member % 2 == 0 ? 1 : 3], context);
      const bool complete = rc_component_count(context, RC_COMPONENT_BACKEND) >= 2 &&
                            rc_component_count(context, RC_COMPONENT_SOLVER) >= 2 &&
                            rc_component_count(context, RC_COMPONENT_OPTION) >= 10;
      rc_context_destroy(context);  // the options keep what they need
      if (!complete || !options) return "a context lacks components";
      return solve(jobs()[member % 2 == 0 ? 1 : 3], options.get()).complaint;
    });
}

// Whoever comes first loads the plugins; nobody may see half of them.
void a_fresh_context_is_first_used_by_all_threads_at_once(void**) {
  if (!has_fft()) skip();
  for (int round = 0; round < rounds(8); ++round) {
    rc_context* context = nullptr;
    assert_int_equal(rc_context_create(0, nullptr, nullptr, nullptr, &context), RC_OK);
    const std::int64_t expected = rc_component_count(nullptr, RC_COMPONENT_BACKEND);
    together([&](int member) -> std::string {
      if (member % 2 == 0 && rc_component_count(context, RC_COMPONENT_BACKEND) != expected) return "backends are missing";
      const Options options = options_for(job_of(member), context);
      if (!options) return complain("options", RC_ERR_OPTION);
      const std::string complaint = solve(job_of(member), options.get()).complaint;
      return rc_component_count(context, RC_COMPONENT_BACKEND) == expected ? complaint : "backends are missing";
    });
    rc_context_destroy(context);
  }
}

void one_of_eight_registrations_wins(void**) {
  const rc_plugin* plugin = nullptr;
  assert_int_equal(rc_builtin_linked(nullptr, &plugin), RC_OK);
  rc_context* context = nullptr;
  assert_int_equal(rc_context_create(0, nullptr, nullptr, nullptr, &context), RC_OK);
  std::atomic<int> winners{0};
  together([&](int) -> std::string {
    const rc_status status = rc_context_register(context, plugin);
    winners += status == RC_OK;
    return status == RC_OK || status == RC_ERR_PLUGIN ? std::string() : complain("rc_context_register", status);
  });
  rc_context_destroy(context);
  assert_int_equal(winners, 1);
}

struct Watcher {
  std::thread::id thread = std::this_thread::get_id();
  std::int64_t calls = 0, last = 0;
  bool strayed = false;

  static std::int32_t see(const rc_progress* progress, void* user) {
    Watcher& self = *static_cast<Watcher*>(user);
    self.strayed = self.strayed || std::this_thread::get_id() != self.thread || progress->products < self.last;
    self.last = progress->products;
    ++self.calls;
    return 0;
  }
};

void progress_runs_on_the_solving_thread(void**) {
  if (!has_fft()) skip();
  together([](int member) -> std::string {
    const Options options = options_for(job_of(member), nullptr);
    Watcher watcher;
    const std::string complaint = solve(job_of(member), options.get(), Watcher::see, &watcher).complaint;
    if (watcher.calls == 0 || watcher.strayed) return "progress came from another thread, went backwards or did not come";
    return complaint;
  });
}

// An operator that keeps a solver busy until it must stop.
struct Endless {
  std::atomic<bool> running{false};

  static std::int32_t apply(const double* x, double* y, std::int64_t n, void* user) {
    Endless& self = *static_cast<Endless*>(user);
    if (self.running.exchange(true)) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    for (std::int64_t i = 0; i < n; ++i) y[i] = (1 + 1e3 * static_cast<double>(i)) * x[i];
    return 0;
  }
};

void another_thread_cancels(void**) {
  together([](int) -> std::string {
    Endless endless;
    rc_system system = support::unit_system();
    system.op = RC_OPERATOR_CALLBACK;
    system.nx = 2000;
    system.apply = Endless::apply;
    system.user = &endless;
    const std::vector<double> gap(2000, 0.0);
    rc_contact* made = nullptr;
    if (const rc_status status = rc_contact_create(&system, nullptr, &made); status != RC_OK)
      return complain("rc_contact_create", status);
    const Contact contact(made);
    endless.running = false;
    std::thread canceller([&] {
      while (!endless.running) std::this_thread::yield();
      rc_contact_cancel(made);
    });
    rc_step step = RC_STEP_INIT;
    step.control = RC_CONTROL_APPROACH;
    step.undeformed_gap.data = gap.data();
    step.target = 1;
    rc_result result = RC_RESULT_INIT;
    const rc_status status = rc_contact_solve(made, &step, &result);
    const std::string complaint = status == RC_STOP_CANCELLED ? std::string() : complain("rc_contact_solve", status);
    canceller.join();
    return complaint;
  });
}

// All threads want the same contact: each gets an answer or must wait.
void a_contact_serves_one_thread_and_tells_the_others(void**) {
  rc_system system = support::unit_system();
  system.nx = system.ny = 12;
  rc_contact* made = nullptr;
  assert_int_equal(rc_contact_create(&system, nullptr, &made), RC_OK);
  const Contact contact(made);
  std::vector<double> gap(144);
  for (std::size_t i = 0; i < gap.size(); ++i) gap[i] = 0.01 * static_cast<double>(i);
  std::atomic<int> answers{0};
  together([&](int member) -> std::string {
    for (int round = 0; round < rounds(60); ++round) {
      rc_step step = RC_STEP_INIT;
      step.control = RC_CONTROL_APPROACH;
      step.undeformed_gap.data = gap.data();
      step.target = 0.2 + 0.1 * member;
      rc_result result = RC_RESULT_INIT;
      rc_status status = RC_OK;
      switch (round % 4) {
        case 0:
          status = rc_contact_reset(made);
          break;
        case 1:
          status = rc_contact_on_progress(made, nullptr, nullptr, 1);
          break;
        default:
          status = rc_contact_solve(made, &step, &result);
      }
      if (status != RC_OK && status != RC_ERR_BUSY) return complain("contact", status);
      if (status == RC_OK && result.points > 0) ++answers;
      if (status == RC_OK && result.points > 0 && result.approach != step.target) return "the answer is another thread's";
    }
    return {};
  });
  assert_true(answers > 0);
}

void every_thread_has_its_own_message(void**) {
  together([](int member) -> std::string {
    const std::string key = "no-such-key-" + std::to_string(member);
    for (int round = 0; round < rounds(200); ++round) {
      rc_options* options = nullptr;
      if (rc_options_create(nullptr, &options) != RC_OK || *rc_last_error() != '\0') return "a message from elsewhere";
      const rc_status status = rc_options_set_text(options, key.c_str(), "1");
      const bool own = std::strstr(rc_last_error(), key.c_str()) != nullptr;
      rc_options_destroy(options);
      if (status != RC_ERR_OPTION || !own) return complain("rc_options_set_text", status);
    }
    return {};
  });
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(one_of_eight_registrations_wins),
      cmocka_unit_test(a_fresh_context_is_first_used_by_all_threads_at_once),
      cmocka_unit_test(eight_contacts_at_once_give_the_bits_of_each_alone),
      cmocka_unit_test(contexts_come_and_go_in_every_thread),
      cmocka_unit_test(progress_runs_on_the_solving_thread),
      cmocka_unit_test(another_thread_cancels),
      cmocka_unit_test(a_contact_serves_one_thread_and_tells_the_others),
      cmocka_unit_test(every_thread_has_its_own_message),
  };
  return cmocka_run_group_tests_name("threads", tests, nullptr, nullptr);
}

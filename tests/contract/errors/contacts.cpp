#include <thread>

#include "calls.h"

namespace errors {

namespace {

// Calls made from inside a solve, by this thread or another.
struct Intruder {
  rc_contact* contact = nullptr;
  Outcome outcome = RC_OK;
  int calls = 0;
};

std::int32_t other_thread_solves(const double* x, double* y, std::int64_t n, void* user) {
  Intruder& intruder = *static_cast<Intruder*>(user);
  for (std::int64_t i = 0; i < n; ++i) y[i] = x[i];
  if (!intruder.contact || intruder.calls++ > 0) return 0;
  std::thread([&] {
    const Scene scene;
    rc_result result = RC_RESULT_INIT;
    intruder.outcome = rc_contact_solve(intruder.contact, &scene.step, &result);
  }).join();
  return 0;
}

Outcome used_by_two_threads() {
  Intruder intruder;
  const Scene scene = callback_scene(other_thread_solves, &intruder);
  const ContactHandle contact = made(scene);
  intruder.contact = contact.get();
  assert_int_equal(solve(contact.get(), scene), RC_OK);
  assert_int_equal(intruder.calls > 0, 1);
  answer().prepare();
  return intruder.outcome;
}

template <class Call> struct Reentry {
  Intruder intruder;
  Call call;

  static std::int32_t enter(const rc_progress*, void* user) {
    Reentry& self = *static_cast<Reentry*>(user);
    if (self.intruder.calls++ == 0) self.intruder.outcome = self.call(self.intruder.contact);
    return 0;
  }
};

// The progress callback uses the contact that is solving.
template <class Call> Outcome from_progress(const Call& call) {
  const Scene scene;
  const ContactHandle contact = made(scene, options_with({{"solver", "polonsky-keer"}}).get());
  Reentry<Call> reentry{{contact.get(), RC_OK, 0}, call};
  assert_int_equal(rc_contact_on_progress(contact.get(), Reentry<Call>::enter, &reentry, 1), RC_OK);
  assert_int_equal(solve(contact.get(), scene), RC_OK);
  assert_true(reentry.intruder.calls > 0);
  answer().prepare();
  return reentry.intruder.outcome;
}

Outcome stopped_by_progress() {
  const Scene scene;
  const ContactHandle contact = made(scene);
  const rc_progress_fn stop = [](const rc_progress*, void*) { return std::int32_t{1}; };
  assert_int_equal(rc_contact_on_progress(contact.get(), stop, nullptr, 1), RC_OK);
  return solve(contact.get(), scene);
}

Outcome after_reset() {
  Scene scene;
  const ContactHandle contact = made(scene);
  assert_int_equal(solve(contact.get(), scene), RC_OK);
  assert_int_equal(rc_contact_reset(contact.get()), RC_OK);
  answer().prepare();
  scene.step.undeformed_gap.data = nullptr;
  return solve(contact.get(), scene);
}

// The answer overwrites the very arrays that described the step.
Outcome result_over_its_input() {
  Scene scene;
  assert_int_equal(solve(scene), RC_OK);
  const std::vector<double> p = answer().p(), gap = answer().gap();
  std::vector<double> start(points, 0.5);
  scene.step.p0.data = start.data();
  answer().result()->p.data = start.data();
  answer().result()->gap.data = scene.gap.data();
  const Outcome outcome = solve(scene, options_with({{"tol", "1e-12"}}).get());
  for (std::size_t i = 0; i < p.size(); ++i) {
    assert_true(start[i] - p[i] < 1e-7 && p[i] - start[i] < 1e-7);
    assert_true(scene.gap[i] - gap[i] < 1e-7 && gap[i] - scene.gap[i] < 1e-7);
  }
  return outcome;
}

// Contacts and options that were made from a context outlive it.
Outcome context_destroyed_first() {
  rc_context* context = nullptr;
  assert_int_equal(rc_context_create(0, nullptr, nullptr, nullptr, &context), RC_OK);
  rc_options* made_options = nullptr;
  assert_int_equal(rc_options_create(context, &made_options), RC_OK);
  OptionsHandle options(made_options);
  rc_context_destroy(context);
  const Scene scene;
  const ContactHandle contact = made(scene, options.get());
  options.reset();
  return solve(contact.get(), scene);
}

// Runs after main and after the destructors of all objects made later; the library must still work then.
struct LastMinute {
  ~LastMinute() {
    const Scene scene;
    rc_result result = RC_RESULT_INIT;
    if (rc_solve(&scene.system, &scene.step, nullptr, &result) != RC_OK) abort();
    rc_contact_destroy(contact);
  }
  rc_contact* contact = nullptr;
} last_minute;

Outcome used_by_a_static_destructor() {
  const Scene scene;
  const Outcome outcome = rc_contact_create(&scene.system, nullptr, &last_minute.contact);
  assert_int_equal(solve(last_minute.contact, scene), RC_OK);
  return outcome;
}

// A contact that ranks share, cancelled by one of them before a step.
Outcome shared_and_cancelled() {
  const Scene scene;
  const ContactHandle contact = shared(scene);
  rc_contact_cancel(contact.get());
  const Outcome outcome = solve(contact.get(), scene);
  assert_int_equal(solve(contact.get(), scene), RC_OK);
  return outcome;
}

Outcome mask_lifted_over_nan() {
  Scene scene;
  std::vector<std::uint8_t> mask(points, 1);
  mask[2] = 0;
  scene.gap[2] = nan;
  scene.step.mask.data = mask.data();
  const ContactHandle contact = made(scene);
  assert_int_equal(solve(contact.get(), scene), RC_OK);
  answer().prepare();
  mask[2] = 1;
  scene.step.undeformed_gap.data = nullptr;
  return solve(contact.get(), scene);
}

// A number without a fraction is an integer, whatever function sets it.
Outcome whole_number_set() {
  const OptionsHandle options = options_with({});
  const Outcome outcome = rc_options_set_number(options.get(), "max_iter", 7);
  double most = 0;
  assert_int_equal(rc_options_get_number(options.get(), "max_iter", &most), RC_OK);
  assert_true(most == 7);
  return outcome;
}

// Options that cannot be used leave those in force as they were.
Outcome solves_after_refused_options() {
  const Scene scene;
  const ContactHandle contact = made(scene, options_with({{"solver", "nnls"}}).get());
  assert_int_equal(rc_contact_set_options(contact.get(), options_with({{"solver", "no-such"}}).get()), RC_ERR_NO_SOLVER);
  const Outcome outcome = solve(contact.get(), scene);
  assert_string_equal(answer().result()->solver, "nnls");
  return outcome;
}

// The copy is as the options were, and neither changes with the other.
Outcome copied() {
  const OptionsHandle options = options_with({{"tol", "1e-7"}, {"solver", "nnls"}, {"threads", "3"}});
  rc_options* copy = nullptr;
  const Outcome outcome = rc_options_copy(options.get(), &copy);
  const OptionsHandle keep(copy);
  assert_int_equal(rc_options_set_number(options.get(), "tol", 1e-5), RC_OK);
  assert_int_equal(rc_options_set_number(copy, "threads", 2), RC_OK);
  double tol = 0;
  double threads = 0;
  const char* solver = nullptr;
  assert_int_equal(rc_options_get_number(copy, "tol", &tol), RC_OK);
  assert_int_equal(rc_options_get_text(copy, "solver", &solver), RC_OK);
  assert_int_equal(rc_options_get_number(options.get(), "threads", &threads), RC_OK);
  assert_true(tol == 1e-7 && threads == 3);
  assert_string_equal(solver, "nnls");
  return outcome;
}

Outcome options_of_another_context() {
  const Scene scene;
  const ContactHandle contact = made(scene);
  rc_context* context = nullptr;
  assert_int_equal(rc_context_create(0, nullptr, nullptr, nullptr, &context), RC_OK);
  const ContextHandle keep(context);
  rc_options* options = nullptr;
  assert_int_equal(rc_options_create(context, &options), RC_OK);
  const OptionsHandle keep_options(options);
  return rc_contact_set_options(contact.get(), options);
}

// The operator is there already, and bound to the same points.
Outcome tightened_later() {
  const Scene scene;
  const auto with = [](const char* tol) { return options_with({{"backend", "fft"}, {"fft.precision", "single"}, {"tol", tol}}); };
  const ContactHandle contact = made(scene, with("1e-4").get());
  assert_int_equal(solve(contact.get(), scene), RC_OK);
  assert_int_equal(rc_contact_set_options(contact.get(), with("5e-6").get()), RC_OK);
  answer().prepare();
  return solve(contact.get(), scene);
}

// After a failed product the same contact solves as if nothing had happened.
Outcome recovers_after_failure() {
  World world;
  world.set("callback=diagonal");
  world.memory.fails_at = 3;
  const ContactHandle contact = made(world.scene);
  assert_int_equal(solve(contact.get(), world.scene), RC_ERR_EXTERNAL);
  assert_true(answer().untouched());
  world.memory.fails_at = 0;
  return solve(contact.get(), world.scene);
}

}  // namespace

Calls contact_calls() {
  Calls all = {
      {"progress_solves", [](World&) { return from_progress([](rc_contact* c) { return solve(c, Scene()); }); }},
      {"progress_sets_options",
       [](World&) { return from_progress([](rc_contact* c) { return rc_contact_set_options(c, options_with({}).get()); }); }},
      {"progress_resets", [](World&) { return from_progress([](rc_contact* c) { return rc_contact_reset(c); }); }},
      {"progress_replaces_itself",
       [](World&) { return from_progress([](rc_contact* c) { return rc_contact_on_progress(c, nullptr, nullptr, 1); }); }},
      {"progress_every_0", [](World& w) { return rc_contact_on_progress(made(w.scene).get(), nullptr, nullptr, 0); }},
      {"reset_shared", [](World& w) { return rc_contact_reset(shared(w.scene).get()); }},
      {"ranks_counts",
       [](World& w) {
         rc_ranks_counts counts = RC_RANKS_COUNTS_INIT;
         return rc_ranks_contact_counts(made(w.scene).get(), &counts);
       }},
      {"ranks_rows",
       [](World& w) {
         rc_exchange exchange = RC_EXCHANGE_INIT;
         exchange.refused = "no network";
         std::int64_t first = 0, count = 0;
         return rc_ranks_rows(&exchange, &w.scene.system, &first, &count);
       }},
  };
#define CALL(name) all[#name] = [](World&) { return name(); }
  CALL(used_by_two_threads), CALL(stopped_by_progress), CALL(shared_and_cancelled), CALL(after_reset),
      CALL(result_over_its_input);
  CALL(context_destroyed_first), CALL(used_by_a_static_destructor), CALL(mask_lifted_over_nan);
  CALL(whole_number_set), CALL(solves_after_refused_options), CALL(copied), CALL(options_of_another_context);
  CALL(tightened_later), CALL(recovers_after_failure);
#undef CALL
  return all;
}

}  // namespace errors

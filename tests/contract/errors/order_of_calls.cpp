#include <thread>

#include "case.h"
#include "scene.h"

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

Outcome cancelled_before() {
  const Scene scene;
  const ContactHandle contact = made(scene);
  rc_contact_cancel(contact.get());
  return solve(contact.get(), scene);
}

Outcome cancelled_once() {
  const Scene scene;
  const ContactHandle contact = made(scene);
  rc_contact_cancel(contact.get());
  assert_int_equal(solve(contact.get(), scene), RC_STOP_CANCELLED);
  return solve(contact.get(), scene);
}

Outcome too_few_iterations() {
  const Scene scene;
  return solve(scene, options_with({{"solver", "polonsky-keer"}, {"max_iter", "1"}}).get());
}

Outcome too_little_time() {
  const Scene scene;
  return solve(scene, options_with({{"solver", "polonsky-keer"}, {"time_limit", "1e-300"}}).get());
}

// The gap of a step that was refused is not remembered.
Outcome refused_step_forgotten() {
  Scene scene;
  const ContactHandle contact = made(scene);
  assert_int_equal(solve(contact.get(), scene), RC_OK);
  const double load = answer().result()->load;
  const std::vector<double> other(points, 0.0);
  rc_step bad = scene.step;
  bad.undeformed_gap.data = other.data();
  bad.target = nan;
  answer().prepare();
  assert_int_equal(rc_contact_solve(contact.get(), &bad, answer().result()), RC_ERR_ARGUMENT);
  assert_true(answer().untouched());
  scene.step.undeformed_gap.data = nullptr;
  const Outcome outcome = solve(contact.get(), scene);
  assert_true(answer().result()->load == load);
  return outcome;
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

// The answer says which grid it is of.
Outcome grid_of_an_answer() {
  const Scene scene;
  const Outcome outcome = solve(made(scene).get(), scene);
  const rc_result& found = *answer().result();
  assert_true(found.model_nx == scene.system.nx && found.model_ny == scene.system.ny && found.left_out == 0);
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

template <class Call> auto on_shared(const Call& call) {
  return [call] {
    const Scene scene;
    const ContactHandle contact = shared(scene);
    return Outcome(call(contact.get()));
  };
}

}  // namespace

Section order_of_calls() {
  const char* const busy = "the contact is in use by another thread; make one contact per thread";
  return {"Order of calls",
          {
              {"contact used by a second thread", RC_ERR_BUSY, {"rc_contact_solve: ", busy}, used_by_two_threads},
              {"progress callback solves on the same contact",
               RC_ERR_BUSY,
               {"rc_contact_solve: ", busy},
               [] { return from_progress([](rc_contact* c) { return solve(c, Scene()); }); }},
              {"progress callback changes the options",
               RC_ERR_BUSY,
               {"rc_contact_set_options: ", busy},
               [] { return from_progress([](rc_contact* c) { return rc_contact_set_options(c, options_with({}).get()); }); }},
              {"progress callback resets the contact",
               RC_ERR_BUSY,
               {"rc_contact_reset: ", busy},
               [] { return from_progress([](rc_contact* c) { return rc_contact_reset(c); }); }},
              {"progress callback replaces itself",
               RC_ERR_BUSY,
               {"rc_contact_on_progress: ", busy},
               [] { return from_progress([](rc_contact* c) { return rc_contact_on_progress(c, nullptr, nullptr, 1); }); }},
              {"progress every 0 iterations",
               RC_ERR_ARGUMENT,
               {"rc_contact_on_progress: every = 0 must be >= 1"},
               [] { return rc_contact_on_progress(made(Scene()).get(), nullptr, nullptr, 0); }},
              {"progress callback asks to stop",
               RC_STOP_CANCELLED,
               {"rc_contact_solve: stopped by the progress callback, rc_contact_cancel or rc_stop_when"},
               stopped_by_progress},
              {"cancelled before the solve",
               RC_STOP_CANCELLED,
               {"rc_contact_solve: stopped by the progress callback, rc_contact_cancel or rc_stop_when"},
               cancelled_before},
              {"the solve after a cancelled one", RC_OK, {}, cancelled_once},
              {"max_iter = 1",
               RC_STOP_MAX_ITER,
               {"rc_solve: stopped at max_iter before the tolerance was reached: ", "after 1 iterations"},
               too_few_iterations},
              {"time_limit = 1e-300",
               RC_STOP_TIME,
               {"rc_solve: stopped at time_limit before the tolerance was reached"},
               too_little_time},
              {"grid of an answer", RC_OK, {}, grid_of_an_answer},
              {"cancelled contact that ranks share", RC_STOP_CANCELLED, {"rc_contact_solve: "}, shared_and_cancelled},
              {"reset of a contact that ranks share",
               RC_ERR_INCOMPATIBLE,
               {"rc_contact_reset: ranks share the contact: it has rc_contact_solve, rc_contact_solve_history and "
                "rc_contact_certify"},
               on_shared([](rc_contact* contact) { return rc_contact_reset(contact); })},
              {"counts of a contact that no ranks share",
               RC_ERR_INCOMPATIBLE,
               {"rc_ranks_contact_counts: no ranks share the contact: rc_contact_create has made it"},
               [] {
                 rc_ranks_counts counts = RC_RANKS_COUNTS_INIT;
                 return rc_ranks_contact_counts(made(Scene()).get(), &counts);
               }},
              {"rows between ranks whose exchange is refused",
               RC_ERR_ARGUMENT,
               {"rc_ranks_rows: no network"},
               [] {
                 const Scene scene;
                 rc_exchange exchange = RC_EXCHANGE_INIT;
                 exchange.refused = "no network";
                 std::int64_t first = 0, count = 0;
                 return rc_ranks_rows(&exchange, &scene.system, &first, &count);
               }},
              {"step without a gap after a refused step", RC_OK, {}, refused_step_forgotten},
              {"step without a gap after a reset",
               RC_ERR_ARGUMENT,
               {"rc_step.undeformed_gap.data is null and no earlier step gave one"},
               after_reset},
              {"result.p over step.p0, result.gap over step.undeformed_gap", RC_OK, {}, result_over_its_input},
              {"context destroyed before its options and contacts", RC_OK, {}, context_destroyed_first},
              {"contact that a static destructor uses", RC_OK, {}, used_by_a_static_destructor},
          }};
}

}  // namespace errors

#include <optional>

#include "calls.h"

namespace errors {

namespace {

struct Inside {
  rc_contact* contact;
  std::function<rc_status(rc_contact*)> call;
  std::optional<Outcome> outcome;
};

// The history's `fn` makes a call with the contact that is solving.
auto from_history(const std::function<rc_status(rc_contact*)>& call) {
  return [call](World& w) {
    const ContactHandle contact = made(w.scene);
    Inside inside{contact.get(), call, {}};
    w.memory.history.user = &inside;
    w.memory.history.fn = [](std::int64_t, const rc_result*, void* user) -> std::int32_t {
      auto& here = *static_cast<Inside*>(user);
      here.outcome = here.call(here.contact);
      return 0;
    };
    w.memory.written = 3;
    w.begin_call();
    assert_int_equal(run_history(contact.get(), w).status, RC_OK);
    return *inside.outcome;
  };
}

Outcome history_cancelled_by_fn(World& w) {
  const ContactHandle contact = made(w.scene);
  w.memory.history.user = contact.get();
  w.memory.history.fn = [](std::int64_t step, const rc_result*, void* user) -> std::int32_t {
    if (step == 1) rc_contact_cancel(static_cast<rc_contact*>(user));
    return 0;
  };
  return run_history(contact.get(), w);
}

Outcome history_ended_by_fn(World& w) {
  w.memory.history.fn = [](std::int64_t step, const rc_result*, void*) -> std::int32_t { return step == 1; };
  return run_history(made(w.scene).get(), w);
}

Outcome batch_ended_by_fn(World& w) {
  w.memory.batch.fn = [](std::int64_t, std::int64_t step, const rc_result*, void*) -> std::int32_t { return step == 1; };
  return run_batch(w);
}

Outcome batch_ended_by_progress(World& w) {
  w.memory.batch.progress = [](std::int64_t ended, void*) -> std::int32_t { return ended == 3; };
  return run_batch(w);
}

}  // namespace

Calls history_calls() {
  return {
      {"history_fn_solves", from_history([](rc_contact* c) { return solve(c, Scene()); })},
      {"history_fn_starts_another", from_history([](rc_contact* c) {
         rc_history history = RC_HISTORY_INIT;
         return rc_contact_solve_history(c, &history);
       })},
      {"history_fn_asks_for_points", from_history([](rc_contact* c) { return rc_contact_points(c, 0, {}, {}, nullptr); })},
      {"history_cancelled_by_fn", history_cancelled_by_fn},
      {"history_ended_by_fn", history_ended_by_fn},
      {"batch_ended_by_fn", batch_ended_by_fn},
      {"batch_ended_by_progress", batch_ended_by_progress},
  };
}

}  // namespace errors

#include "calls.h"

namespace errors {

namespace {

// before(contact, scene): what came before the call, instead of a step.
template <class Before> auto gradient_after(const Before& before) {
  return [=](World& w) {
    const ContactHandle contact = made(w.scene);
    before(contact.get(), w.scene);
    answer().prepare();
    return Outcome(rc_contact_gradient(contact.get(), &w.memory.gradient));
  };
}

void solved(rc_contact* contact, const Scene& scene) { assert_int_equal(solve(contact, scene), RC_OK); }

// The progress callback asks the contact that is solving.
struct Asking {
  rc_contact* contact;
  World& world;
  Outcome outcome = RC_OK;
  static std::int32_t ask(const rc_progress*, void* user) {
    Asking& self = *static_cast<Asking*>(user);
    if (self.outcome.status == RC_OK) self.outcome = rc_contact_gradient(self.contact, &self.world.memory.gradient);
    return 0;
  }
};
Outcome gradient_within_a_solve(World& w) {
  const ContactHandle contact = made(w.scene, options_with({{"solver", "polonsky-keer"}}).get());
  Asking asking{contact.get(), w};
  assert_int_equal(rc_contact_on_progress(contact.get(), Asking::ask, &asking, 1), RC_OK);
  solved(contact.get(), w.scene);
  answer().prepare();
  return asking.outcome;
}

}  // namespace

Calls derivative_calls() {
  return {
      {"gradient_before_a_step", gradient_after([](rc_contact*, const Scene&) {})},
      {"gradient_after_a_failed_step", gradient_after([](rc_contact* contact, Scene& scene) {
         solved(contact, scene);
         const OptionsHandle options = options_with({{"max_iter", "1"}, {"solver", "polonsky-keer"}});
         assert_int_equal(rc_contact_set_options(contact, options.get()), RC_OK);
         scene.step.target *= 2;
         scene.step.warm_start = 0;
         assert_true(solve(contact, scene) != RC_OK);
       })},
      {"gradient_after_certify", gradient_after([](rc_contact* contact, const Scene& scene) {
         solved(contact, scene);
         assert_int_equal(rc_contact_certify(contact, &scene.step, answer().result()), RC_OK);
       })},
      {"gradient_after_reset", gradient_after([](rc_contact* contact, const Scene& scene) {
         solved(contact, scene);
         assert_int_equal(rc_contact_reset(contact), RC_OK);
       })},
      {"gradient_after_restore", gradient_after([](rc_contact* contact, const Scene& scene) {
         solved(contact, scene);
         rc_state state = RC_STATE_INIT;
         state.undeformed_gap = RC_IN(scene.gap.data());
         state.p = RC_IN(answer().p().data());
         assert_int_equal(rc_contact_restore(contact, &state), RC_OK);
       })},
      {"gradient_within_a_solve", gradient_within_a_solve},
  };
}

}  // namespace errors

#include <roughcontact/history.h>

#include <cmath>

#include "case.h"
#include "scene.h"

namespace errors {

namespace {

// The state that a step without contact leaves.
struct Stand {
  Scene scene;
  std::vector<double> p = std::vector<double>(scene.gap.size(), 0.0);
  std::vector<std::uint8_t> mask = std::vector<std::uint8_t>(scene.gap.size(), 1);
  rc_state state = RC_STATE_INIT;

  Stand() {
    state.undeformed_gap = RC_IN(scene.gap.data());
    state.mask = RC_IN(mask.data());
    state.p = RC_IN(p.data());
  }
};

// A call that is refused changes nothing: the contact still has no surface.
template <class Spoil> auto restored(const Spoil& spoil) {
  return [=] {
    Stand stand;
    spoil(stand);
    const ContactHandle contact = made(stand.scene);
    const Outcome outcome = rc_contact_restore(contact.get(), &stand.state);
    stand.scene.step.undeformed_gap.data = nullptr;
    assert_int_equal(solve(contact.get(), stand.scene), RC_ERR_ARGUMENT);
    return outcome;
  };
}

}  // namespace

Section restores() {
  const rc_status refused = RC_ERR_ARGUMENT;
  return {
      "Restored contacts",
      {
          {"`rc_contact_restore`: contact is null",
           refused,
           {"rc_contact_restore: contact is null"},
           [] {
             const rc_state state = RC_STATE_INIT;
             return rc_contact_restore(nullptr, &state);
           }},
          {"`rc_contact_restore`: state is null",
           refused,
           {"rc_contact_restore: rc_state is null"},
           [] { return rc_contact_restore(made(Scene()).get(), nullptr); }},
          {"rc_state.struct_size = 0",
           refused,
           {"rc_contact_restore: rc_state.struct_size = " + too_small<rc_state>(0) + "; set it to sizeof(rc_state)"},
           restored([](Stand& stand) { stand.state.struct_size = 0; })},
          {"state without a gap", refused, {"rc_contact_restore: rc_state.undeformed_gap is null"}, restored([](Stand& stand) {
             stand.state.undeformed_gap = {};
           })},
          {"state with a gap that is NaN",
           refused,
           {"rc_contact_restore: gap has 1 value(s) that are not finite, first at ix=2, iy=0"},
           restored([](Stand& stand) { stand.scene.gap[2] = NAN; })},
          {"state with a step before but no last one",
           refused,
           {"rc_contact_restore: rc_state.p is null but rc_state.p_before is not"},
           restored([](Stand& stand) { std::swap(stand.state.p, stand.state.p_before); })},
          {"state with an infinite pressure",
           refused,
           {"rc_contact_restore: rc_state.p[1] = inf is not finite (ix=1, iy=0)"},
           restored([](Stand& stand) { stand.p[1] = INFINITY; })},
          {"state with a pressure under the mask",
           refused,
           {"rc_contact_restore: rc_state.p[0] = 1 but this point is excluded by the mask"},
           restored([](Stand& stand) {
             stand.p[0] = 1;
             stand.mask[0] = 0;
           })},
          {"state with an approach that is NaN",
           refused,
           {"rc_contact_restore: rc_state.approach = nan is not finite"},
           restored([](Stand& stand) { stand.state.approach = NAN; })},
          {"state with an infinite load of the step before",
           refused,
           {"rc_contact_restore: rc_state.load_before = inf is not finite"},
           restored([](Stand& stand) {
             stand.state.p_before = stand.state.p;
             stand.state.load_before = INFINITY;
           })},
          {"state with an indentation that is negative",
           refused,
           {"rc_contact_restore: rc_state.indentation[1] = -1 must be finite and >= 0"},
           restored([](Stand& stand) {
             stand.scene.system.hardness = 1;
             stand.p[1] = -1;
             stand.state.indentation = std::exchange(stand.state.p, rc_const_array{});
           })},
          {"state with an indentation without a hardness",
           refused,
           {"rc_contact_restore: rc_state.indentation[1] = 1 but the system has no hardness"},
           restored([](Stand& stand) {
             stand.p[1] = 1;
             stand.state.indentation = std::exchange(stand.state.p, rc_const_array{});
           })},
          {"`rc_contact_indentation`: contact is null",
           refused,
           {"rc_contact_indentation: contact is null"},
           [] {
             double one = 0;
             return rc_contact_indentation(nullptr, RC_OUT(&one));
           }},
          {"`rc_contact_indentation`: indentation is null",
           refused,
           {"rc_contact_indentation: indentation is null"},
           [] { return rc_contact_indentation(made(Scene()).get(), {}); }},
      }};
}

}  // namespace errors

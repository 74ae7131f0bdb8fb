#include <roughcontact/analysis.h>
#include <roughcontact/derivatives.h>
#include <roughcontact/history.h>

#include <cmath>

#include "case.h"
#include "scene.h"

namespace errors {

namespace {

// Valid requests of a contact that has solved a step, to be spoiled in one place.
struct Request {
  Scene scene;
  OptionsHandle options = options_with({});
  std::vector<double> by_p = std::vector<double>(points, 1.0), by_gap = by_p, change = by_p;
  std::vector<double> out = std::vector<double>(points, untouched), dp = out, dgap = out;
  rc_gradient gradient = RC_GRADIENT_INIT;
  rc_tangent tangent = RC_TANGENT_INIT;

  Request() {
    gradient.dJ_dp = RC_IN(by_p.data());
    gradient.dJ_dgap = RC_IN(by_gap.data());
    gradient.dJ_dundeformed_gap = RC_OUT(out.data());
    gradient.dJ_dtarget = tangent.dload = untouched;
    tangent.dundeformed_gap = RC_IN(change.data());
    tangent.dp = RC_OUT(dp.data());
    tangent.dgap = RC_OUT(dgap.data());
  }
  Request(const Request&) = delete;
  Request& operator=(const Request&) = delete;

  void check_untouched() const {
    for (const auto* values : {&out, &dp, &dgap})
      for (const double value : *values) assert_true(value == untouched);
    assert_true(gradient.dJ_dtarget == untouched && tangent.dload == untouched);
  }
};

Outcome differentiate(rc_contact* contact, Request& request, bool forward) {
  const Outcome outcome =
      forward ? rc_contact_tangent(contact, &request.tangent) : rc_contact_gradient(contact, &request.gradient);
  if (outcome.status != RC_OK) request.check_untouched();
  return outcome;
}

template <class Spoil> auto reverse_mode(const Spoil& spoil, bool forward = false) {
  return [=] {
    Request request;
    spoil(request);
    const ContactHandle contact = made(request.scene, request.options.get());
    assert_true(solve(contact.get(), request.scene) >= 0);
    answer().prepare();
    return differentiate(contact.get(), request, forward);
  };
}
template <class Spoil> auto forward_mode(const Spoil& spoil) { return reverse_mode(spoil, true); }

// after(contact, scene): what came before the call, instead of a step.
template <class Before> auto after(const Before& before) {
  return [=] {
    Request request;
    const ContactHandle contact = made(request.scene);
    before(contact.get(), request.scene);
    answer().prepare();
    return differentiate(contact.get(), request, false);
  };
}

// The progress callback asks the contact that is solving.
struct Asking {
  rc_contact* contact;
  Outcome outcome = RC_OK;
  static std::int32_t ask(const rc_progress*, void* user) {
    Asking& self = *static_cast<Asking*>(user);
    Request request;
    if (self.outcome.status == RC_OK) self.outcome = differentiate(self.contact, request, false);
    return 0;
  }
};
Outcome within_a_solve() {
  const Scene scene;
  const ContactHandle contact = made(scene, options_with({{"solver", "polonsky-keer"}}).get());
  Asking asking{contact.get()};
  assert_int_equal(rc_contact_on_progress(contact.get(), Asking::ask, &asking, 1), RC_OK);
  assert_int_equal(solve(contact.get(), scene), RC_OK);
  answer().prepare();
  return asking.outcome;
}

void dense(Request& request) {
  request.scene = dense_scene();
  request.scene.system.dense = request.scene.dense.data();
  request.scene.step.undeformed_gap.data = request.scene.gap.data();
}

struct Conduct {
  rc_system system = Scene().system;
  rc_result result = RC_RESULT_INIT;
  double rho1 = 1, rho2 = 2, out[3] = {untouched, untouched, untouched};
  double* conductance = out;
  Conduct() {
    result.stiffness = 3;
    result.homogeneous = 1;
  }
};
template <class Spoil> auto conductance(const Spoil& spoil) {
  return [=] {
    Conduct c;
    spoil(c);
    const Outcome outcome = rc_conductance(&c.system, &c.result, c.rho1, c.rho2, c.conductance, c.out + 1, c.out + 2);
    if (outcome.status != RC_OK) assert_true(c.out[0] == untouched && c.out[1] == untouched && c.out[2] == untouched);
    return outcome;
  };
}

}  // namespace

Section derivatives() {
  const rc_status refused = RC_ERR_ARGUMENT;
  const char* const not_certified =
      "rc_contact_gradient: only a certified step has derivatives: solve one first that returns RC_OK on the given grid";
  return {
      "Derivatives and conductance",
      {
          {"`rc_contact_gradient`: contact is null",
           refused,
           {"rc_contact_gradient: contact is null"},
           [] {
             Request request;
             return differentiate(nullptr, request, false);
           }},
          {"`rc_contact_gradient`: gradient is null",
           refused,
           {"rc_contact_gradient: rc_gradient is null"},
           [] { return rc_contact_gradient(made(Scene()).get(), nullptr); }},
          {"`rc_contact_tangent`: tangent is null",
           refused,
           {"rc_contact_tangent: rc_tangent is null"},
           [] { return rc_contact_tangent(made(Scene()).get(), nullptr); }},
          {"rc_gradient.struct_size = 0",
           refused,
           {"rc_contact_gradient: rc_gradient.struct_size = " + too_small<rc_gradient>(0) + "; set it to sizeof(rc_gradient)"},
           reverse_mode([](Request& r) { r.gradient.struct_size = 0; })},
          {"rc_tangent.struct_size = 0",
           refused,
           {"rc_contact_tangent: rc_tangent.struct_size = " + too_small<rc_tangent>(0) + "; set it to sizeof(rc_tangent)"},
           forward_mode([](Request& r) { r.tangent.struct_size = 0; })},
          {"derivatives before a step", refused, {not_certified}, after([](rc_contact*, const Scene&) {})},
          {"derivatives after a step that failed", refused, {not_certified}, after([](rc_contact* contact, Scene scene) {
             assert_int_equal(solve(contact, scene), RC_OK);
             const OptionsHandle options = options_with({{"max_iter", "1"}, {"solver", "polonsky-keer"}});
             assert_int_equal(rc_contact_set_options(contact, options.get()), RC_OK);
             scene.step.target *= 2;
             scene.step.warm_start = 0;
             assert_true(solve(contact, scene) != RC_OK);
           })},
          {"derivatives after `rc_contact_certify`", refused, {not_certified}, after([](rc_contact* contact, const Scene& scene) {
             assert_int_equal(solve(contact, scene), RC_OK);
             rc_result* const result = answer().result();
             assert_int_equal(rc_contact_certify(contact, &scene.step, result), RC_OK);
           })},
          {"derivatives after `rc_contact_reset`", refused, {not_certified}, after([](rc_contact* contact, const Scene& scene) {
             assert_int_equal(solve(contact, scene), RC_OK);
             assert_int_equal(rc_contact_reset(contact), RC_OK);
           })},
          {"derivatives after `rc_contact_restore`", refused, {not_certified}, after([](rc_contact* contact, const Scene& scene) {
             assert_int_equal(solve(contact, scene), RC_OK);
             rc_state state = RC_STATE_INIT;
             state.undeformed_gap = RC_IN(scene.gap.data());
             state.p = RC_IN(answer().p().data());
             assert_int_equal(rc_contact_restore(contact, &state), RC_OK);
           })},
          {"derivatives from within the solve",
           RC_ERR_BUSY,
           {"rc_contact_gradient: the contact is in use by another thread"},
           within_a_solve},
          {"derivatives at load 0",
           refused,
           {"rc_contact_gradient: the load is 0: no point carries pressure"},
           reverse_mode([](Request& r) {
             r.scene.step.control = RC_CONTROL_LOAD;
             r.scene.step.target = 0;
           })},
          {"cotangent of the pressures NaN",
           refused,
           {"rc_contact_gradient: rc_gradient.dJ_dp[3] = nan is not finite (ix=3, iy=0)"},
           reverse_mode([](Request& r) { r.by_p[3] = NAN; })},
          {"cotangent of the gap infinite",
           refused,
           {"rc_contact_gradient: rc_gradient.dJ_dgap[15] = inf is not finite"},
           reverse_mode([](Request& r) { r.by_gap[15] = INFINITY; })},
          {"cotangent of the load NaN",
           refused,
           {"rc_contact_gradient: rc_gradient.dJ_dload = nan is not finite"},
           reverse_mode([](Request& r) { r.gradient.dJ_dload = NAN; })},
          {"cotangent of the approach NaN",
           refused,
           {"rc_contact_gradient: rc_gradient.dJ_dapproach = nan is not finite"},
           reverse_mode([](Request& r) { r.gradient.dJ_dapproach = NAN; })},
          {"change of the undeformed gap NaN",
           refused,
           {"rc_contact_tangent: rc_tangent.dundeformed_gap[0] = nan is not finite"},
           forward_mode([](Request& r) { r.change[0] = NAN; })},
          {"change of the target infinite",
           refused,
           {"rc_contact_tangent: rc_tangent.dtarget = inf is not finite"},
           forward_mode([](Request& r) { r.tangent.dtarget = INFINITY; })},
          {"change of the modulus NaN",
           refused,
           {"rc_contact_tangent: rc_tangent.dmodulus = nan is not finite"},
           forward_mode([](Request& r) { r.tangent.dmodulus = NAN; })},
          {"change of the modulus of a matrix",
           refused,
           {"rc_contact_tangent: rc_tangent.dmodulus = 1 but the system is no half-space: it has no modulus"},
           forward_mode([](Request& r) {
             dense(r);
             r.tangent.dmodulus = 1;
           })},
          {"conductance: NULL to write to", refused, {"rc_conductance: conductance is null"}, conductance([](Conduct& c) {
             c.conductance = nullptr;
           })},
          {"conductance: result of an unknown size",
           refused,
           {"rc_conductance: rc_result.struct_size = " + too_small<rc_result>(0)},
           conductance([](Conduct& c) { c.result.struct_size = 0; })},
          {"conductance: a matrix",
           refused,
           {"rc_conductance: rc_system.op = 2: only half-spaces have the contact modulus"},
           conductance([](Conduct& c) { c.system.op = RC_OPERATOR_DENSE; })},
          {"conductance: modulus 0",
           refused,
           {"rc_conductance: rc_system.modulus = 0 must be positive and finite"},
           conductance([](Conduct& c) { c.system.modulus = 0; })},
          {"conductance: a layer",
           refused,
           {"rc_conductance: rc_result.homogeneous = 0: kernel \"layer\" is not that of a homogeneous half-space"},
           conductance([](Conduct& c) {
             c.result.homogeneous = 0;
             std::snprintf(c.result.kernel, sizeof c.result.kernel, "layer");
           })},
          {"conductance: negative resistivity",
           refused,
           {"rc_conductance: rho1 = -1 and rho2 = 2 must be finite, >= 0 and not both 0"},
           conductance([](Conduct& c) { c.rho1 = -1; })},
          {"conductance: both resistivities 0",
           refused,
           {"rc_conductance: rho1 = 0 and rho2 = 0 must be finite"},
           conductance([](Conduct& c) { c.rho1 = c.rho2 = 0; })},
          {"conductance: resistivities with a sum beyond double precision",
           RC_OK,
           {},
           [] {
             Conduct c;
             c.result.stiffness = 3e8;
             double by_half = 0;
             assert_int_equal(rc_conductance(&c.system, &c.result, 4e307, 5e307, &by_half, nullptr, nullptr), RC_OK);
             const rc_status status = rc_conductance(&c.system, &c.result, 8e307, 1e308, c.out, c.out + 1, c.out + 2);
             assert_true(std::abs(c.out[0] / by_half - 0.5) < 1e-12);
             return status;
           }},
          {"conductance: a result without stiffness",
           refused,
           {"rc_conductance: rc_result.stiffness is NaN; solve with option stiffness = 1 or 2"},
           conductance([](Conduct& c) { c.result.stiffness = NAN; })},
      }};
}

}  // namespace errors

// Values and promises of kernels that cannot be true: what is refused, and that nothing is written then.
#include <random>

#include "kernel_scene.h"

namespace plugins {

namespace {

struct Wrong {
  const char* message;
  Spoilt spoilt;
  std::int32_t boundary = RC_BOUNDARY_FREE;
};

const Wrong wrong[] = {
    {"kernel \"decay\": the coefficient at offset (0, 0) is -1, must be positive", {0, 0, -1}},
    {"kernel \"decay\": the coefficient at offset (0, 0) is 0, must be positive", {0, 0, 0}},
    {"kernel \"decay\": the coefficient at offset (0, 0) is nan, must be finite", {0, 0, nan}},
    {"kernel \"decay\": the coefficient at offset (2, 1) is inf, must be finite", {2, 1, infinity}},
    {"kernel \"decay\": the coefficient at offset (3, 0) is 1.5, beyond that at (0, 0), 1: H is not positive definite",
     {3, 0, 1.5}},
    {"kernel \"decay\": the coefficient at offset (0, 3) is -0.1, although none is promised to be negative", {0, 3, -0.1}},
    {"kernel \"decay\": the coefficient at offset (5, 8) is nan, must be finite", {5, 8, nan}},
    {"kernel \"decay\": H is not positive definite: x'Hx / x'x is -", {1, 0, 0.999}},
    {"kernel \"decay\": an eigenvalue is at most ", {-1, -1, 0, 1, 0.6}},
    {", although none is promised to be below 0.6", {-1, -1, 0, 1, 0.6}},
    {"times that of galerkin, although at least 3 is promised", {-1, -1, 0, 1, 0, 3}},
    {"kernel \"decay\": a promised bound is nan, must be finite and >= 0", {-1, -1, 0, 1, nan}},
    {"kernel \"decay\": a promised bound is -1, must be finite and >= 0", {-1, -1, 0, 1, 0, -1}},
    {"kernel \"decay\": the symbol at wave numbers (3, 2) is -0.1, must be >= 0 and finite", {3, 2, -0.1}, RC_BOUNDARY_PERIODIC},
    {"kernel \"decay\": the symbol at wave numbers (6, 6) is nan, must be >= 0 and finite", {6, 6, nan}, RC_BOUNDARY_PERIODIC},
    {"0.013698630137, although none is promised to be below 0.1", {-1, -1, 0, 1, 0.1}, RC_BOUNDARY_PERIODIC},
};

void what_cannot_be_true_is_refused(void**) {
  for (const char* backend : {"auto", "dense", "fft"})
    for (const Wrong& each : wrong) {
      const Registry registry("");
      Spoilt spoilt = each.spoilt;
      const rc_kernel kernel = decay(spoilt);
      assert_int_equal(add(registry, kernel), RC_OK);
      Pressed pressed(registry, {{RC_OPT_KERNEL, "decay"}, {RC_OPT_BACKEND, backend}}, each.boundary);
      if (pressed.status == RC_ERR_NO_BACKEND) continue;  // not built
      if (pressed.status != RC_ERR_NUMERIC) fail_msg("%s on %s: %d %s", each.message, backend, pressed.status, rc_last_error());
      assert_message_has(each.message);
      assert_true(pressed.untouched());
    }
}

rc_status unwilling(const rc_host* host, const rc_kernel_spec*, double*) {
  return host->fail(host, RC_ERR_EXTERNAL, "decay: no wave here");
}

void failures_are_passed_on(void**) {
  const Registry registry("", RC_CONTEXT_NO_PLUGINS);
  Spoilt sound;
  rc_kernel kernel = decay(sound);
  kernel.symbol = unwilling;
  assert_int_equal(add(registry, kernel), RC_OK);
  const Pressed pressed(registry, {{RC_OPT_KERNEL, "decay"}}, RC_BOUNDARY_PERIODIC);
  assert_int_equal(pressed.status, RC_ERR_EXTERNAL);
  assert_message_has("rc_contact_create: decay: no wave here");
}

rc_status idle(const rc_host*, const rc_kernel_spec*, double*) { return RC_OK; }
rc_status half_done(const rc_host*, const rc_kernel_spec*, double*) { return RC_STOP_TIME; }

void what_is_left_out_is_seen(void**) {
  using Symbol = decltype(rc_kernel::symbol);
  const std::pair<Symbol, const char*> each[] = {{idle, "the symbol at wave numbers (1, 0) is nan"},
                                                 {half_done, "the kernel's symbol returned 102, must be RC_OK or an error"}};
  for (const auto& [symbol, message] : each) {
    const Registry registry("", RC_CONTEXT_NO_PLUGINS);
    Spoilt sound;
    rc_kernel kernel = decay(sound);
    kernel.symbol = symbol;
    assert_int_equal(add(registry, kernel), RC_OK);
    assert_int_equal(Pressed(registry, {{RC_OPT_KERNEL, "decay"}}, RC_BOUNDARY_PERIODIC).status, RC_ERR_NUMERIC);
    assert_message_has(message);
  }
}

// H less 0.2 times the identity is positive definite as well: each diagonal entry grows by what the kernel adds there.
void intervals_rest_on_what_is_promised(void**) {
  Spoilt sound;
  sound.x = sound.y = 0;
  sound.value = 1.2;
  const rc_kernel kernel = decay(sound);
  const Registry registry("", RC_CONTEXT_NO_PLUGINS);
  assert_int_equal(add(registry, kernel), RC_OK);
  const Pressed silent(registry, {{RC_OPT_KERNEL, "decay"}});
  assert_int_equal(silent.status, RC_OK);
  assert_true(std::isnan(silent.result.load_upper));
  assert_has(silent.result.note, "bounds: kernel \"decay\" promises no lowest eigenvalue");
  sound.lowest = 0.2;
  const Pressed promising(registry, {{RC_OPT_KERNEL, "decay"}});
  assert_int_equal(promising.status, RC_OK);
  assert_true(promising.result.load_lower <= silent.result.load && silent.result.load <= promising.result.load_upper);
  assert_true(promising.result.load_upper < 1.001 * silent.result.load);
  // The lowest eigenvalue of a symbol needs no promise.
  sound.lowest = 0;
  const Pressed periodic(registry, {{RC_OPT_KERNEL, "decay"}}, RC_BOUNDARY_PERIODIC);
  assert_int_equal(periodic.status, RC_OK);
  assert_true(periodic.result.load_lower <= periodic.result.load && periodic.result.load <= periodic.result.load_upper);
}

// Promises at random. Either the library sees that one is false, or the answer is right all the same: residuals rest on no
// promise, and intervals on those of the spectrum alone.
void false_promises_are_seen_or_do_no_harm(void**) {
  const double wanted = load_of_matrix(1);
  constexpr double least = 0.23;  // of exp(-r) on any set of cells of unit side
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> power(-2, 2);
  int refused = 0, narrow = 0;
  for (int draw = 0; draw < 60; ++draw) {
    Spoilt spoilt;
    (draw % 2 == 0 ? spoilt.lowest : spoilt.share) = least * std::pow(10, power(generator));
    const Registry registry("", RC_CONTEXT_NO_PLUGINS);
    const rc_kernel kernel = decay(spoilt);
    assert_int_equal(add(registry, kernel), RC_OK);
    const Pressed pressed(registry, {{RC_OPT_KERNEL, "decay"}, {RC_OPT_TOL, "1e-9"}});
    refused += pressed.status == RC_ERR_NUMERIC;
    if (pressed.status == RC_ERR_NUMERIC) continue;
    assert_int_equal(pressed.status, RC_OK);
    assert_near(pressed.result.load, wanted, 1e-6);
    const bool holds = pressed.result.load_lower <= wanted * (1 + 1e-8) && wanted <= pressed.result.load_upper * (1 + 1e-8);
    narrow += !holds;
    if (!holds) assert_true(spoilt.lowest > least || spoilt.share > 0);
  }
  print_message("%d of 60 promises refused, %d intervals too narrow\n", refused, narrow);
  assert_true(refused > 10 && refused < 50);
}

}  // namespace

const std::vector<CMUnitTest> promise_tests = {
    cmocka_unit_test(what_cannot_be_true_is_refused),
    cmocka_unit_test(failures_are_passed_on),
    cmocka_unit_test(what_is_left_out_is_seen),
    cmocka_unit_test(intervals_rest_on_what_is_promised),
    cmocka_unit_test(false_promises_are_seen_or_do_no_harm),
};

}  // namespace plugins

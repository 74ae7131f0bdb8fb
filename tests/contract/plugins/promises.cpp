// Promises of kernels: intervals rest on them, and false ones are seen or do no harm. Values that cannot be true are refused by
// rows of tests/contract/errors/table.txt.
#include <random>

#include "kernel_scene.h"

namespace plugins {

namespace {

rc_status unwilling(const rc_host* host, const rc_kernel_spec*, double*) {
  return host->fail(host, RC_ERR_EXTERNAL, "decay: no wave here");
}
rc_status idle(const rc_host*, const rc_kernel_spec*, double*) { return RC_OK; }
rc_status half_done(const rc_host*, const rc_kernel_spec*, double*) { return RC_STOP_TIME; }

void failures_are_passed_on_and_what_is_left_out_is_seen() {
  const struct {
    decltype(rc_kernel::symbol) symbol;
    rc_status status;
    const char* message;
  } rows[] = {{unwilling, RC_ERR_EXTERNAL, "rc_contact_create: decay: no wave here"},
              {idle, RC_ERR_NUMERIC, "the symbol at wave numbers (1, 0) is nan"},
              {half_done, RC_ERR_NUMERIC, "the kernel's symbol returned 102, must be RC_OK or an error"}};
  for (const auto& row : rows) {
    const Registry registry("", RC_CONTEXT_NO_PLUGINS);
    Spoilt sound;
    rc_kernel kernel = decay(sound);
    kernel.symbol = row.symbol;
    assert_int_equal(registry.add(kernel), RC_OK);
    assert_int_equal(pressed(registry, {}, RC_BOUNDARY_PERIODIC).status, row.status);
    assert_message_has(row.message);
  }
}

// H less 0.2 times the identity is positive definite as well: each diagonal entry grows by what the kernel adds there.
void intervals_rest_on_what_is_promised() {
  Spoilt sound;
  sound.x = sound.y = 0;
  sound.value = 1.2;
  const rc_kernel kernel = decay(sound);
  const Registry registry("", RC_CONTEXT_NO_PLUGINS);
  assert_int_equal(registry.add(kernel), RC_OK);
  const Pressed silent = pressed(registry);
  assert_int_equal(silent.status, RC_OK);
  assert_true(std::isnan(silent.result.load_upper));
  assert_has(silent.result.note, "bounds: kernel \"decay\" promises no lowest eigenvalue");
  sound.lowest = 0.2;
  const Pressed promising = pressed(registry);
  assert_int_equal(promising.status, RC_OK);
  assert_true(promising.result.load_lower <= silent.result.load && silent.result.load <= promising.result.load_upper);
  assert_true(promising.result.load_upper < 1.001 * silent.result.load);
  // The lowest eigenvalue of a symbol needs no promise.
  sound.lowest = 0;
  const Pressed periodic = pressed(registry, {}, RC_BOUNDARY_PERIODIC);
  assert_int_equal(periodic.status, RC_OK);
  assert_true(periodic.result.load_lower <= periodic.result.load && periodic.result.load <= periodic.result.load_upper);
}

// Promises at random. Either the library sees that one is false, or the answer is right all the same: residuals rest on no
// promise, and intervals on those of the spectrum alone.
void false_promises_are_seen_or_do_no_harm() {
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
    assert_int_equal(registry.add(kernel), RC_OK);
    const Pressed found = pressed(registry, {{RC_OPT_TOL, "1e-9"}});
    refused += found.status == RC_ERR_NUMERIC;
    if (found.status == RC_ERR_NUMERIC) continue;
    assert_int_equal(found.status, RC_OK);
    assert_near(found.result.load, wanted, 1e-6);
    const bool holds = found.result.load_lower <= wanted * (1 + 1e-8) && wanted <= found.result.load_upper * (1 + 1e-8);
    narrow += !holds;
    if (!holds) assert_true(spoilt.lowest > least || spoilt.share > 0);
  }
  print_message("%d of 60 promises refused, %d intervals too narrow\n", refused, narrow);
  assert_true(refused > 10 && refused < 50);
}

}  // namespace

std::vector<pairs::Test> promise_tests() {
  return {
      TEST(failures_are_passed_on_and_what_is_left_out_is_seen),
      TEST(intervals_rest_on_what_is_promised),
      TEST(false_promises_are_seen_or_do_no_harm),
  };
}

}  // namespace plugins

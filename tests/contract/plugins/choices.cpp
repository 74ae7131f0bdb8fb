// The choices of "auto" among components from outside, by the costs that they state.
#include <cmath>
#include <limits>

#include "scratch.h"

namespace plugins {

namespace {

// All points may carry pressure; large enough for auto to look at plugins.
Pressed press(const Registry& registry, pairs::Settings settings = {}) {
  pairs::Problem problem;
  problem.system.nx = problem.system.ny = 24;
  for (std::int64_t i = 0; i < 24 * 24; ++i) problem.gap.push_back(0.1 * std::sin(0.7 * static_cast<double>(i)));
  problem.target = 0.2;
  settings.insert(settings.begin(), {RC_OPT_TOL, "1e-8"});
  Pressed made(registry, problem, settings);
  if (made.status != RC_OK) fail_msg("%s", rc_last_error());
  return made;
}

// A copy of the linked backend, which must outlive the registry.
rc_backend backend(const char* name, decltype(rc_backend::score) score, std::uint64_t caps = RC_CAP_THREAD_INVARIANT) {
  rc_backend copy = *linked().backends[0];
  copy.name = name;
  copy.caps |= caps;
  copy.n_options = 0;
  copy.score = score;
  return copy;
}

rc_status by_pivoting(const rc_host*, const rc_problem* problem, const rc_options*, double* p, double*) {
  return support::inner_solve(problem, "nnls", p);
}
rc_solver solver(const char* name, decltype(rc_solver::score) score) {
  rc_solver made = support::solver(name, by_pivoting);
  made.score = score;
  return made;
}

// No components but the built-in ones and these.
struct With {
  template <class... Components> explicit With(const Components&... components) {
    (pairs::check(registry.add(components) == RC_OK, rc_last_error()), ...);
  }
  const Registry registry{"", RC_CONTEXT_NO_PLUGINS};
};

rc_status at_once(const rc_facts*, rc_estimate*) { return RC_OK; }
rc_status in_no_time(const rc_facts* facts, rc_estimate* estimate) {
  estimate->seconds = facts->backend->product;
  return RC_OK;
}
rc_status beyond_all_memory(const rc_facts*, rc_estimate* estimate) {
  estimate->bytes = 1e30;
  return RC_OK;
}
rc_status not_a_time(const rc_facts*, rc_estimate* estimate) {
  estimate->seconds = std::numeric_limits<double>::quiet_NaN();
  return RC_OK;
}
rc_status refuses(const rc_facts* facts, rc_estimate*) {
  return facts->host->fail(facts->host, RC_ERR_INCOMPATIBLE, "not on this day");
}

void a_slow_backend_in_a_file_is_looked_at_and_left() {
  const Scratch scratch;
  scratch.put({"aaa"});
  const Registry registry(scratch.path());
  const Pressed pressed = press(registry);
  assert_true(pressed.pair().find("aaa") == std::string::npos);
  assert_has(pressed.explanation(), " on aaa: ");
}

void a_fast_backend_is_taken() {
  const rc_backend fast = backend("zzz", at_once);
  assert_has(press(With(fast).registry).pair(), " on zzz");
}

// A backend whose products are wrong after some that are right, as by a fault of a device.
std::int64_t bound = 0, products = 0, right_products = 0;

rc_status bind_and_note(void* self, const rc_domain* domain) {
  bound = domain->n;
  return linked().backends[0]->bind(self, domain);
}
rc_status wrong_at_last(void* self, const double* x, double* y) {
  const rc_status status = linked().backends[0]->apply(self, x, y);
  if (++products > right_products)
    for (std::int64_t i = 0; i < bound; ++i) y[i] *= 1.1;
  return status;
}

void a_certifying_backend_proves_the_interval_of_the_stiffness() {
  rc_backend late = backend("late", at_once);
  late.bind = bind_and_note;
  late.apply = wrong_at_last;
  const With with(late);
  const auto pressed_on = [&](const char* name, const char* stiffness) {
    products = 0;
    return press(with.registry, {{RC_OPT_SOLVER, "polonsky-keer"},
                                 {RC_OPT_BACKEND, name},
                                 {RC_OPT_CERTIFY_BACKEND, "dense"},
                                 {RC_OPT_STIFFNESS, stiffness},
                                 {RC_OPT_TOL, "1e-10"}})
        .result;
  };
  const double wanted = pressed_on("dense", "2").stiffness;
  right_products = 1 << 20;
  pressed_on("late", "0");
  right_products = products;  // those of the solve
  const rc_result found = pressed_on("late", "2");
  assert_true(products > right_products);
  if (!(found.stiffness_lower <= wanted * (1 + 1e-9) && wanted * (1 - 1e-9) <= found.stiffness_upper &&
        found.stiffness_upper < 1.001 * found.stiffness_lower))
    fail_msg("%.12g is not in %.12g .. %.12g", wanted, found.stiffness_lower, found.stiffness_upper);
  assert_true(found.stiffness_lower <= found.stiffness && found.stiffness <= found.stiffness_upper);
}

void bits_that_depend_on_threads_are_for_those_who_name_the_backend() {
  const rc_backend loose = backend("loose", at_once, 0);
  const With with(loose);
  const Pressed pressed = press(with.registry);
  assert_true(pressed.pair().find("loose") == std::string::npos);
  assert_has(pressed.explanation(), "its bits depend on threads\n");
  assert_has(press(with.registry, {{RC_OPT_BACKEND, "loose"}}).pair(), " on loose");
}

void the_least_time_decides_between_solvers() {
  const rc_solver fastest = solver("fastest", in_no_time);
  const With with(fastest);
  assert_has(press(with.registry).pair(), "fastest on ");
  assert_has(press(with.registry, {{RC_OPT_SOLVER, "nnls"}}).pair(), "nnls on ");
}

void ties_go_by_name() {
  const rc_backend first = backend("ab", at_once), second = backend("bb", at_once);
  const rc_solver one = solver("a-solver", in_no_time), other = solver("b-solver", in_no_time);
  const With with(second, first, other, one);
  const Pressed pressed = press(with.registry);
  assert_string_equal(pressed.pair().c_str(), "a-solver on ab");
  assert_has(pressed.explanation(), "a-solver on bb: 0 s, 0 MiB, later by name\n");
  assert_has(pressed.explanation(), "b-solver on ab: 0 s, 0 MiB, later by name\n");
}

void what_does_not_say_its_cost_comes_last() {
  const rc_backend silent = backend("a-silent", nullptr), instant = backend("b-instant", at_once);
  const rc_solver mute = solver("a-mute", nullptr);
  const With with(silent, mute);
  const Pressed pressed = press(with.registry);
  assert_string_equal(pressed.pair().c_str(), press(With().registry).pair().c_str());
  for (const char* line : {"a-mute on ", " on a-silent: ", "does not say what it costs\n"})
    assert_has(pressed.explanation(), line);
  // However fast its products are.
  assert_int_equal(with.registry.add(instant), RC_OK);
  assert_string_equal(press(with.registry).pair().c_str(), "haar-cg on b-instant");
  // It serves where nothing else does.
  const With alone(silent);
  if (alone.registry.lists("fft")) return;  // linked in, it does
  const Pressed without = press(alone.registry, {{"dense.memory_limit", "1"}});
  assert_has(without.pair(), " on a-silent");
  assert_has(without.explanation(), "the limit dense.memory_limit is 1 MiB");
}

void what_needs_too_much_memory_is_left() {
  const rc_backend hungry = backend("hungry", beyond_all_memory);
  const With with(hungry);
  const Pressed pressed = press(with.registry);
  assert_true(pressed.pair().find("hungry") == std::string::npos);
  assert_has(pressed.explanation(), "needs 1e+30 bytes on hungry, this machine has ");
  assert_has(press(with.registry, {{RC_OPT_BACKEND, "hungry"}}).pair(), " on hungry");
}

void reasons_are_explained() {
  const rc_backend confused = backend("confused", not_a_time), unwilling = backend("unwilling", refuses);
  const With with(confused, unwilling);
  const Pressed pressed = press(with.registry);
  const std::string text = pressed.explanation(), taken = pressed.pair();
  for (const std::string& line :
       {"576 of 576 points may carry pressure, in a box of 576, tol = 1e-08\n" + taken + ": ", std::string(", taken\n"),
        std::string(", slower\n"), std::string("its estimate on confused is not a time\n"),
        std::string("unwilling: not on this day\n"), std::string("admm: by name only: "),
        std::string("callback: backend \"callback\" cannot do free boundaries\n")})
    assert_has(text, line);
  assert_has(press(with.registry, {{RC_OPT_BACKEND, "unwilling"}}).pair(), " on unwilling");
}

rc_status no_room(const rc_host* host, const rc_operator_spec*, void**) {
  return host->fail(host, RC_ERR_MEMORY, "no room on the device");
}
rc_status lost(const rc_host* host, const rc_operator_spec*, void**) {
  return host->fail(host, RC_ERR_EXTERNAL, "the device is lost");
}

void what_fails_is_skipped() {
  for (const bool by_memory : {true, false}) {
    rc_backend broken = backend("broken", at_once);
    broken.create = by_memory ? no_room : lost;
    const With with(broken);
    const Pressed pressed = press(with.registry);
    assert_has(pressed.result.note,
               std::string("auto: skipped broken: ") + (by_memory ? "no room on the device" : "the device is lost"));
    assert_has(pressed.explanation(), "broken: has failed\n");
  }
}

}  // namespace

std::vector<pairs::Test> choice_tests() {
  return {
      TEST(a_slow_backend_in_a_file_is_looked_at_and_left),
      TEST(a_fast_backend_is_taken),
      TEST(a_certifying_backend_proves_the_interval_of_the_stiffness),
      TEST(bits_that_depend_on_threads_are_for_those_who_name_the_backend),
      TEST(the_least_time_decides_between_solvers),
      TEST(ties_go_by_name),
      TEST(what_does_not_say_its_cost_comes_last),
      TEST(what_needs_too_much_memory_is_left),
      TEST(reasons_are_explained),
      TEST(what_fails_is_skipped),
  };
}

}  // namespace plugins

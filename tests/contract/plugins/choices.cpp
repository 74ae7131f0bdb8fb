// The choices of "auto" among components from outside, by the costs that they state.
#include <cmath>
#include <limits>

#include "scratch.h"
#include "support/unit_system.h"

namespace plugins {

namespace {

constexpr std::int64_t side = 24;  // large enough for auto to look at plugins

// A contact of `side` x `side` points, all of which may carry pressure.
class Pressed {
 public:
  Pressed(const Registry& registry, const std::vector<std::pair<const char*, const char*>>& settings = {}) {
    assert_int_equal(rc_options_create(registry.get(), &options_), RC_OK);
    for (const auto& [key, value] : settings) assert_int_equal(rc_options_set_text(options_, key, value), RC_OK);
    rc_system system = support::unit_system();
    system.nx = system.ny = side;
    assert_int_equal(rc_contact_create(&system, options_, &contact_), RC_OK);
    assert_string_equal(explanation().c_str(), "");
    std::vector<double> gap(side * side);
    for (std::size_t i = 0; i < gap.size(); ++i) gap[i] = 0.1 * std::sin(0.7 * static_cast<double>(i));
    rc_step step = RC_STEP_INIT;
    step.control = RC_CONTROL_APPROACH;
    step.undeformed_gap.data = gap.data();
    step.target = 0.2;
    assert_int_equal(rc_contact_solve(contact_, &step, &result_), RC_OK);
  }
  ~Pressed() {
    rc_contact_destroy(contact_);
    rc_options_destroy(options_);
  }
  Pressed(const Pressed&) = delete;
  Pressed& operator=(const Pressed&) = delete;

  std::string pair() const { return std::string(result_.solver) + " on " + result_.backend; }
  std::string note() const { return result_.note; }
  const rc_result& result() const { return result_; }
  std::string explanation() const {
    const char* text = nullptr;
    assert_int_equal(rc_contact_explain(contact_, &text), RC_OK);
    return text;
  }

 private:
  rc_options* options_ = nullptr;
  rc_contact* contact_ = nullptr;
  rc_result result_ = RC_RESULT_INIT;
};

const rc_plugin& linked() {
  const rc_plugin* plugin = nullptr;
  assert_int_equal(rc_builtin_linked(nullptr, &plugin), RC_OK);
  return *plugin;
}

using BackendScore = decltype(rc_backend::score);

// Registers a copy of the linked backend.
void add_backend(const Registry& registry, rc_backend& copy, const char* name, BackendScore score,
                 decltype(rc_backend::create) create = linked().backends[0]->create, std::uint64_t caps = RC_CAP_THREAD_INVARIANT,
                 const rc_backend& of = *linked().backends[0]) {
  copy = of;
  copy.name = name;
  copy.caps |= caps;
  copy.n_options = 0;
  copy.create = create;
  copy.score = score;
  const rc_backend* const list[] = {&copy};
  rc_plugin plugin = linked();
  plugin.n_backends = 1;
  plugin.backends = list;
  assert_int_equal(rc_context_register(registry.get(), &plugin), RC_OK);
}

// A solver that has another one do it.
rc_status by_pivoting(const rc_host*, const rc_problem* problem, const rc_options*, double* p, double*) {
  std::vector<std::int64_t> all(static_cast<std::size_t>(problem->n));
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<std::int64_t>(i);
  return problem->inner(problem, "nnls", problem->n, all.data(), problem->tol, p, nullptr);
}

void add_solver(const Registry& registry, rc_solver& table, const char* name, decltype(rc_solver::score) score) {
  table = {.struct_size = sizeof(rc_solver),
           .name = name,
           .summary = "a test's",
           .license = "BSD-3-Clause",
           .controls = RC_CONTROL_APPROACH,
           .solve = by_pivoting,
           .score = score};
  const rc_solver* const list[] = {&table};
  rc_plugin plugin = linked();
  plugin.n_backends = 0;
  plugin.n_solvers = 1;
  plugin.solvers = list;
  assert_int_equal(rc_context_register(registry.get(), &plugin), RC_OK);
}

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

void a_slow_backend_in_a_file_is_looked_at_and_left(void**) {
  const Scratch scratch;
  scratch.put({"aaa"});
  const Registry registry(scratch.path());
  const Pressed pressed(registry);
  if (pressed.pair().find("aaa") != std::string::npos) print_error("%s\n", pressed.explanation().c_str());
  assert_true(pressed.pair().find("aaa") == std::string::npos);
  assert_has(pressed.explanation(), " on aaa: ");
}

void a_fast_backend_is_taken(void**) {
  const Registry registry("", RC_CONTEXT_NO_PLUGINS);
  rc_backend backend;
  add_backend(registry, backend, "zzz", at_once);
  assert_has(Pressed(registry).pair(), " on zzz");
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

void a_certifying_backend_proves_the_interval_of_the_stiffness(void**) {
  const Registry registry("", RC_CONTEXT_NO_PLUGINS);
  rc_backend backend, late = *linked().backends[0];
  late.bind = bind_and_note;
  late.apply = wrong_at_last;
  add_backend(registry, backend, "late", at_once, late.create, RC_CAP_THREAD_INVARIANT, late);
  const auto press = [&](const char* name, const char* stiffness) {
    products = 0;
    return Pressed(registry, {{RC_OPT_SOLVER, "polonsky-keer"},
                              {RC_OPT_BACKEND, name},
                              {RC_OPT_CERTIFY_BACKEND, "dense"},
                              {RC_OPT_STIFFNESS, stiffness},
                              {RC_OPT_TOL, "1e-10"}})
        .result();
  };
  const double wanted = press("dense", "2").stiffness;
  right_products = 1 << 20;
  press("late", "0");
  right_products = products;  // those of the solve
  const rc_result found = press("late", "2");
  assert_true(products > right_products);
  if (!(found.stiffness_lower <= wanted * (1 + 1e-9) && wanted * (1 - 1e-9) <= found.stiffness_upper &&
        found.stiffness_upper < 1.001 * found.stiffness_lower))
    fail_msg("%.12g is not in %.12g .. %.12g", wanted, found.stiffness_lower, found.stiffness_upper);
  assert_true(found.stiffness_lower <= found.stiffness && found.stiffness <= found.stiffness_upper);
}

void bits_that_depend_on_threads_are_for_those_who_name_the_backend(void**) {
  const Registry registry("", RC_CONTEXT_NO_PLUGINS);
  rc_backend backend;
  add_backend(registry, backend, "loose", at_once, linked().backends[0]->create, 0);
  const Pressed pressed(registry);
  assert_true(pressed.pair().find("loose") == std::string::npos);
  assert_has(pressed.explanation(), "its bits depend on threads\n");
  assert_has(Pressed(registry, {{RC_OPT_BACKEND, "loose"}}).pair(), " on loose");
}

void the_least_time_decides_between_solvers(void**) {
  const Registry registry("", RC_CONTEXT_NO_PLUGINS);
  rc_solver solver;
  add_solver(registry, solver, "fastest", in_no_time);
  assert_has(Pressed(registry).pair(), "fastest on ");
  assert_has(Pressed(registry, {{RC_OPT_SOLVER, "nnls"}}).pair(), "nnls on ");
}

void ties_go_by_name(void**) {
  const Registry registry("", RC_CONTEXT_NO_PLUGINS);
  rc_backend first, second;
  add_backend(registry, second, "bb", at_once);
  add_backend(registry, first, "ab", at_once);
  rc_solver one, other;
  add_solver(registry, other, "b-solver", in_no_time);
  add_solver(registry, one, "a-solver", in_no_time);
  const Pressed pressed(registry);
  assert_string_equal(pressed.pair().c_str(), "a-solver on ab");
  assert_has(pressed.explanation(), "a-solver on bb: 0 s, 0 MiB, later by name\n");
  assert_has(pressed.explanation(), "b-solver on ab: 0 s, 0 MiB, later by name\n");
}

void what_does_not_say_its_cost_comes_last(void**) {
  const Registry registry("", RC_CONTEXT_NO_PLUGINS);
  rc_backend backend;
  rc_solver solver;
  add_backend(registry, backend, "a-silent", nullptr);
  add_solver(registry, solver, "a-mute", nullptr);
  const Pressed pressed(registry);
  assert_string_equal(pressed.pair().c_str(), Pressed(Registry("", RC_CONTEXT_NO_PLUGINS)).pair().c_str());
  for (const char* line : {"a-mute on ", " on a-silent: "}) assert_has(pressed.explanation(), line);
  assert_has(pressed.explanation(), "does not say what it costs\n");
  // However fast its products are.
  rc_backend other;
  add_backend(registry, other, "b-instant", at_once);
  assert_string_equal(Pressed(registry).pair().c_str(), "haar-cg on b-instant");
  // It serves where nothing else does.
  const Registry alone("", RC_CONTEXT_NO_PLUGINS);
  if (alone.lists("fft")) return;  // linked in, it does
  add_backend(alone, other, "a-silent", nullptr);
  const Pressed without(alone, {{"dense.memory_limit", "1"}});
  assert_has(without.pair(), " on a-silent");
  assert_has(without.explanation(), "the limit dense.memory_limit is 1 MiB");
}

void what_needs_too_much_memory_is_left(void**) {
  const Registry registry("", RC_CONTEXT_NO_PLUGINS);
  rc_backend backend;
  add_backend(registry, backend, "hungry", beyond_all_memory);
  const Pressed pressed(registry);
  assert_true(pressed.pair().find("hungry") == std::string::npos);
  assert_has(pressed.explanation(), "needs 1e+30 bytes on hungry, this machine has ");
  assert_has(Pressed(registry, {{RC_OPT_BACKEND, "hungry"}}).pair(), " on hungry");
}

void reasons_are_explained(void**) {
  const Registry registry("", RC_CONTEXT_NO_PLUGINS);
  rc_backend confused, unwilling;
  add_backend(registry, confused, "confused", not_a_time);
  add_backend(registry, unwilling, "unwilling", refuses);
  const Pressed pressed(registry);
  const std::string text = pressed.explanation();
  assert_has(text, "576 of 576 points may carry pressure, in a box of 576, tol = 1e-08\n" + pressed.pair() + ": ");
  assert_has(text, ", taken\n");
  assert_has(text, ", slower\n");
  assert_has(text, "its estimate on confused is not a time\n");
  assert_has(text, "unwilling: not on this day\n");
  assert_has(text, "admm: by name only: ");
  assert_has(text, "callback: backend \"callback\" cannot do free boundaries\n");
  assert_has(Pressed(registry, {{RC_OPT_BACKEND, "unwilling"}}).pair(), " on unwilling");
}

rc_status no_room(const rc_host* host, const rc_operator_spec*, void**) {
  return host->fail(host, RC_ERR_MEMORY, "no room on the device");
}

rc_status lost(const rc_host* host, const rc_operator_spec*, void**) {
  return host->fail(host, RC_ERR_EXTERNAL, "the device is lost");
}

void what_fails_is_skipped(void**) {
  for (const bool by_memory : {true, false}) {
    const Registry registry("", RC_CONTEXT_NO_PLUGINS);
    rc_backend backend;
    add_backend(registry, backend, "broken", at_once, by_memory ? no_room : lost);
    const Pressed pressed(registry);
    assert_has(pressed.note(),
               by_memory ? "auto: skipped broken: no room on the device" : "auto: skipped broken: the device is lost");
    assert_has(pressed.explanation(), "broken: has failed\n");
  }
}

}  // namespace

const std::vector<CMUnitTest> choice_tests = {
    cmocka_unit_test(a_slow_backend_in_a_file_is_looked_at_and_left),
    cmocka_unit_test(a_fast_backend_is_taken),
    cmocka_unit_test(a_certifying_backend_proves_the_interval_of_the_stiffness),
    cmocka_unit_test(bits_that_depend_on_threads_are_for_those_who_name_the_backend),
    cmocka_unit_test(the_least_time_decides_between_solvers),
    cmocka_unit_test(ties_go_by_name),
    cmocka_unit_test(what_does_not_say_its_cost_comes_last),
    cmocka_unit_test(what_needs_too_much_memory_is_left),
    cmocka_unit_test(reasons_are_explained),
    cmocka_unit_test(what_fails_is_skipped),
};

}  // namespace plugins

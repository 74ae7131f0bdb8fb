// Kernels from outside: what they give, what is refused, and that nothing is written where one is.
#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "plugins/scratch.h"
#include "plugins/toy_kernel.h"
#include "support/unit_system.h"

namespace plugins {

namespace {

constexpr std::int64_t side = 12;
constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();

// What a kernel says, spoilt on purpose.
struct Spoilt {
  std::int64_t x = -1, y = -1;  // where it says `value`
  double value = 0, factor = 1, lowest = 0, share = 0;
};

const Spoilt& of(const rc_kernel_spec* spec) { return *static_cast<const Spoilt*>(spec->kernel->user); }

rc_status decay_window(const rc_host*, const rc_kernel_spec* spec, std::int64_t first_x, std::int64_t first_y, std::int64_t mx,
                       std::int64_t my, double* out) {
  for (std::int64_t iy = first_y; iy < first_y + my; ++iy)
    for (std::int64_t ix = first_x; ix < first_x + mx; ++ix)
      *out++ = ix == of(spec).x && iy == of(spec).y
                   ? of(spec).value
                   : of(spec).factor * std::exp(-std::hypot(spec->system->hx * static_cast<double>(ix),
                                                            spec->system->hy * static_cast<double>(iy)));
  return RC_OK;
}

rc_status decay_symbol(const rc_host*, const rc_kernel_spec* spec, double* out) {
  for (std::int64_t ky = 0; ky <= spec->system->ny / 2; ++ky)
    for (std::int64_t kx = 0; kx <= spec->system->nx / 2; ++kx)
      *out++ = kx == of(spec).x && ky == of(spec).y ? of(spec).value : 1 / (1.0 + static_cast<double>(kx * kx + ky * ky));
  return RC_OK;
}

rc_status decay_bounds(const rc_host*, const rc_kernel_spec* spec, rc_kernel_bounds* out) {
  out->lowest = of(spec).lowest;
  out->galerkin_share = of(spec).share;
  return RC_OK;
}

rc_kernel decay(Spoilt& spoilt) {
  return {.struct_size = sizeof(rc_kernel),
          .name = "decay",
          .summary = "a test's",
          .license = "BSD-3-Clause",
          .caps = RC_KERNEL_FREE | RC_KERNEL_PERIODIC | RC_KERNEL_POSITIVE,
          .n_options = 0,
          .options = nullptr,
          .window = decay_window,
          .symbol = decay_symbol,
          .bounds = decay_bounds,
          .user = &spoilt};
}

rc_status add(const Registry& registry, const rc_kernel& kernel) {
  const rc_kernel* const kernels[] = {&kernel};
  const rc_plugin plugin = {.struct_size = sizeof(rc_plugin),
                            .abi_major = RC_PLUGIN_ABI_MAJOR,
                            .abi_minor = RC_PLUGIN_ABI_MINOR,
                            .name = "decay",
                            .version = "1.0",
                            .n_backends = 0,
                            .n_solvers = 0,
                            .backends = nullptr,
                            .solvers = nullptr,
                            .n_kernels = 1,
                            .kernels = kernels};
  return rc_context_register(registry.get(), &plugin);
}

using Settings = std::vector<std::pair<const char*, std::string>>;

// A contact of a paraboloid with a kernel of one's own.
class Pressed {
 public:
  Pressed(const Registry& registry, const Settings& settings, std::int32_t boundary = RC_BOUNDARY_FREE, double cell = 1,
          std::int64_t points = side)
      : side_(points) {
    assert_int_equal(rc_options_create(registry.get(), &options_), RC_OK);
    for (const auto& [key, value] : settings) assert_int_equal(rc_options_parse(options_, key, value.c_str()), RC_OK);
    system_.nx = system_.ny = side_;
    system_.hx = system_.hy = cell;
    system_.boundary = boundary;
    p.assign(static_cast<std::size_t>(side_ * side_), -7);
    for (std::int64_t i = 0; i < side_ * side_; ++i) {
      const double x = static_cast<double>(i % side_) - 5.5, y = static_cast<double>(i / side_) - 5.25;
      gap_.push_back(0.02 * cell * (x * x + y * y));
    }
    status = rc_contact_create(&system_, options_, &contact_);
    if (status == RC_OK) solve();
  }
  ~Pressed() {
    rc_contact_destroy(contact_);
    rc_options_destroy(options_);
  }
  Pressed(const Pressed&) = delete;
  Pressed& operator=(const Pressed&) = delete;

  void solve() {
    rc_step step = RC_STEP_INIT;
    step.control = RC_CONTROL_DISPLACEMENT;
    step.target = 0.4 * system_.hx;
    step.undeformed_gap = gap_.data();
    result.p = p.data();
    status = rc_contact_solve(contact_, &step, &result);
  }
  std::string explanation() const {
    const char* text = nullptr;
    assert_int_equal(rc_contact_explain(contact_, &text), RC_OK);
    return text;
  }
  bool untouched() const { return result.points == 0 && p == std::vector<double>(p.size(), -7); }

  rc_status status = RC_OK;
  rc_result result = RC_RESULT_INIT;
  std::vector<double> p;

 private:
  std::int64_t side_;
  rc_system system_ = support::unit_system();
  rc_options* options_ = nullptr;
  rc_contact* contact_ = nullptr;
  std::vector<double> gap_;
};

void assert_near(double value, double wanted, double tolerance) {
  if (!(std::abs(value - wanted) <= tolerance * std::abs(wanted))) fail_msg("%.17g instead of %.17g", value, wanted);
}

// The same coefficients as a matrix of the caller's.
double load_of_matrix(double rate) {
  const std::int64_t n = side * side;
  std::vector<double> h, gap;
  for (std::int64_t i = 0; i < n; ++i) {
    const double x = static_cast<double>(i % side) - 5.5, y = static_cast<double>(i / side) - 5.25;
    gap.push_back(0.02 * (x * x + y * y));
    for (std::int64_t j = 0; j < n; ++j)
      h.push_back(
          std::exp(-rate * std::hypot(static_cast<double>(i % side - j % side), static_cast<double>(i / side - j / side))));
  }
  rc_system system = support::unit_system();
  system.op = RC_OPERATOR_DENSE;
  system.nx = system.ny = side;
  system.dense = h.data();
  system.dense_ld = n;
  rc_step step = RC_STEP_INIT;
  step.control = RC_CONTROL_DISPLACEMENT;
  step.target = 0.4;
  step.undeformed_gap = gap.data();
  rc_result result = RC_RESULT_INIT;
  assert_int_equal(rc_solve(&system, &step, nullptr, &result), RC_OK);
  return result.load;
}

void a_kernel_of_ones_own_serves_every_pair(void**) {
  const Registry registry("");
  Spoilt sound;
  const rc_kernel kernel = decay(sound);
  assert_int_equal(add(registry, kernel), RC_OK);
  const double wanted = load_of_matrix(1);
  for (std::int64_t i = 0; i < rc_solver_count(registry.get()); ++i)
    for (const char* backend : {"dense", "fft", "cholmod"}) {
      rc_component solver = RC_COMPONENT_INIT;
      assert_int_equal(rc_solver_describe(registry.get(), i, &solver), RC_OK);
      double periodic = 0;
      for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC}) {
        const Pressed pressed(registry,
                              {{RC_OPT_KERNEL, "decay"},
                               {RC_OPT_SOLVER, solver.name},
                               {RC_OPT_BACKEND, backend},
                               {RC_OPT_TOL, "1e-9"},
                               {RC_OPT_MAX_ITER, "100000"}},
                              boundary);
        if (pressed.status == RC_ERR_NO_BACKEND) continue;  // not built
        if (pressed.status != RC_OK && std::string(solver.name) != "greedy")
          fail_msg("%s on %s: %s", solver.name, backend, rc_last_error());
        if (pressed.status != RC_OK) continue;
        assert_string_equal(pressed.result.kernel, "decay");
        if (boundary == RC_BOUNDARY_FREE) assert_near(pressed.result.load, wanted, 1e-6);
        if (boundary == RC_BOUNDARY_PERIODIC) periodic = pressed.result.load;
      }
      if (periodic != 0)
        assert_near(periodic,
                    Pressed(registry, {{RC_OPT_KERNEL, "decay"}, {RC_OPT_BACKEND, "dense"}}, RC_BOUNDARY_PERIODIC).result.load,
                    1e-6);
    }
}

void a_kernel_comes_from_a_file(void**) {
  const Scratch scratch;
  const std::string file = scratch.put({"toy-kernel"});
  const Registry registry(scratch.path());
  // Its option loads it; lengths are the caller's, whatever the cell.
  const double wanted = load_of_matrix(0.25);
  for (const double cell : {1.0, 1e-6}) {
    const Pressed pressed(registry, {{"toy-kernel.rate", std::to_string(0.25 / cell)}, {RC_OPT_KERNEL, "toy-kernel"}},
                          RC_BOUNDARY_FREE, cell);
    assert_int_equal(pressed.status, RC_OK);
    assert_near(pressed.result.load, wanted * cell * cell, 1e-6);
  }
  bool found = false;
  for (std::int64_t i = 0; i < rc_kernel_count(registry.get()); ++i) {
    rc_component each = RC_COMPONENT_INIT;
    assert_int_equal(rc_kernel_describe(registry.get(), i, &each), RC_OK);
    if (std::string(each.name) != "toy-kernel") continue;
    found = true;
    assert_string_equal(each.origin, file.c_str());
    assert_string_equal(each.license, "BSD-3-Clause");
  }
  assert_true(found);
}

void its_options_are_fixed(void**) {
  const Scratch scratch;
  scratch.put({"toy-kernel"});
  const Registry registry(scratch.path());
  rc_options* options = nullptr;
  assert_int_equal(rc_options_create(registry.get(), &options), RC_OK);
  assert_int_equal(rc_options_set_text(options, RC_OPT_KERNEL, "toy-kernel"), RC_OK);
  const rc_system system = support::unit_system();
  rc_contact* contact = nullptr;
  assert_int_equal(rc_contact_create(&system, options, &contact), RC_OK);
  assert_int_equal(rc_options_set_real(options, "toy-kernel.rate", 2), RC_OK);
  assert_int_equal(rc_contact_set_options(contact, options), RC_ERR_OPTION);
  assert_message_has("option \"toy-kernel.rate\" is fixed when the contact is created; make a new contact to change it");
  rc_contact_destroy(contact);
  rc_options_destroy(options);
}

// Of a kernel with one member changed.
rc_status registered(const std::function<void(rc_kernel&)>& change) {
  const Registry registry("", RC_CONTEXT_NO_PLUGINS);
  Spoilt sound;
  rc_kernel kernel = decay(sound);
  change(kernel);
  return add(registry, kernel);
}

void spoilt_kernels_are_refused(void**) {
  assert_int_equal(registered([](rc_kernel&) {}), RC_OK);
  assert_int_equal(registered([](rc_kernel& k) { k.window = nullptr; }), RC_ERR_PLUGIN);
  assert_message_has("kernel \"decay\" has no window() but its caps say otherwise");
  assert_int_equal(registered([](rc_kernel& k) { k.caps = RC_KERNEL_FREE; }), RC_ERR_PLUGIN);
  assert_message_has("kernel \"decay\" has symbol() but its caps say otherwise");
  assert_int_equal(registered([](rc_kernel& k) {
                     k.caps = 0;
                     k.window = nullptr;
                     k.symbol = nullptr;
                   }),
                   RC_ERR_PLUGIN);
  assert_message_has("kernel \"decay\" lacks window and symbol");
  assert_int_equal(registered([](rc_kernel& k) { k.name = "love"; }), RC_ERR_PLUGIN);
  assert_message_has("a component named \"love\" is registered already");
  assert_int_equal(registered([](rc_kernel& k) { k.license = nullptr; }), RC_ERR_PLUGIN);
}

void boundaries_and_cells_are_checked(void**) {
  const Registry registry("", RC_CONTEXT_NO_PLUGINS);
  Spoilt sound;
  rc_kernel kernel = decay(sound);
  kernel.caps = RC_KERNEL_FREE | RC_KERNEL_SQUARE;
  kernel.symbol = nullptr;
  assert_int_equal(add(registry, kernel), RC_OK);
  assert_int_equal(Pressed(registry, {{RC_OPT_KERNEL, "decay"}}, RC_BOUNDARY_PERIODIC).status, RC_ERR_INCOMPATIBLE);
  assert_message_has("kernel \"decay\" is for free boundaries, the system has periodic ones; use kernel=auto");
  assert_int_equal(Pressed(registry, {{RC_OPT_KERNEL, "decay"}}).status, RC_OK);
  rc_options* options = nullptr;
  assert_int_equal(rc_options_create(registry.get(), &options), RC_OK);
  assert_int_equal(rc_options_set_text(options, RC_OPT_KERNEL, "decay"), RC_OK);
  rc_system system = support::unit_system();
  system.hy = 2 * system.hx;
  rc_contact* contact = nullptr;
  assert_int_equal(rc_contact_create(&system, options, &contact), RC_ERR_INCOMPATIBLE);
  assert_message_has("kernel \"decay\" needs square cells");
  rc_options_destroy(options);
}

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
  return host->fail(host, RC_ERR_EXTERNAL, "decay: no wave today");
}

void failures_are_passed_on(void**) {
  const Registry registry("", RC_CONTEXT_NO_PLUGINS);
  Spoilt sound;
  rc_kernel kernel = decay(sound);
  kernel.symbol = unwilling;
  assert_int_equal(add(registry, kernel), RC_OK);
  const Pressed pressed(registry, {{RC_OPT_KERNEL, "decay"}}, RC_BOUNDARY_PERIODIC);
  assert_int_equal(pressed.status, RC_ERR_EXTERNAL);
  assert_message_has("rc_contact_create: decay: no wave today");
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

void a_backend_that_needs_the_far_field_is_passed_over(void**) {
  const Registry registry("");
  Spoilt sound;
  const rc_kernel kernel = decay(sound);
  assert_int_equal(add(registry, kernel), RC_OK);
  const Pressed pressed(registry, {{RC_OPT_KERNEL, "decay"}, {RC_OPT_BACKEND, "split"}});
  if (pressed.status == RC_ERR_NO_BACKEND) skip();
  assert_int_equal(pressed.status, RC_ERR_INCOMPATIBLE);
  assert_message_has("backend \"split\" cannot do kernel \"decay\", whose far field is not that of the half-space");
  const Pressed chosen(registry, {{RC_OPT_KERNEL, "decay"}, {RC_OPT_BACKEND, "split,dense"}});
  assert_int_equal(chosen.status, RC_OK);
  assert_string_equal(chosen.result.backend, "dense");
  const Pressed large(registry, {{RC_OPT_KERNEL, "decay"}}, RC_BOUNDARY_FREE, 1, 512);
  assert_int_equal(large.status, RC_OK);
  assert_has(large.explanation(),
             "split: backend \"split\" cannot do kernel \"decay\", whose far field is not that of the half-space\n");
}

}  // namespace

const std::vector<CMUnitTest> kernel_tests = {
    cmocka_unit_test(a_kernel_of_ones_own_serves_every_pair),
    cmocka_unit_test(a_kernel_comes_from_a_file),
    cmocka_unit_test(its_options_are_fixed),
    cmocka_unit_test(spoilt_kernels_are_refused),
    cmocka_unit_test(boundaries_and_cells_are_checked),
    cmocka_unit_test(what_cannot_be_true_is_refused),
    cmocka_unit_test(failures_are_passed_on),
    cmocka_unit_test(what_is_left_out_is_seen),
    cmocka_unit_test(intervals_rest_on_what_is_promised),
    cmocka_unit_test(false_promises_are_seen_or_do_no_harm),
    cmocka_unit_test(a_backend_that_needs_the_far_field_is_passed_over),
};

}  // namespace plugins

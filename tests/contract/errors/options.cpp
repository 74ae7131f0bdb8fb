#include <string>

#include "case.h"
#include "scene.h"

namespace errors {

namespace {

template <class Set> auto on_options(const Set& set) {
  return [set] {
    const OptionsHandle options = options_with({});
    return Outcome(set(options.get()));
  };
}

auto set_number(const char* key, double value) {
  return on_options([=](rc_options* o) { return rc_options_set_number(o, key, value); });
}
auto set_text(const char* key, const char* text) {
  return on_options([=](rc_options* o) { return rc_options_set_text(o, key, text); });
}

// A number without a fraction is an integer, whatever function sets it.
Outcome whole_number_set() {
  const OptionsHandle options = options_with({});
  const Outcome outcome = rc_options_set_number(options.get(), "max_iter", 7);
  double most = 0;
  assert_int_equal(rc_options_get_number(options.get(), "max_iter", &most), RC_OK);
  assert_true(most == 7);
  return outcome;
}

Outcome described(std::int32_t kind, std::int64_t i) {
  rc_component component = RC_COMPONENT_INIT;
  return rc_component_describe(nullptr, kind, i, &component);
}

auto changed_later(const char* key, const char* value) {
  return [=] {
    const Scene scene;
    const ContactHandle contact = made(scene);
    return Outcome(rc_contact_set_options(contact.get(), options_with({{key, value}}).get()));
  };
}

// Options that cannot be used leave those in force as they were.
Outcome solves_after_refused_options() {
  const Scene scene;
  const ContactHandle contact = made(scene, options_with({{"solver", "nnls"}}).get());
  assert_int_equal(rc_contact_set_options(contact.get(), options_with({{"solver", "no-such"}}).get()), RC_ERR_NO_SOLVER);
  const Outcome outcome = solve(contact.get(), scene);
  assert_string_equal(answer().result()->solver, "nnls");
  return outcome;
}

// The copy is as the options were, and neither changes with the other.
Outcome copied() {
  const OptionsHandle options = options_with({{"tol", "1e-7"}, {"solver", "nnls"}, {"threads", "3"}});
  rc_options* copy = nullptr;
  const Outcome outcome = rc_options_copy(options.get(), &copy);
  const OptionsHandle keep(copy);
  assert_int_equal(rc_options_set_number(options.get(), "tol", 1e-5), RC_OK);
  assert_int_equal(rc_options_set_number(copy, "threads", 2), RC_OK);
  double tol = 0;
  double threads = 0;
  const char* solver = nullptr;
  assert_int_equal(rc_options_get_number(copy, "tol", &tol), RC_OK);
  assert_int_equal(rc_options_get_text(copy, "solver", &solver), RC_OK);
  assert_int_equal(rc_options_get_number(options.get(), "threads", &threads), RC_OK);
  assert_true(tol == 1e-7 && threads == 3);
  assert_string_equal(solver, "nnls");
  return outcome;
}

Outcome options_of_another_context() {
  const Scene scene;
  const ContactHandle contact = made(scene);
  rc_context* context = nullptr;
  assert_int_equal(rc_context_create(0, nullptr, nullptr, nullptr, &context), RC_OK);
  const ContextHandle keep(context);
  rc_options* options = nullptr;
  assert_int_equal(rc_options_create(context, &options), RC_OK);
  const OptionsHandle keep_options(options);
  return rc_contact_set_options(contact.get(), options);
}

// The operator is there already, and bound to the same points.
Outcome tightened_later() {
  const Scene scene;
  const auto with = [](const char* tol) { return options_with({{"backend", "fft"}, {"fft.precision", "single"}, {"tol", tol}}); };
  const ContactHandle contact = made(scene, with("1e-4").get());
  assert_int_equal(solve(contact.get(), scene), RC_OK);
  assert_int_equal(rc_contact_set_options(contact.get(), with("5e-6").get()), RC_OK);
  answer().prepare();
  return solve(contact.get(), scene);
}

Outcome long_key() {
  const OptionsHandle options = options_with({});
  return rc_options_set_text(options.get(), std::string(100000, 'x').c_str(), "1");
}

}  // namespace

Section options() {
  const rc_status refused = RC_ERR_OPTION;
  return {
      "Options",
      {
          {"unknown key",
           refused,
           {"rc_options_set_text: option \"maxiter\" is unknown; did you mean \"max_iter\"?"},
           set_text("maxiter", "5")},
          {"empty key", refused, {"option \"\" is unknown"}, set_text("", "5")},
          {"key of 100000 letters", refused, {"option \"xxxx"}, long_key},
          {"key with a path in it", refused, {"option \"../../evil.key\" is unknown"}, set_text("../../evil.key", "1")},
          {"key of a backend that is not installed",
           refused,
           {"option \"nobody.speed\" is unknown"},
           set_text("nobody.speed", "1")},
          {"number for a text", refused, {"rc_options_set_number: option \"solver\" takes a text"}, set_number("solver", 1)},
          {"number without a fraction for an integer", RC_OK, {}, whole_number_set},
          {"number with a fraction for an integer",
           refused,
           {"rc_options_set_number: option \"max_iter\" takes an integer, not 5.5"},
           set_number("max_iter", 5.5)},
          {"NaN for an integer", refused, {"option \"max_iter\" takes an integer, not nan"}, set_number("max_iter", nan)},
          {"text that is not a number",
           refused,
           {"rc_options_set_text: option \"tol\" takes a real number, not \"1e-8x\""},
           set_text("tol", "1e-8x")},
          {"text with a decimal comma", refused, {"option \"tol\" takes a real number, not \"0,01\""}, set_text("tol", "0,01")},
          {"two signs", refused, {"option \"max_iter\" takes an integer, not \"+-5\""}, set_text("max_iter", "+-5")},
          {"integer that overflows",
           refused,
           {"option \"max_iter\" takes an integer, not \"99999999999999999999\""},
           set_text("max_iter", "99999999999999999999")},
          {"tol = 0", refused, {"option \"tol\" = 0 is outside 1e-16 .. 0.1"}, set_number("tol", 0)},
          {"tol = NaN", refused, {"option \"tol\" = nan is outside 1e-16 .. 0.1"}, set_number("tol", nan)},
          {"time_limit = infinity",
           refused,
           {"option \"time_limit\" = inf is outside 0 .. 1000000000"},
           set_number("time_limit", infinity)},
          {"threads = 0", refused, {"option \"threads\" = 0 is outside 1 .. 1024"}, set_number("threads", 0)},
          {"max_iter = 1e300",
           refused,
           {"option \"max_iter\" = 1e+300 is outside 1 .. 1000000000"},
           set_number("max_iter", 1e300)},
          {"max_iter = infinity",
           refused,
           {"option \"max_iter\" = inf is outside 1 .. 1000000000"},
           set_number("max_iter", infinity)},
          {"text that is not one of the choices",
           refused,
           {"option \"fft.precision\" = \"mixt\" is none of auto|mixed|single; did you mean \"mixed\"?"},
           set_text("fft.precision", "mixt"),
           "fft"},
          {"tolerance that single precision does not hold",
           refused,
           {"rc_solve: ",
            "fft: tol = 1e-08 is below 1e-05, the limit of fft.precision=single; raise tol or set "
            "fft.precision=mixed"},
           [] {
             return Outcome(solve(Scene(), options_with({{"backend", "fft"}, {"fft.precision", "single"}}).get()));
           },
           "fft"},
          {"the same, set later", refused, {"rc_contact_solve: ", "fft: tol = 5e-06 is below 1e-05"}, tightened_later, "fft"},
          {"text read as a number",
           refused,
           {"rc_options_get_number: option \"solver\" is a text; use rc_options_get_text"},
           on_options([](rc_options* o) {
             double out = 0;
             return rc_options_get_number(o, "solver", &out);
           })},
          {"number read as a text",
           refused,
           {"rc_options_get_text: option \"tol\" is a number; use rc_options_get_number"},
           on_options([](rc_options* o) {
             const char* out = nullptr;
             return rc_options_get_text(o, "tol", &out);
           })},
          {"option number out of range",
           RC_ERR_ARGUMENT,
           {"rc_component_describe: i = -1: there are "},
           [] { return described(RC_COMPONENT_OPTION, -1); }},
          {"kernel changed after the contact was made",
           refused,
           {"rc_contact_set_options: option \"kernel\" is fixed when the contact is created; make a new contact to change it"},
           changed_later("kernel", "galerkin")},
          {"threads changed after the contact was made",
           refused,
           {"option \"threads\" is fixed when the contact is created"},
           changed_later("threads", "2")},
          {"fixed option set to the value it has", RC_OK, {}, changed_later("threads", "1")},
          {"a solver that does not exist, set later",
           RC_ERR_NO_SOLVER,
           {"rc_contact_set_options: solver \"nls\" not found; did you mean \"nnls\"?"},
           changed_later("solver", "nls")},
          {"a certifying backend that does not exist, set later",
           RC_ERR_NO_BACKEND,
           {"rc_contact_set_options: backend \"dens\" not found"},
           changed_later("certify_backend", "dens")},
          {"a certifying backend that cannot do the operator, set later",
           RC_ERR_INCOMPATIBLE,
           {"rc_contact_set_options: certify_backend = callback: this backend cannot do free boundaries"},
           changed_later("certify_backend", "callback")},
          {"solving after options were refused", RC_OK, {}, solves_after_refused_options},
          {"`rc_options_copy`: one of the two is changed", RC_OK, {}, copied},
          {"options of another context",
           refused,
           {"rc_contact_set_options: these options belong to another context"},
           options_of_another_context},
      }};
}

namespace {

// y = x + sum(x)
std::int32_t sums(const double* x, double* y, std::int64_t n, void*) {
  double sum = 0;
  for (std::int64_t i = 0; i < n; ++i) sum += x[i];
  for (std::int64_t i = 0; i < n; ++i) y[i] = x[i] + sum;
  return 0;
}

auto named(const char* key, const char* value, void (*change)(rc_system&) = nullptr) {
  return [=] {
    Scene scene;
    if (change) change(scene.system);
    return create(scene, options_with({{key, value}}).get());
  };
}

void periodic(rc_system& system) { system.boundary = RC_BOUNDARY_PERIODIC; }
void oblong(rc_system& system) { system.hy = 2; }

Outcome pair(const char* solver, const char* backend, std::int32_t control, const rc_options* options = nullptr) {
  const Scene scene = callback_scene([](const double*, double*, std::int64_t, void*) { return std::int32_t{0}; });
  return rc_pair_supported(nullptr, solver, backend, &scene.system, control, options);
}

}  // namespace

Section names() {
  const rc_status incompatible = RC_ERR_INCOMPATIBLE;
  return {
      "Names and combinations",
      {
          {"unknown solver",
           RC_ERR_NO_SOLVER,
           {"rc_contact_create: solver \"polonsky-kear\" not found; did you mean \"polonsky-keer\"?; available: "},
           named("solver", "polonsky-kear")},
          {"unknown backend",
           RC_ERR_NO_BACKEND,
           {"rc_contact_create: backend \"dens\" not found; did you mean \"dense\"?; available: "},
           named("backend", "dens")},
          {"empty backend", RC_ERR_NO_BACKEND, {"backend \"\" not found"}, named("backend", "")},
          {"list of backends that do not exist",
           RC_ERR_NO_BACKEND,
           {"backend \"dnse\" not found"},
           named("backend", "dnse,fftt")},
          {"unknown certifying backend", RC_ERR_NO_BACKEND, {"backend \"dens\" not found"}, named("certify_backend", "dens")},
          {"certifying backend that cannot do free boundaries",
           incompatible,
           {"rc_contact_create: certify_backend = callback: this backend cannot do free boundaries; leave the option empty or "
            "name one that can"},
           named("certify_backend", "callback")},
          {"certifying backend that cannot do periodic boundaries",
           incompatible,
           {"certify_backend = callback: this backend cannot do periodic boundaries"},
           named("certify_backend", "callback", periodic)},
          {"certifying backend that cannot do a matrix",
           incompatible,
           {"certify_backend = callback: this backend cannot do the caller's dense matrix"},
           [] {
             return solve(dense_scene(), options_with({{"certify_backend", "callback"}}).get());
           }},
          {"certifying backend that cannot do a product",
           incompatible,
           {"certify_backend = dense: this backend cannot do the caller's product"},
           [] {
             return solve(callback_scene(sums), options_with({{"certify_backend", "dense"}}).get());
           }},
          {"unknown kernel",
           RC_ERR_OPTION,
           {"rc_contact_create: kernel \"lov\" not found; did you mean \"love\"?; available: disc, eq9,"},
           named("kernel", "lov")},
          {"unknown kernel, its coefficients",
           RC_ERR_OPTION,
           {"rc_kernel_coefficients: kernel \"lovve\" not found; did you mean \"love\"?"},
           [] {
             double out[4];
             return rc_kernel_coefficients("lovve", 1, 1, 2, 2, out);
           }},
          {"periodic kernel for free boundaries",
           incompatible,
           {"kernel \"spectral\" is not for free boundaries, which the system has; use kernel=auto"},
           named("kernel", "spectral")},
          {"free kernel for periodic boundaries",
           incompatible,
           {"kernel \"love\" is not for periodic boundaries, which the system has; use kernel=auto"},
           named("kernel", "love", periodic)},
          {"kernel that is not for semi-periodic boundaries",
           incompatible,
           {"kernel \"galerkin\" is not for semi-periodic boundaries, which the system has; use kernel=auto"},
           named("kernel", "galerkin", [](rc_system& s) { s.boundary = RC_BOUNDARY_PERIODIC_X; })},
          {"semi-periodic cells longer than 10 000 periods",
           RC_ERR_ARGUMENT,
           {"times as long as the period of the grid", "at most 10000 times", "use shorter cells"},
           named("kernel", "love",
                 [](rc_system& s) {
                   s.boundary = RC_BOUNDARY_PERIODIC_X;
                   s.hx = 1e-6 * s.hy / static_cast<double>(s.nx);
                 })},
          {"disc with hx != hy",
           incompatible,
           {"kernel \"disc\" needs square cells, hx = 1 and hy = 2 differ; use love or galerkin"},
           named("kernel", "disc", oblong)},
          {"punch with hx != hy",
           incompatible,
           {"kernel \"punch\" needs square cells, hx = 1 and hy = 2 differ"},
           named("kernel", "punch", oblong)},
          {"eq9 with hx != hy",
           incompatible,
           {"kernel \"eq9\" needs square cells, hx = 1 and hy = 2 differ"},
           named("kernel", "eq9", oblong)},
          {"coefficients of disc with hx != hy",
           incompatible,
           {"rc_kernel_coefficients: kernel \"disc\" needs square cells"},
           [] {
             double out[4];
             return rc_kernel_coefficients("disc", 1, 2, 2, 2, out);
           }},
          {"backend that cannot do the operator",
           incompatible,
           {"backend \"callback\" cannot do free boundaries"},
           named("backend", "callback")},
          {"pair: solver that does not exist",
           RC_ERR_NO_SOLVER,
           {"rc_pair_supported: solver \"x\" not found"},
           [] { return pair("x", "dense", RC_CONTROL_LOAD); }},
          {"pair: control = 3",
           RC_ERR_ARGUMENT,
           {"rc_pair_supported: control = 3 is none of RC_CONTROL_APPROACH (1), RC_CONTROL_LOAD (2), RC_CONTROL_AREA (4), "
            "RC_CONTROL_PRESSURE (8)"},
           [] { return pair("nnls", "callback", 3); }},
          {"pair: a mean pressure", RC_OK, {}, [] { return pair("nnls", "callback", RC_CONTROL_PRESSURE); }},
          {"pair: an area, no factorisation and no fallback",
           incompatible,
           {"backend \"callback\": solver \"nnls\" needs systems on subsets"},
           [] {
             return pair("nnls", "callback", RC_CONTROL_AREA, options_with({{"allow_fallback", "0"}}).get());
           }},
          {"pair: operator and backend",
           incompatible,
           {"backend \"dense\" cannot do the caller's product"},
           [] { return pair("nnls", "dense", RC_CONTROL_LOAD); }},
          {"pair: no factorisation and no fallback",
           incompatible,
           {"backend \"callback\": solver \"nnls\" needs systems on subsets, which the backend cannot factor, and "
            "allow_fallback is 0"},
           [] {
             return pair("nnls", "callback", RC_CONTROL_LOAD, options_with({{"allow_fallback", "0"}}).get());
           }},
          {"component number out of range",
           RC_ERR_ARGUMENT,
           {"rc_component_describe: i = 99: there are 7, numbered from 0"},
           [] { return described(RC_COMPONENT_KERNEL, 99); }},
          {"component of an unknown kind",
           RC_ERR_ARGUMENT,
           {"rc_component_describe: kind = 5 is none of RC_COMPONENT_SOLVER (1), RC_COMPONENT_BACKEND (2), RC_COMPONENT_KERNEL "
            "(3), RC_COMPONENT_OPTION (4)"},
           [] { return described(5, 0); }},
          {"context with unknown flags",
           RC_ERR_ARGUMENT,
           {"rc_context_create: flags = 12 has unknown bits; there are RC_CONTEXT_NO_PLUGINS (1) and RC_CONTEXT_NO_ENVIRONMENT "
            "(2)"},
           [] {
             rc_context* context = nullptr;
             return rc_context_create(12, nullptr, nullptr, nullptr, &context);
           }},
      }};
}

}  // namespace errors

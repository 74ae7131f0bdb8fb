#include "calls.h"

#include <roughcontact/direct.h>
#include <roughcontact/product.h>

#include <algorithm>
#include <cstdio>
#include <cstring>

namespace errors {

namespace {

using LawHandle = std::unique_ptr<rc_law, Destroy<rc_law_destroy>>;
using ProductHandle = std::unique_ptr<rc_product, Destroy<rc_product_destroy>>;

constexpr const char* law_file = "errors.law";

rc_const_array mask(World& w) { return RC_IN(w.memory.mask); }

Outcome solve_open(World& w) {
  const Outcome outcome = solve(w.scene, w.options().get());
  assert_true(std::all_of(answer().p().begin(), answer().p().end(), [](double p) { return p == 0; }));
  assert_true(answer().result()->load == 0);
  return outcome;
}

// Shared by the ranks of an exchange that has one.
Outcome share(World& w) {
  const rc_exchange alone = one_rank();
  rc_contact* contact = nullptr;
  const Outcome outcome = rc_ranks_contact_create(&alone, &w.scene.system, nullptr, &contact);
  rc_contact_destroy(contact);
  return outcome;
}

Outcome change(World& w) {
  const ContactHandle contact = made(w.scene);
  return rc_contact_set_options(contact.get(), w.options().get());
}

Outcome pair(World& w) {
  w.set("callback=diagonal");
  return rc_pair_supported(nullptr, w.memory.solver, w.memory.backend, &w.scene.system, w.scene.step.control, w.options().get());
}

Outcome coefficients(World& w) {
  double out[16];
  const rc_system& s = w.scene.system;
  return rc_kernel_coefficients(w.memory.kernel, s.hx, s.hy, s.nx, s.ny, out);
}

template <class Call> auto with_options(const Call& call) {
  return [call](World& w) { return Outcome(call(options_with({}).get(), w.memory)); };
}

template <class Call> auto after_step(const Call& call) {
  return [call](World& w) {
    const ContactHandle contact = made(w.scene, w.options().get());
    assert_true(solve(contact.get(), w.scene) >= 0);
    answer().prepare();
    return Outcome(call(contact.get(), w.memory));
  };
}

Outcome level(rc_contact* contact, Memory& m) {
  rc_level out = RC_LEVEL_INIT;
  return rc_contact_level(contact, m.i, &out);
}

// A call that is refused changes nothing: the contact still has no surface.
Outcome restore(World& w) {
  const ContactHandle contact = made(w.scene);
  const Outcome outcome = rc_contact_restore(contact.get(), &w.memory.state);
  w.scene.step.undeformed_gap.data = nullptr;
  assert_int_equal(solve(contact.get(), w.scene), RC_ERR_ARGUMENT);
  return outcome;
}

Outcome analysed(const std::string& name, World& w) {
  Memory& m = w.memory;
  const rc_system* const s = &w.scene.system;
  if (name == "rc_area_measure") return rc_area_measure(s, RC_IN(m.p), mask(w), &m.area);
  if (name == "rc_patches_find") return rc_patches_find(s, RC_IN(m.p), mask(w), &m.patches);
  if (name == "rc_crossing_find") return rc_crossing_find(s, RC_IN(m.p), mask(w), &m.contact_crosses, &m.gap_crosses);
  return rc_histogram_fill(s, RC_IN(m.p), mask(w), &m.histogram);
}

// All four functions refuse alike.
Outcome analyses(World& w) {
  const Outcome last = analysed("rc_histogram_fill", w);
  for (const char* name : {"rc_area_measure", "rc_patches_find", "rc_crossing_find"}) {
    const Outcome outcome = analysed(name, w);
    assert_int_equal(outcome.status, last.status);
    if (outcome.status < 0) assert_int_equal(outcome.message.rfind(name + std::string(": "), 0), 0);
  }
  return last;
}

Outcome punch(World& w) {
  double stiffness = untouched;
  const Outcome outcome = rc_punch_stiffness(&w.scene.system, mask(w), nullptr, &stiffness, nullptr, nullptr);
  assert_true(stiffness == (outcome.status == RC_OK ? 0 : untouched));
  return outcome;
}

Outcome conductance(World& w) {
  Memory& m = w.memory;
  return rc_conductance(&w.scene.system, &m.found, m.rho1, m.rho2, m.out, m.out + 1, m.out + 2);
}

// Their sum is beyond double precision.
Outcome conductance_of_large_resistivities(World& w) {
  w.memory.found.stiffness = 3e8;
  double by_half = 0, whole = 0;
  assert_int_equal(rc_conductance(&w.scene.system, &w.memory.found, 4e307, 5e307, &by_half, nullptr, nullptr), RC_OK);
  const Outcome outcome = rc_conductance(&w.scene.system, &w.memory.found, 8e307, 1e308, &whole, nullptr, nullptr);
  assert_true(whole > 0.4999999 * by_half && whole < 0.5000001 * by_half);
  return outcome;
}

// All five routines for a matrix refuse alike.
Outcome direct(World& w) {
  const std::pair<const char*, decltype(&rc_nnls)> routines[] = {{"rc_greedy: ", rc_greedy},
                                                                 {"rc_polonsky_keer: ", rc_polonsky_keer},
                                                                 {"rc_gp: ", rc_gp},
                                                                 {"rc_admm: ", rc_admm},
                                                                 {"rc_nnls: ", rc_nnls}};
  Memory& m = w.memory;
  std::vector<Outcome> outcomes;
  for (const auto& [name, routine] : routines) {
    rc_direct result;
    std::memset(static_cast<void*>(&result), 0x5a, sizeof result);
    result.struct_size = sizeof result;
    const rc_direct before = result;
    outcomes.emplace_back(routine(m.n, m.H, m.ld, m.u, m.p, m.w, m.tol, m.max_iter, &result));
    assert_int_equal(outcomes.back().status, outcomes.front().status);
    assert_int_equal(outcomes.back().message.rfind(name, 0), 0);
    assert_memory_equal(&result, &before, sizeof result);
  }
  return outcomes.back();
}

Outcome cmr(World& w) {
  const rc_system& s = w.scene.system;
  Memory& m = w.memory;
  return rc_cmr(s.nx, s.ny, s.hx, s.hy, s.modulus, m.heights, m.approach, m.levels, m.radius,
                std::strcmp(m.solver, "nnls") != 0 ? m.solver : nullptr, m.p, nullptr);
}

Outcome law_create(World& w) {
  rc_law* law = nullptr;
  const Outcome outcome = rc_law_create(&w.scene.system, nullptr, &w.memory.law_spec, &law);
  assert_int_equal(law != nullptr, outcome.status >= 0);
  rc_law_destroy(law);
  return outcome;
}

const rc_law* usual_law() {
  static const LawHandle law = [] {
    const World w;
    rc_law* made = nullptr;
    assert_int_equal(rc_law_create(&w.scene.system, nullptr, &w.memory.law_spec, &made), RC_OK);
    return LawHandle(made);
  }();
  return law.get();
}

// Loads a file with the text; null: there is no file.
Outcome law_load(World& w) {
  std::remove(law_file);
  if (w.memory.text) {
    std::FILE* const file = std::fopen(law_file, "wb");
    assert_non_null(file);
    std::fputs(w.memory.text, file);
    std::fclose(file);
  }
  rc_law* law = nullptr;
  const Outcome outcome = rc_law_load(law_file, &law);
  assert_null(law);
  std::remove(law_file);
  return outcome;
}

Outcome law_export(World& w) {
  std::remove(law_file);
  const Outcome outcome = rc_law_export(usual_law(), law_file, &w.memory.law_export_spec);
  assert_null(std::fopen(law_file, "rb"));
  return outcome;
}

Outcome product(World& w) {
  rc_product* made = nullptr;
  const Outcome outcome = rc_product_create(&w.scene.system, nullptr, &made);
  assert_null(made);
  return outcome;
}

Outcome product_apply(World& w) {
  rc_product* made = nullptr;
  assert_int_equal(rc_product_create(&w.scene.system, nullptr, &made), RC_OK);
  const ProductHandle product(made);
  return rc_product_apply(made, w.memory.from, w.memory.to);
}

// A struct as a newer header may have it.
template <class Struct> struct Newer {
  Struct head;
  unsigned char tail[64] = {};

  explicit Newer(const Struct& present, unsigned char last = 0) : head(present) {
    head.struct_size = sizeof(Newer);
    tail[63] = last;
  }
};

Outcome newer(World& w, unsigned char in_input, unsigned char in_result) {
  const Newer<rc_system> system(w.scene.system, in_input);
  const Newer<rc_step> step(w.scene.step, in_input);
  Newer<rc_result> result(*answer().result(), in_result);
  const Outcome outcome = rc_solve(&system.head, &step.head, nullptr, &result.head);
  assert_int_equal(result.head.struct_size, sizeof result);
  if (outcome.status == RC_OK) assert_true(result.head.load > 0);
  return outcome;
}

Outcome as_the_macros_begin(World&) {
  const rc_system system = RC_SYSTEM_INIT;
  const rc_step step = RC_STEP_INIT;
  return rc_solve(&system, &step, nullptr, answer().result());
}

}  // namespace

Outcome run_history(rc_contact* contact, World& w) {
  Memory& m = w.memory;
  const Outcome outcome = rc_contact_solve_history(contact, &m.history);
  assert_int_equal(m.history.completed, m.written);
  for (std::int64_t i = 0; i < m.written; ++i) assert_true(m.load[i] != untouched);
  m.history.completed = 99;
  std::fill_n(m.load, m.written, untouched);
  return outcome;
}

// Contact 0 comes to no harm in any row that reaches the contacts.
Outcome run_batch(World& w) {
  Memory& m = w.memory;
  const rc_batch before = m.batch;
  const Outcome outcome = rc_batch_solve(&w.scene.system, nullptr, &m.batch);
  assert_int_equal(m.batch.written, m.written);
  if (m.written > 0) {
    assert_true(m.load[0] != untouched && (m.load[0] > 0 || m.batch.control == RC_CONTROL_LOAD));
    std::fill_n(m.load, 6, untouched);
  }
  m.batch = before;
  return outcome;
}

Calls calls() {
  return {
      {"create", [](World& w) { return create(w.scene, w.options().get()); }},
      {"solve", [](World& w) { return solve(w.scene, w.options().get()); }},
      {"solve_open", solve_open},
      {"shared", share},
      {"certify", [](World& w) { return rc_contact_certify(made(w.scene).get(), &w.scene.step, &w.memory.found); }},
      {"change", change},
      {"pair", pair},
      {"coefficients", coefficients},
      {"gap_from_heights", [](World& w) { return rc_gap_from_heights(w.memory.n, {}, {}, {}); }},
      {"set_number", with_options([](rc_options* o, Memory& m) { return rc_options_set_number(o, m.key, m.number); })},
      {"set_text", with_options([](rc_options* o, Memory& m) { return rc_options_set_text(o, m.key, m.text); })},
      {"long_key",
       with_options([](rc_options* o, Memory&) { return rc_options_set_text(o, std::string(100000, 'x').c_str(), "1"); })},
      {"get_number", with_options([](rc_options* o, Memory& m) { return rc_options_get_number(o, m.key, &m.number); })},
      {"get_text", with_options([](rc_options* o, Memory& m) { return rc_options_get_text(o, m.key, &m.text); })},
      {"describe",
       [](World& w) {
         rc_component component = RC_COMPONENT_INIT;
         return rc_component_describe(nullptr, w.memory.kind, w.memory.i, &component);
       }},
      {"context",
       [](World& w) {
         rc_context* context = nullptr;
         return rc_context_create(static_cast<std::uint32_t>(w.memory.flags), nullptr, nullptr, nullptr, &context);
       }},
      {"history", [](World& w) { return run_history(made(w.scene).get(), w); }},
      {"batch", run_batch},
      {"level", [](World& w) { return level(made(w.scene).get(), w.memory); }},
      {"level_after_step", after_step(level)},
      {"points", [](World& w) { return rc_contact_points(made(w.scene).get(), w.memory.room, {}, {}, &w.memory.n); }},
      {"restore", restore},
      {"creep", [](World& w) { return rc_contact_creep(made(w.scene).get(), w.memory.to, nullptr); }},
      {"gradient", after_step([](rc_contact* c, Memory& m) { return rc_contact_gradient(c, &m.gradient); })},
      {"tangent", after_step([](rc_contact* c, Memory& m) { return rc_contact_tangent(c, &m.tangent); })},
      {"analyses", analyses},
      {"patches", [](World& w) { return analysed("rc_patches_find", w); }},
      {"histogram", [](World& w) { return analysed("rc_histogram_fill", w); }},
      {"punch", punch},
      {"conductance", conductance},
      {"conductance_of_large_resistivities", conductance_of_large_resistivities},
      {"direct", direct},
      {"cmr", cmr},
      {"law_create", law_create},
      {"law_load", law_load},
      {"law_load_folder",
       [](World&) {
         rc_law* law = nullptr;
         return rc_law_load(".", &law);
       }},
      {"law_open",
       [](World& w) {
         const rc_law* law = nullptr;
         return rc_law_open(w.memory.text, nullptr, &law);
       }},
      {"law_save", [](World& w) { return rc_law_save(usual_law(), w.memory.text); }},
      {"file_write", [](World& w) { return rc_file_write(w.memory.text, "text", 4); }},
      {"law_export", law_export},
      {"law_slip",
       [](World& w) {
         const double slip[2] = {w.memory.along, 0};
         return rc_law_slip(usual_law(), &w.memory.slip, w.memory.x, slip, &w.memory.slipped);
       }},
      {"law_node",
       [](World& w) {
         rc_law_point node = RC_LAW_POINT_INIT;
         return rc_law_describe_node(usual_law(), w.memory.i, &node);
       }},
      {"law_evaluate",
       [](World& w) {
         rc_law_point point = RC_LAW_POINT_INIT;
         return rc_law_evaluate(usual_law(), w.memory.x, &point);
       }},
      {"law_pressure", [](World& w) { return rc_law_pressure(usual_law(), w.memory.x, w.memory.out, nullptr, nullptr); }},
      {"law_overclosure", [](World& w) { return rc_law_overclosure(usual_law(), w.memory.x, w.memory.out); }},
      {"law_pressures", [](World& w) { return rc_law_pressures(usual_law(), 2, w.memory.from, {}, w.memory.to, {}); }},
      {"law_gap_conductance",
       [](World& w) { return rc_law_gap_conductance(usual_law(), 0.05, w.memory.rho1, w.memory.rho2, w.memory.out); }},
      {"product", product},
      {"product_apply", product_apply},
      {"newer_empty", [](World& w) { return newer(w, 0, 0); }},
      {"newer_filled", [](World& w) { return newer(w, 1, 1); }},
      {"newer_result_with_content", [](World& w) { return newer(w, 0, 1); }},
      {"as_the_macros_begin", as_the_macros_begin},
  };
}

}  // namespace errors

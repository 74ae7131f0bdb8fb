#include <roughcontact/plugin.h>
#include <roughcontact/product.h>

#include "case.h"
#include "scene.h"

namespace errors {

namespace {

const Scene& scene_of_all() {
  static const Scene scene;
  return scene;
}

// Calls in which a null pointer is allowed.
Outcome harmless_nulls() {
  rc_version(nullptr, nullptr, nullptr, nullptr);
  rc_context_destroy(nullptr);
  rc_options_destroy(nullptr);
  rc_contact_destroy(nullptr);
  rc_contact_destroy(nullptr);
  rc_contact_cancel(nullptr);
  assert_true(rc_backend_count(nullptr) >= 1);
  assert_true(rc_solver_count(nullptr) >= 1);
  assert_true(rc_kernel_count(nullptr) >= 1);
  assert_true(rc_options_count(nullptr) >= 1);
  rc_context* context = nullptr;
  const rc_status status = rc_context_create(nullptr, &context);
  rc_context_destroy(context);
  return status;
}

template <class Call> Outcome with_options(const Call& call) {
  const OptionsHandle options = options_with({});
  return call(options.get());
}

template <class Call> Outcome with_contact(const Call& call) {
  const Scene scene;
  const ContactHandle contact = made(scene);
  return call(contact.get(), scene);
}

}  // namespace

Section null_pointers() {
  const rc_status refused = RC_ERR_ARGUMENT;
  return {
      "Null pointers",
      {
          {"null where the header allows it", RC_OK, {}, harmless_nulls},
          {"`rc_context_create`: out is null",
           refused,
           {"rc_context_create: out is null"},
           [] { return rc_context_create(nullptr, nullptr); }},
          {"`rc_context_register`: plugin is null",
           refused,
           {"rc_context_register: plugin is null"},
           [] { return rc_context_register(nullptr, nullptr); }},
          {"`rc_backend_describe`: out is null",
           refused,
           {"rc_backend_describe: rc_component is null"},
           [] { return rc_backend_describe(nullptr, 0, nullptr); }},
          {"`rc_solver_describe`: out is null",
           refused,
           {"rc_solver_describe: rc_component is null"},
           [] { return rc_solver_describe(nullptr, 0, nullptr); }},
          {"`rc_kernel_describe`: out is null",
           refused,
           {"rc_kernel_describe: rc_component is null"},
           [] { return rc_kernel_describe(nullptr, 0, nullptr); }},
          {"`rc_options_describe`: out is null",
           refused,
           {"rc_options_describe: rc_option_spec is null"},
           [] { return rc_options_describe(nullptr, 0, nullptr); }},
          {"`rc_pair_supported`: solver is null",
           refused,
           {"rc_pair_supported: solver or backend is null"},
           [] { return rc_pair_supported(nullptr, nullptr, "dense", &scene_of_all().system, RC_CONTROL_LOAD, nullptr); }},
          {"`rc_pair_supported`: backend is null",
           refused,
           {"rc_pair_supported: solver or backend is null"},
           [] { return rc_pair_supported(nullptr, "nnls", nullptr, &scene_of_all().system, RC_CONTROL_LOAD, nullptr); }},
          {"`rc_pair_supported`: system is null",
           refused,
           {"rc_pair_supported: rc_system is null"},
           [] { return rc_pair_supported(nullptr, "nnls", "dense", nullptr, RC_CONTROL_LOAD, nullptr); }},
          {"`rc_kernel_coefficients`: kernel is null",
           refused,
           {"rc_kernel_coefficients: kernel or out is null"},
           [] {
             double out[4];
             return rc_kernel_coefficients(nullptr, 1, 1, 2, 2, out);
           }},
          {"`rc_kernel_coefficients`: out is null",
           refused,
           {"rc_kernel_coefficients: kernel or out is null"},
           [] { return rc_kernel_coefficients("love", 1, 1, 2, 2, nullptr); }},
          {"`rc_file_write`: path is null",
           refused,
           {"rc_file_write: path is null"},
           [] { return rc_file_write(nullptr, "", 0); }},
          {"`rc_file_write`: data is null",
           refused,
           {"rc_file_write: data is null"},
           [] { return rc_file_write("errors.txt", nullptr, 1); }},
          {"`rc_options_create`: out is null",
           refused,
           {"rc_options_create: out is null"},
           [] { return rc_options_create(nullptr, nullptr); }},
          {"`rc_options_copy`: options is null",
           refused,
           {"rc_options_copy: options is null"},
           [] {
             rc_options* copy = reinterpret_cast<rc_options*>(&copy);
             const Outcome outcome = rc_options_copy(nullptr, &copy);
             assert_null(copy);
             return outcome;
           }},
          {"`rc_options_copy`: out is null",
           refused,
           {"rc_options_copy: out is null"},
           [] { return with_options([](rc_options* o) { return rc_options_copy(o, nullptr); }); }},
          {"`rc_options_set_int`: options is null",
           refused,
           {"rc_options_set_int: options is null"},
           [] { return rc_options_set_int(nullptr, "threads", 1); }},
          {"`rc_options_set_int`: key is null",
           refused,
           {"rc_options_set_int: key is null"},
           [] { return with_options([](rc_options* o) { return rc_options_set_int(o, nullptr, 1); }); }},
          {"`rc_options_set_real`: options is null",
           refused,
           {"rc_options_set_real: options is null"},
           [] { return rc_options_set_real(nullptr, "tol", 1e-8); }},
          {"`rc_options_set_real`: key is null",
           refused,
           {"rc_options_set_real: key is null"},
           [] { return with_options([](rc_options* o) { return rc_options_set_real(o, nullptr, 1); }); }},
          {"`rc_options_set_text`: options is null",
           refused,
           {"rc_options_set_text: options is null"},
           [] { return rc_options_set_text(nullptr, "solver", "nnls"); }},
          {"`rc_options_set_text`: key is null",
           refused,
           {"rc_options_set_text: key is null"},
           [] { return with_options([](rc_options* o) { return rc_options_set_text(o, nullptr, "nnls"); }); }},
          {"`rc_options_set_text`: value is null",
           refused,
           {"rc_options_set_text: value is null"},
           [] { return with_options([](rc_options* o) { return rc_options_set_text(o, "solver", nullptr); }); }},
          {"`rc_options_parse`: options is null",
           refused,
           {"rc_options_parse: options is null"},
           [] { return rc_options_parse(nullptr, "tol", "1e-8"); }},
          {"`rc_options_parse`: key is null",
           refused,
           {"rc_options_parse: key is null"},
           [] { return with_options([](rc_options* o) { return rc_options_parse(o, nullptr, "1"); }); }},
          {"`rc_options_parse`: text is null",
           refused,
           {"rc_options_parse: text is null"},
           [] { return with_options([](rc_options* o) { return rc_options_parse(o, "tol", nullptr); }); }},
          {"`rc_options_get_int`: options is null",
           refused,
           {"rc_options_get_int: options is null"},
           [] {
             std::int64_t out = 0;
             return rc_options_get_int(nullptr, "threads", &out);
           }},
          {"`rc_options_get_int`: key is null",
           refused,
           {"rc_options_get_int: key is null"},
           [] {
             std::int64_t out = 0;
             return with_options([&](rc_options* o) { return rc_options_get_int(o, nullptr, &out); });
           }},
          {"`rc_options_get_int`: out is null",
           refused,
           {"rc_options_get_int: out is null"},
           [] { return with_options([](rc_options* o) { return rc_options_get_int(o, "threads", nullptr); }); }},
          {"`rc_options_get_real`: options is null",
           refused,
           {"rc_options_get_real: options is null"},
           [] {
             double out = 0;
             return rc_options_get_real(nullptr, "tol", &out);
           }},
          {"`rc_options_get_real`: out is null",
           refused,
           {"rc_options_get_real: out is null"},
           [] { return with_options([](rc_options* o) { return rc_options_get_real(o, "tol", nullptr); }); }},
          {"`rc_options_get_text`: options is null",
           refused,
           {"rc_options_get_text: options is null"},
           [] {
             const char* out = nullptr;
             return rc_options_get_text(nullptr, "solver", &out);
           }},
          {"`rc_options_get_text`: out is null",
           refused,
           {"rc_options_get_text: out is null"},
           [] { return with_options([](rc_options* o) { return rc_options_get_text(o, "solver", nullptr); }); }},
          {"`rc_contact_create`: system is null",
           refused,
           {"rc_contact_create: rc_system is null"},
           [] {
             rc_contact* contact = nullptr;
             return rc_contact_create(nullptr, nullptr, &contact);
           }},
          {"`rc_contact_create`: out is null",
           refused,
           {"rc_contact_create: out is null"},
           [] { return rc_contact_create(&scene_of_all().system, nullptr, nullptr); }},
          {"`rc_product_create`: system is null",
           refused,
           {"rc_product_create: rc_system is null"},
           [] {
             rc_product* product = nullptr;
             return rc_product_create(nullptr, nullptr, &product);
           }},
          {"`rc_product_create`: out is null",
           refused,
           {"rc_product_create: out is null"},
           [] { return rc_product_create(&scene_of_all().system, nullptr, nullptr); }},
          {"`rc_product_apply`: product is null",
           refused,
           {"rc_product_apply: product is null"},
           [] {
             double p = 0, u = 0;
             return rc_product_apply(nullptr, RC_IN(&p), RC_OUT(&u));
           }},
          {"`rc_contact_set_options`: contact is null",
           refused,
           {"rc_contact_set_options: contact is null"},
           [] { return with_options([](rc_options* o) { return rc_contact_set_options(nullptr, o); }); }},
          {"`rc_contact_set_options`: options is null",
           refused,
           {"rc_contact_set_options: options is null"},
           [] { return with_contact([](rc_contact* c, const Scene&) { return rc_contact_set_options(c, nullptr); }); }},
          {"`rc_contact_on_progress`: contact is null",
           refused,
           {"rc_contact_on_progress: contact is null"},
           [] { return rc_contact_on_progress(nullptr, nullptr, nullptr, 1); }},
          {"`rc_contact_solve`: contact is null",
           refused,
           {"rc_contact_solve: contact is null"},
           [] { return solve(nullptr, scene_of_all()); }},
          {"`rc_contact_solve`: step is null",
           refused,
           {"rc_contact_solve: rc_step is null"},
           [] {
             return with_contact([](rc_contact* c, const Scene&) { return rc_contact_solve(c, nullptr, answer().result()); });
           }},
          {"`rc_contact_solve`: result is null",
           refused,
           {"rc_contact_solve: rc_result is null"},
           [] { return with_contact([](rc_contact* c, const Scene& s) { return rc_contact_solve(c, &s.step, nullptr); }); }},
          {"`rc_contact_certify`: contact is null",
           refused,
           {"rc_contact_certify: contact is null"},
           [] { return rc_contact_certify(nullptr, &scene_of_all().step, answer().result()); }},
          {"`rc_contact_certify`: step is null",
           refused,
           {"rc_contact_certify: rc_step is null"},
           [] {
             return with_contact([](rc_contact* c, const Scene&) { return rc_contact_certify(c, nullptr, answer().result()); });
           }},
          {"`rc_contact_certify`: result is null",
           refused,
           {"rc_contact_certify: rc_result is null"},
           [] { return with_contact([](rc_contact* c, const Scene& s) { return rc_contact_certify(c, &s.step, nullptr); }); }},
          {"`rc_contact_certify`: result.p is null",
           refused,
           {"rc_contact_certify: rc_result.p.data is null: the pressures to certify are expected"},
           [] {
             rc_result result = RC_RESULT_INIT;
             return with_contact([&](rc_contact* c, const Scene& s) { return rc_contact_certify(c, &s.step, &result); });
           }},
          {"`rc_contact_accuracy`: contact is null",
           refused,
           {"rc_contact_accuracy: contact is null"},
           [] {
             rc_accuracy accuracy = RC_ACCURACY_INIT;
             return rc_contact_accuracy(nullptr, &accuracy);
           }},
          {"`rc_contact_accuracy`: out is null",
           refused,
           {"rc_contact_accuracy: rc_accuracy is null"},
           [] { return with_contact([](rc_contact* c, const Scene&) { return rc_contact_accuracy(c, nullptr); }); }},
          {"`rc_gap_from_heights`: heights is null",
           refused,
           {"rc_gap_from_heights: heights is null"},
           [] {
             double gap = 0;
             return rc_gap_from_heights(1, {}, {}, RC_OUT(&gap));
           }},
          {"`rc_gap_from_heights`: undeformed_gap is null",
           refused,
           {"rc_gap_from_heights: undeformed_gap is null"},
           [] {
             const double height = 0;
             return rc_gap_from_heights(1, RC_IN(&height), {}, {});
           }},
          {"`rc_gap_from_heights`: n = -1",
           refused,
           {"rc_gap_from_heights: n = -1 must be >= 0"},
           [] { return rc_gap_from_heights(-1, {}, {}, {}); }},
          {"`rc_contact_reset`: contact is null",
           refused,
           {"rc_contact_reset: contact is null"},
           [] { return rc_contact_reset(nullptr); }},
          {"`rc_solve`: system is null",
           refused,
           {"rc_solve: rc_system is null"},
           [] { return rc_solve(nullptr, &scene_of_all().step, nullptr, answer().result()); }},
          {"`rc_solve`: step is null",
           refused,
           {"rc_solve: rc_step is null"},
           [] { return rc_solve(&scene_of_all().system, nullptr, nullptr, answer().result()); }},
          {"`rc_solve`: result is null",
           refused,
           {"rc_solve: rc_result is null"},
           [] {
             const Scene scene;
             return rc_solve(&scene.system, &scene.step, nullptr, nullptr);
           }},
          {"result.p and result.gap are null: not wanted",
           RC_OK,
           {},
           [] {
             const Scene scene;
             answer().result()->p.data = answer().result()->gap.data = nullptr;
             return solve(scene);
           }},
      }};
}

}  // namespace errors

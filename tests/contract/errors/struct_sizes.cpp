#include <roughcontact/direct.h>
#include <roughcontact/history.h>

#include "case.h"
#include "scene.h"

namespace errors {

namespace {

// A struct as a newer header may have it.
template <class Struct> struct Newer {
  Struct head;
  unsigned char tail[64] = {};

  explicit Newer(const Struct& today, unsigned char last = 0) : head(today) {
    head.struct_size = sizeof(Newer);
    tail[63] = last;
  }
};

template <class Struct> std::string unknown() {
  return std::to_string(sizeof(Newer<Struct>)) + ": bytes beyond the " + std::to_string(sizeof(Struct)) + " known";
}

template <class Struct> std::string too_large() {
  return std::to_string(SIZE_MAX) + " is larger than " + std::to_string(sizeof(Struct) + 4096);
}

Outcome system_of_size(std::size_t size) {
  Scene scene;
  scene.system.struct_size = size;
  return create(scene);
}

Outcome step_of_size(std::size_t size) {
  Scene scene;
  scene.step.struct_size = size;
  return solve(scene);
}

// The size is part of what must not be written.
Outcome result_of_size(std::size_t size) {
  const Scene scene;
  rc_result* result = answer().result();
  result->struct_size = size;
  const Outcome outcome = solve(scene);
  assert_int_equal(result->struct_size, size);
  result->struct_size = sizeof *result;
  return outcome;
}

Outcome newer(unsigned char last_byte) {
  const Scene scene;
  const Newer<rc_system> system(scene.system, last_byte);
  const Newer<rc_step> step(scene.step, last_byte);
  Newer<rc_result> result(*answer().result());
  const Outcome outcome = rc_solve(&system.head, &step.head, nullptr, &result.head);
  assert_int_equal(result.head.struct_size, sizeof result);
  if (outcome.status == RC_OK) assert_true(result.head.load > 0);
  return outcome;
}

Outcome newer_result_with_content() {
  const Scene scene;
  Newer<rc_result> result(*answer().result(), 1);
  return rc_solve(&scene.system, &scene.step, nullptr, &result.head);
}

Outcome path_of_size(std::size_t size) {
  const Scene scene;
  const ContactHandle contact = made(scene);
  rc_history path = RC_HISTORY_INIT;
  path.struct_size = size;
  path.completed = 7;
  const Outcome outcome = rc_contact_solve_history(contact.get(), &path);
  assert_int_equal(path.completed, 7);
  return outcome;
}

Outcome batch_of_size(std::size_t size) {
  const Scene scene;
  rc_batch batch = RC_BATCH_INIT;
  batch.struct_size = size;
  batch.written = 7;
  const Outcome outcome = rc_batch_solve(&scene.system, nullptr, &batch);
  assert_int_equal(batch.written, 7);
  return outcome;
}

Outcome level_of_size(std::size_t size) {
  const Scene scene;
  const ContactHandle contact = made(scene);
  rc_level level{};
  level.struct_size = size;
  return rc_contact_level(contact.get(), 0, &level);
}

Outcome config_of_size(std::size_t size) {
  rc_context_config config = RC_CONTEXT_CONFIG_INIT;
  config.struct_size = size;
  rc_context* context = nullptr;
  return rc_context_create(&config, &context);
}

Outcome described_with_size(rc_status (*describe)(rc_context*, std::int64_t, rc_component*), std::size_t size) {
  rc_component component{};
  component.struct_size = size;
  return describe(nullptr, 0, &component);
}

}  // namespace

Section struct_sizes() {
  const rc_status refused = RC_ERR_ARGUMENT;
  return {
      "Sized structs",
      {
          {"rc_system.struct_size = 0",
           refused,
           {"rc_contact_create: rc_system.struct_size = " + too_small<rc_system>(0) + "; set it to sizeof(rc_system)"},
           [] { return system_of_size(0); }},
          {"rc_system.struct_size one byte too small",
           refused,
           {"rc_system.struct_size = " + too_small<rc_system>(sizeof(rc_system) - 1)},
           [] { return system_of_size(sizeof(rc_system) - 1); }},
          {"rc_system.struct_size = SIZE_MAX",
           refused,
           {"rc_system.struct_size = " + too_large<rc_system>()},
           [] { return system_of_size(SIZE_MAX); }},
          {"rc_step.struct_size = 0",
           refused,
           {"rc_solve: rc_step.struct_size = " + too_small<rc_step>(0)},
           [] { return step_of_size(0); }},
          {"rc_step.struct_size one byte too small",
           refused,
           {"rc_step.struct_size = " + too_small<rc_step>(sizeof(rc_step) - 1)},
           [] { return step_of_size(sizeof(rc_step) - 1); }},
          {"rc_step.struct_size = SIZE_MAX",
           refused,
           {"rc_step.struct_size = " + too_large<rc_step>()},
           [] { return step_of_size(SIZE_MAX); }},
          {"rc_result.struct_size = 0",
           refused,
           {"rc_solve: rc_result.struct_size = " + too_small<rc_result>(0)},
           [] { return result_of_size(0); }},
          {"rc_result.struct_size one byte too small",
           refused,
           {"rc_result.struct_size = " + too_small<rc_result>(sizeof(rc_result) - 1)},
           [] { return result_of_size(sizeof(rc_result) - 1); }},
          {"rc_result.struct_size = SIZE_MAX",
           refused,
           {"rc_result.struct_size = " + too_large<rc_result>()},
           [] { return result_of_size(SIZE_MAX); }},
          {"rc_history.struct_size = 0",
           refused,
           {"rc_contact_solve_history: rc_history.struct_size = " + too_small<rc_history>(0) + "; set it to sizeof(rc_history)"},
           [] { return path_of_size(0); }},
          {"rc_history.struct_size = SIZE_MAX",
           refused,
           {"rc_history.struct_size = " + too_large<rc_history>()},
           [] { return path_of_size(SIZE_MAX); }},
          {"rc_batch.struct_size one byte too small",
           refused,
           {"rc_batch_solve: rc_batch.struct_size = " + too_small<rc_batch>(sizeof(rc_batch) - 1) +
            "; set it to sizeof(rc_batch)"},
           [] { return batch_of_size(sizeof(rc_batch) - 1); }},
          {"rc_batch.struct_size = SIZE_MAX",
           refused,
           {"rc_batch.struct_size = " + too_large<rc_batch>()},
           [] { return batch_of_size(SIZE_MAX); }},
          {"rc_level.struct_size = 0",
           refused,
           {"rc_contact_level: rc_level.struct_size = " + too_small<rc_level>(0) + "; set it to sizeof(rc_level)"},
           [] { return level_of_size(0); }},
          {"rc_direct.struct_size = 0",
           refused,
           {"rc_nnls: rc_direct.struct_size = " + too_small<rc_direct>(0) + "; set it to sizeof(rc_direct)"},
           [] {
             const double H = 1, u = 1;
             double pressure = 0;
             rc_direct result{};
             return Outcome(rc_nnls(1, &H, 1, &u, &pressure, nullptr, 1e-8, 100, &result));
           }},
          {"structs of a newer header, the unknown part zero", RC_OK, {}, [] { return newer(0); }},
          {"structs of a newer header, the unknown part set",
           refused,
           {"rc_system.struct_size = " + unknown<rc_system>() + " to this library are set; a newer library is needed"},
           [] { return newer(1); }},
          {"rc_result of a newer header, the unknown part set",
           refused,
           {"rc_result.struct_size = " + unknown<rc_result>()},
           newer_result_with_content},
          {"rc_context_config.struct_size = 0",
           refused,
           {"rc_context_create: rc_context_config.struct_size = " + too_small<rc_context_config>(0)},
           [] { return config_of_size(0); }},
          {"rc_context_config.struct_size = SIZE_MAX",
           refused,
           {"rc_context_config.struct_size = " + too_large<rc_context_config>()},
           [] { return config_of_size(SIZE_MAX); }},
          {"rc_component.struct_size = 0 for a backend",
           refused,
           {"rc_backend_describe: rc_component.struct_size = " + too_small<rc_component>(0)},
           [] { return described_with_size(rc_backend_describe, 0); }},
          {"rc_component.struct_size = 0 for a solver",
           refused,
           {"rc_solver_describe: rc_component.struct_size = " + too_small<rc_component>(0)},
           [] { return described_with_size(rc_solver_describe, 0); }},
          {"rc_component.struct_size = 0 for a kernel",
           refused,
           {"rc_kernel_describe: rc_component.struct_size = " + too_small<rc_component>(0)},
           [] { return described_with_size(rc_kernel_describe, 0); }},
          {"rc_option_spec.struct_size = 0",
           refused,
           {"rc_options_describe: rc_option_spec.struct_size = " + too_small<rc_option_spec>(0)},
           [] {
             rc_option_spec spec{};
             return Outcome(rc_options_describe(nullptr, 0, &spec));
           }},
      }};
}

}  // namespace errors

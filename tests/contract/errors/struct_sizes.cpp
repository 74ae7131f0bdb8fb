#include <roughcontact/direct.h>
#include <roughcontact/history.h>

#include <cstring>

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

// A caller of the first release: what lies behind its struct is not the library's.
Outcome oldest_result() {
  const Scene scene;
  const std::size_t first = first_size(&rc_result::note);
  rc_result result{};
  result.struct_size = first;
  std::memset(reinterpret_cast<unsigned char*>(&result) + first, 0x5a, sizeof result - first);
  const Outcome outcome = rc_solve(&scene.system, &scene.step, nullptr, &result);
  assert_int_equal(result.struct_size, first);
  assert_true(result.load > 0);
  for (std::size_t i = first; i < sizeof result; ++i) assert_int_equal(reinterpret_cast<const unsigned char*>(&result)[i], 0x5a);
  return outcome;
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
  return {"Sized structs",
          {
              {"rc_system.struct_size = 0",
               refused,
               {"rc_contact_create: rc_system.struct_size = " + too_small(0, &rc_system::user) + "; set it to sizeof(rc_system)"},
               [] { return system_of_size(0); }},
              {"rc_system.struct_size one byte too small",
               refused,
               {"rc_system.struct_size = " + too_small(first_size(&rc_system::user) - 1, &rc_system::user)},
               [] { return system_of_size(first_size(&rc_system::user) - 1); }},
              {"rc_system.struct_size = SIZE_MAX",
               refused,
               {"rc_system.struct_size = " + too_large<rc_system>()},
               [] { return system_of_size(SIZE_MAX); }},
              {"rc_step.struct_size = 0",
               refused,
               {"rc_solve: rc_step.struct_size = " + too_small(0, &rc_step::mask)},
               [] { return step_of_size(0); }},
              {"rc_step.struct_size one byte too small",
               refused,
               {"rc_step.struct_size = " + too_small(first_size(&rc_step::mask) - 1, &rc_step::mask)},
               [] { return step_of_size(first_size(&rc_step::mask) - 1); }},
              {"rc_step.struct_size = SIZE_MAX",
               refused,
               {"rc_step.struct_size = " + too_large<rc_step>()},
               [] { return step_of_size(SIZE_MAX); }},
              {"rc_result.struct_size = 0",
               refused,
               {"rc_solve: rc_result.struct_size = " + too_small(0, &rc_result::note)},
               [] { return result_of_size(0); }},
              {"rc_result.struct_size one byte too small",
               refused,
               {"rc_result.struct_size = " + too_small(first_size(&rc_result::note) - 1, &rc_result::note)},
               [] { return result_of_size(first_size(&rc_result::note) - 1); }},
              {"rc_result.struct_size = SIZE_MAX",
               refused,
               {"rc_result.struct_size = " + too_large<rc_result>()},
               [] { return result_of_size(SIZE_MAX); }},
              {"rc_result of the first release", RC_OK, {}, oldest_result},
              {"rc_history.struct_size = 0",
               refused,
               {"rc_contact_solve_history: rc_history.struct_size = " + too_small(0, &rc_history::completed) +
                "; set it to sizeof(rc_history)"},
               [] { return path_of_size(0); }},
              {"rc_history.struct_size = SIZE_MAX",
               refused,
               {"rc_history.struct_size = " + too_large<rc_history>()},
               [] { return path_of_size(SIZE_MAX); }},
              {"rc_batch.struct_size one byte too small",
               refused,
               {"rc_batch_solve: rc_batch.struct_size = " + too_small(first_size(&rc_batch::first) - 1, &rc_batch::first) +
                "; set it to sizeof(rc_batch)"},
               [] { return batch_of_size(first_size(&rc_batch::first) - 1); }},
              {"rc_batch.struct_size = SIZE_MAX",
               refused,
               {"rc_batch.struct_size = " + too_large<rc_batch>()},
               [] { return batch_of_size(SIZE_MAX); }},
              {"rc_level.struct_size = 0",
               refused,
               {"rc_contact_level: rc_level.struct_size = " + too_small(0, &rc_level::contacts) + "; set it to sizeof(rc_level)"},
               [] { return level_of_size(0); }},
              {"rc_direct.struct_size = 0",
               refused,
               {"rc_nnls: rc_direct.struct_size = " + too_small(0, &rc_direct::note) + "; set it to sizeof(rc_direct)"},
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
               {"rc_context_create: rc_context_config.struct_size = " + too_small(0, &rc_context_config::log_user)},
               [] { return config_of_size(0); }},
              {"rc_context_config.struct_size = SIZE_MAX",
               refused,
               {"rc_context_config.struct_size = " + too_large<rc_context_config>()},
               [] { return config_of_size(SIZE_MAX); }},
              {"rc_component.struct_size = 0 for a backend",
               refused,
               {"rc_backend_describe: rc_component.struct_size = " + too_small(0, &rc_component::origin)},
               [] { return described_with_size(rc_backend_describe, 0); }},
              {"rc_component.struct_size = 0 for a solver",
               refused,
               {"rc_solver_describe: rc_component.struct_size = " + too_small(0, &rc_component::origin)},
               [] { return described_with_size(rc_solver_describe, 0); }},
              {"rc_component.struct_size = 0 for a kernel",
               refused,
               {"rc_kernel_describe: rc_component.struct_size = " + too_small(0, &rc_component::origin)},
               [] { return described_with_size(rc_kernel_describe, 0); }},
              {"rc_option_spec.struct_size = 0",
               refused,
               {"rc_options_describe: rc_option_spec.struct_size = " + too_small(0, &rc_option_spec::maximum)},
               [] {
                 rc_option_spec spec{};
                 return Outcome(rc_options_describe(nullptr, 0, &spec));
               }},
          }};
}

}  // namespace errors

#include <cstring>

#include "errors/case.h"
#include "errors/scene.h"

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
               {"rc_contact_create: rc_system.struct_size = 0 is smaller than 88; set it to sizeof(rc_system)"},
               [] { return system_of_size(0); }},
              {"rc_system.struct_size one byte too small",
               refused,
               {"rc_system.struct_size = 87 is smaller than 88"},
               [] { return system_of_size(87); }},
              {"rc_system.struct_size = SIZE_MAX",
               refused,
               {"rc_system.struct_size = 18446744073709551615 is larger than 4184"},
               [] { return system_of_size(SIZE_MAX); }},
              {"rc_step.struct_size = 0",
               refused,
               {"rc_solve: rc_step.struct_size = 0 is smaller than 48"},
               [] { return step_of_size(0); }},
              {"rc_step.struct_size one byte too small",
               refused,
               {"rc_step.struct_size = 47 is smaller than 48"},
               [] { return step_of_size(47); }},
              {"rc_step.struct_size = SIZE_MAX",
               refused,
               {"rc_step.struct_size = 18446744073709551615 is larger than 4144"},
               [] { return step_of_size(SIZE_MAX); }},
              {"rc_result.struct_size = 0",
               refused,
               {"rc_solve: rc_result.struct_size = 0 is smaller than 432"},
               [] { return result_of_size(0); }},
              {"rc_result.struct_size one byte too small",
               refused,
               {"rc_result.struct_size = 431 is smaller than 432"},
               [] { return result_of_size(431); }},
              {"rc_result.struct_size = SIZE_MAX",
               refused,
               {"rc_result.struct_size = 18446744073709551615 is larger than 4528"},
               [] { return result_of_size(SIZE_MAX); }},
              {"structs of a newer header, the unknown part zero", RC_OK, {}, [] { return newer(0); }},
              {"structs of a newer header, the unknown part set",
               refused,
               {"rc_system.struct_size = 152: bytes beyond the 88 known to this library are set; a newer library is needed"},
               [] { return newer(1); }},
              {"rc_result of a newer header, the unknown part set",
               refused,
               {"rc_result.struct_size = 496: bytes beyond the 432 known"},
               newer_result_with_content},
              {"rc_context_config.struct_size = 0",
               refused,
               {"rc_context_create: rc_context_config.struct_size = 0 is smaller than 40"},
               [] { return config_of_size(0); }},
              {"rc_context_config.struct_size = SIZE_MAX",
               refused,
               {"rc_context_config.struct_size = 18446744073709551615"},
               [] { return config_of_size(SIZE_MAX); }},
              {"rc_component.struct_size = 0 for a backend",
               refused,
               {"rc_backend_describe: rc_component.struct_size = 0 is smaller than 40"},
               [] { return described_with_size(rc_backend_describe, 0); }},
              {"rc_component.struct_size = 0 for a solver",
               refused,
               {"rc_solver_describe: rc_component.struct_size = 0 is smaller than 40"},
               [] { return described_with_size(rc_solver_describe, 0); }},
              {"rc_component.struct_size = 0 for a kernel",
               refused,
               {"rc_kernel_describe: rc_component.struct_size = 0 is smaller than 40"},
               [] { return described_with_size(rc_kernel_describe, 0); }},
              {"rc_option_spec.struct_size = 0",
               refused,
               {"rc_options_describe: rc_option_spec.struct_size = 0 is smaller than 64"},
               [] {
                 rc_option_spec spec{};
                 return Outcome(rc_options_describe(nullptr, 0, &spec));
               }},
          }};
}

}  // namespace errors

#include "case.h"
#include "scene.h"

namespace errors {

namespace {

// A struct as a newer header may have it.
template <class Struct> struct Newer {
  Struct head;
  unsigned char tail[64] = {};

  explicit Newer(const Struct& present, unsigned char last = 0) : head(present) {
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

}  // namespace

// Null pointers and sizes of every function: tests/contract/abi/calls.py.
Section null_pointers() {
  const rc_status refused = RC_ERR_ARGUMENT;
  return {"Null pointers",
          {
              {"`rc_contact_certify`: result.p is null",
               refused,
               {"rc_contact_certify: rc_result.p.data is null: the pressures to certify are expected"},
               [] {
                 rc_result result = RC_RESULT_INIT;
                 const Scene scene;
                 const ContactHandle contact = made(scene);
                 return Outcome(rc_contact_certify(contact.get(), &scene.step, &result));
               }},
              {"`rc_gap_from_heights`: n = -1",
               refused,
               {"rc_gap_from_heights: n = -1 must be >= 0"},
               [] { return rc_gap_from_heights(-1, {}, {}, {}); }},
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

Section struct_sizes() {
  const rc_status refused = RC_ERR_ARGUMENT;
  return {"Sized structs",
          {
              {"rc_system.struct_size = 0",
               refused,
               {"rc_contact_create: rc_system.struct_size = " + too_small<rc_system>(0) + "; set it to sizeof(rc_system)"},
               [] { return system_of_size(0); }},
              {"rc_system.struct_size = SIZE_MAX",
               refused,
               {"rc_system.struct_size = " + too_large<rc_system>()},
               [] { return system_of_size(SIZE_MAX); }},
              {"rc_result.struct_size = 0",
               refused,
               {"rc_solve: rc_result.struct_size = " + too_small<rc_result>(0)},
               [] { return result_of_size(0); }},
              {"structs of a newer header, the unknown part zero", RC_OK, {}, [] { return newer(0); }},
              {"structs of a newer header, the unknown part set",
               refused,
               {"rc_system.struct_size = " + unknown<rc_system>() + " to this library are set; a newer library is needed"},
               [] { return newer(1); }},
              {"rc_result of a newer header, the unknown part set",
               refused,
               {"rc_result.struct_size = " + unknown<rc_result>()},
               newer_result_with_content},
          }};
}

}  // namespace errors

// A small valid problem, to be spoiled in one place by each case.
#pragma once

#include <roughcontact/ranks.h>
#include <roughcontact/registry.h>

#include <array>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "support/cmocka.hpp"
#include "support/unit_system.h"

namespace errors {

inline constexpr double untouched = -7;  // what outputs hold before a call
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr std::int64_t side = 4, points = side * side;

template <auto destroy> struct Destroy {
  template <class Object> void operator()(Object* object) const { destroy(object); }
};
using ContactHandle = std::unique_ptr<rc_contact, Destroy<rc_contact_destroy>>;
using OptionsHandle = std::unique_ptr<rc_options, Destroy<rc_options_destroy>>;
using ContextHandle = std::unique_ptr<rc_context, Destroy<rc_context_destroy>>;

// A result whose every byte is known, so that a failed call that writes to it is found out.
class Answer {
 public:
  void prepare();
  bool untouched() const;
  rc_result* result() { return &result_; }
  const std::vector<double>& p() const { return p_; }
  const std::vector<double>& gap() const { return gap_; }

 private:
  rc_result result_{}, before_{};
  std::vector<double> p_, gap_;
};
Answer& answer();

// A tilted plane with gaps 0, 1/8, ... 15/8, pressed by 0.55.
struct Scene {
  rc_system system = support::unit_system();
  rc_step step = RC_STEP_INIT;
  std::vector<double> gap;
  std::vector<double> dense;

  Scene();
};
Scene callback_scene(std::int32_t (*apply)(const double*, double*, std::int64_t, void*), void* user = nullptr);

OptionsHandle options_with(std::initializer_list<std::pair<const char*, const char*>> settings);
rc_status create(const Scene& scene, const rc_options* options = nullptr);  // and destroy; a refused contact must be null
ContactHandle made(const Scene& scene, const rc_options* options = nullptr);
rc_exchange one_rank();  // shares with none
ContactHandle shared(const Scene& scene);
rc_status solve(const Scene& scene, const rc_options* options = nullptr);  // one shot, into answer()
rc_status solve(rc_contact* contact, const Scene& scene);

}  // namespace errors

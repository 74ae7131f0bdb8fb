// A kernel of deflections that decay with distance, which a test may spoil, and a contact with it.
#pragma once

#include <cmath>
#include <limits>

#include "scratch.h"
#include "support/unit_system.h"

namespace plugins {

inline constexpr std::int64_t side = 12;
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();

// Changes of a kernel's values, made on purpose.
struct Spoilt {
  std::int64_t x = -1, y = -1;  // where it says `value`
  double value = 0, factor = 1, lowest = 0, share = 0;
};

inline const Spoilt& of(const rc_kernel_spec* spec) { return *static_cast<const Spoilt*>(spec->kernel->user); }

inline rc_status decay_window(const rc_host*, const rc_kernel_spec* spec, std::int64_t first_x, std::int64_t first_y,
                              std::int64_t mx, std::int64_t my, double* out) {
  for (std::int64_t iy = first_y; iy < first_y + my; ++iy)
    for (std::int64_t ix = first_x; ix < first_x + mx; ++ix)
      *out++ = ix == of(spec).x && iy == of(spec).y
                   ? of(spec).value
                   : of(spec).factor * std::exp(-std::hypot(spec->system->hx * static_cast<double>(ix),
                                                            spec->system->hy * static_cast<double>(iy)));
  return RC_OK;
}

inline rc_status decay_symbol(const rc_host*, const rc_kernel_spec* spec, double* out) {
  for (std::int64_t ky = 0; ky <= spec->system->ny / 2; ++ky)
    for (std::int64_t kx = 0; kx <= spec->system->nx / 2; ++kx)
      *out++ = kx == of(spec).x && ky == of(spec).y ? of(spec).value : 1 / (1.0 + static_cast<double>(kx * kx + ky * ky));
  return RC_OK;
}

inline rc_status decay_bounds(const rc_host*, const rc_kernel_spec* spec, double* lowest, double* galerkin_share) {
  *lowest = of(spec).lowest;
  *galerkin_share = of(spec).share;
  return RC_OK;
}

inline rc_kernel decay(Spoilt& spoilt) {
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

inline rc_status add(const Registry& registry, const rc_kernel& kernel) {
  const rc_kernel* const kernels[] = {&kernel};
  const rc_plugin plugin = {.struct_size = sizeof(rc_plugin),
                            .abi_major = RC_PLUGIN_ABI_MAJOR,
                            .abi_minor = RC_PLUGIN_ABI_MINOR,
                            .name = "decay",
                            .version = "1.0",
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
    for (const auto& [key, value] : settings) assert_int_equal(rc_options_set_text(options_, key, value.c_str()), RC_OK);
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
    step.control = RC_CONTROL_APPROACH;
    step.target = 0.4 * system_.hx;
    step.undeformed_gap.data = gap_.data();
    result.p.data = p.data();
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

inline void assert_near(double value, double wanted, double tolerance) {
  if (!(std::abs(value - wanted) <= tolerance * std::abs(wanted))) fail_msg("%.17g instead of %.17g", value, wanted);
}

// The same coefficients as a matrix of the caller's.
inline double load_of_matrix(double rate) {
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
  step.control = RC_CONTROL_APPROACH;
  step.target = 0.4;
  step.undeformed_gap.data = gap.data();
  rc_result result = RC_RESULT_INIT;
  assert_int_equal(rc_solve(&system, &step, nullptr, &result), RC_OK);
  return result.load;
}

}  // namespace plugins

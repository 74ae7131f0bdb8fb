// A kernel of deflections that decay with distance, exp(-r), of which a test may spoil a value or a promise.
#pragma once

#include <roughcontact/plugin.h>

#include <cmath>

namespace support {

struct Decay {
  std::int64_t x = -1, y = -1;  // where it says `value`
  double value = 0, factor = 1, lowest = 0, share = 0;
};

inline const Decay& decay_of(const rc_kernel_spec* spec) { return *static_cast<const Decay*>(spec->kernel->user); }

inline rc_status decay_window(const rc_host*, const rc_kernel_spec* spec, std::int64_t first_x, std::int64_t first_y,
                              std::int64_t mx, std::int64_t my, double* out) {
  const Decay& decay = decay_of(spec);
  for (std::int64_t iy = first_y; iy < first_y + my; ++iy)
    for (std::int64_t ix = first_x; ix < first_x + mx; ++ix)
      *out++ = ix == decay.x && iy == decay.y ? decay.value
                                              : decay.factor * std::exp(-std::hypot(spec->system->hx * static_cast<double>(ix),
                                                                                    spec->system->hy * static_cast<double>(iy)));
  return RC_OK;
}

inline rc_status decay_symbol(const rc_host*, const rc_kernel_spec* spec, double* out) {
  const Decay& decay = decay_of(spec);
  for (std::int64_t ky = 0; ky <= spec->system->ny / 2; ++ky)
    for (std::int64_t kx = 0; kx <= spec->system->nx / 2; ++kx)
      *out++ = kx == decay.x && ky == decay.y ? decay.value : 1 / (1.0 + static_cast<double>(kx * kx + ky * ky));
  return RC_OK;
}

inline rc_status decay_bounds(const rc_host*, const rc_kernel_spec* spec, double* lowest, double* galerkin_share) {
  *lowest = decay_of(spec).lowest;
  *galerkin_share = decay_of(spec).share;
  return RC_OK;
}

inline rc_kernel decay_kernel(const char* name, Decay& decay) {
  return {.struct_size = sizeof(rc_kernel),
          .name = name,
          .summary = "a test's",
          .license = "BSD-3-Clause",
          .caps = RC_KERNEL_FREE | RC_KERNEL_PERIODIC | RC_KERNEL_POSITIVE,
          .window = decay_window,
          .symbol = decay_symbol,
          .bounds = decay_bounds,
          .user = &decay};
}

}  // namespace support

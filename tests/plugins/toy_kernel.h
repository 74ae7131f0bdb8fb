/* The least a kernel can be: a deflection that decays with distance, exp(-rate r), positive definite in the plane. */
#ifndef TOY_KERNEL_H
#define TOY_KERNEL_H

#include <math.h>
#include <roughcontact/plugin.h>

/* In the caller's units; rc_kernel.user names the option. */
static inline rc_status toy_kernel_rate(const rc_host* host, const rc_kernel_spec* spec, double* rate) {
  return host->option_real(host, spec->options, (const char*)spec->kernel->user, rate);
}

static inline rc_status toy_kernel_window(const rc_host* host, const rc_kernel_spec* spec, int64_t first_x, int64_t first_y,
                                          int64_t mx, int64_t my, double* out) {
  double rate;
  int64_t ix, iy;
  const rc_status status = toy_kernel_rate(host, spec, &rate);
  if (status != RC_OK) return status;
  for (iy = 0; iy < my; ++iy)
    for (ix = 0; ix < mx; ++ix) {
      const double x = spec->system->hx * (double)(first_x + ix), y = spec->system->hy * (double)(first_y + iy);
      *out++ = exp(-rate * spec->length * sqrt(x * x + y * y));
    }
  return RC_OK;
}

/* 1 / (1 + (q / rate)^2), of a membrane on springs. */
static inline rc_status toy_kernel_symbol(const rc_host* host, const rc_kernel_spec* spec, double* out) {
  const rc_system* s = spec->system;
  double rate;
  int64_t kx, ky;
  const rc_status status = toy_kernel_rate(host, spec, &rate);
  if (status != RC_OK) return status;
  for (ky = 0; ky <= s->ny / 2; ++ky)
    for (kx = 0; kx <= s->nx / 2; ++kx) {
      const double x = (double)kx / ((double)s->nx * s->hx), y = (double)ky / ((double)s->ny * s->hy);
      const double q = 2 * 3.14159265358979323846 * sqrt(x * x + y * y) / (rate * spec->length);
      *out++ = 1 / (1 + q * q);
    }
  return RC_OK;
}

#endif

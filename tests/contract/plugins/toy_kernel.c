/* The least a kernel can be, in a plugin file: a deflection that decays with distance, exp(-rate r), positive definite in the
 * plane. */
#include <math.h>
#include <roughcontact/plugin.h>

/* In the caller's units; rc_kernel.user names the option. */
static rc_status toy_kernel_rate(const rc_host* host, const rc_kernel_spec* spec, double* rate) {
  return host->option_real(host, spec->options, (const char*)spec->kernel->user, rate);
}

static rc_status toy_kernel_window(const rc_host* host, const rc_kernel_spec* spec, int64_t first_x, int64_t first_y, int64_t mx,
                                   int64_t my, double* out) {
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
static rc_status toy_kernel_symbol(const rc_host* host, const rc_kernel_spec* spec, double* out) {
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

static const rc_component rate = {.struct_size = sizeof(rc_component),
                                  .name = FIXTURE ".rate",
                                  .summary = "of the decay [1/length]",
                                  .default_value = "1",
                                  .type = RC_TYPE_REAL,
                                  .minimum = 0.001,
                                  .maximum = 1e9};
static const rc_component* const options[] = {&rate};
static const rc_kernel kernel = {.struct_size = sizeof(rc_kernel),
                                 .name = FIXTURE,
                                 .summary = "a test's",
                                 .license = "BSD-3-Clause",
                                 .caps = RC_KERNEL_FREE | RC_KERNEL_PERIODIC | RC_KERNEL_POSITIVE,
                                 .n_options = 1,
                                 .options = options,
                                 .window = toy_kernel_window,
                                 .symbol = toy_kernel_symbol,
                                 .user = (void*)(FIXTURE ".rate")};
static const rc_kernel* const kernels[] = {&kernel};
static const rc_plugin plugin = {.struct_size = sizeof(rc_plugin),
                                 .abi_major = RC_PLUGIN_ABI_MAJOR,
                                 .abi_minor = RC_PLUGIN_ABI_MINOR,
                                 .name = FIXTURE,
                                 .version = "1.0",
                                 .n_kernels = 1,
                                 .kernels = kernels};

RC_PLUGIN_ENTRY(toy_kernel, host, out) {
  (void)host;
  *out = &plugin;
  return RC_OK;
}

/* A kernel in a plugin file. */
#include "toy_kernel.h"

static const rc_option_spec rate = {.struct_size = sizeof(rc_option_spec),
                                    .key = FIXTURE ".rate",
                                    .default_value = "1",
                                    .help = "of the decay [1/length]",
                                    .type = RC_TYPE_REAL,
                                    .minimum = 0.001,
                                    .maximum = 1e9};
static const rc_option_spec* const options[] = {&rate};
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

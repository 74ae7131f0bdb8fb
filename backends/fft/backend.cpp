// Products with H by fast Fourier transforms on the bounding box of the points that may carry pressure.
#include <fftw3.h>
#include <roughcontact/plugin.h>

#include <cstring>
#include <exception>
#include <new>
#include <stdexcept>
#include <system_error>

#include "failure.h"
#include "operator.h"

namespace rc_fft {

namespace {

// No exception leaves the backend. The message of a failed allocation is itself free of allocations.
template <class Action> rc_status guard(const rc_host* host, Action action) {
  const char* const no_memory = "fft: out of memory; use a coarser grid or a smaller domain";
  try {
    action();
    return RC_OK;
  } catch (const Failure& failure) {
    return failure.message.empty() ? failure.code : host->fail(host, failure.code, failure.message.c_str());
  } catch (const std::bad_alloc&) {
    return host->fail(host, RC_ERR_MEMORY, no_memory);
  } catch (const std::length_error&) {
    return host->fail(host, RC_ERR_MEMORY, no_memory);
  } catch (const std::system_error&) {
    return host->fail(host, RC_ERR_MEMORY, "fft: the system refused to start a thread; lower the option threads");
  } catch (...) {
    return host->fail(host, RC_ERR_INTERNAL, "fft: an exception of unknown type");
  }
}

Operator& operator_of(void* self) { return *static_cast<Operator*>(self); }

rc_status create(const rc_host* host, const rc_operator_spec* spec, void** self) {
  return guard(host, [=] {
    std::int64_t threads = 1;
    rc_status status = host->option_int(host, spec->options, "threads", &threads);
    const char* planning = "";
    if (status == RC_OK) status = host->option_text(host, spec->options, "fft.planning", &planning);
    if (status != RC_OK) throw Failure{status, {}};
    *self = new Operator(host, *spec, threads, std::strcmp(planning, "measure") == 0 ? FFTW_MEASURE : FFTW_ESTIMATE);
  });
}

void destroy(void* self) { delete static_cast<Operator*>(self); }

rc_status bind(void* self, const rc_domain* domain) {
  return guard(operator_of(self).host(), [=] { operator_of(self).bind(*domain); });
}

rc_status apply(void* self, const double* x, double* y) {
  return guard(operator_of(self).host(), [=] { operator_of(self).apply(x, y); });
}

rc_status field(void* self, const double* x, double* y) {
  return guard(operator_of(self).host(), [=] { operator_of(self).field(x, y); });
}

std::int64_t modelled(void* self) { return operator_of(self).modelled(); }

const rc_option_spec planning = {
    sizeof(rc_option_spec),
    "fft.planning",
    "estimate",
    "estimate|measure",
    "measure: time FFTW's plans first; products are faster, but the last bits may differ from run to run",
    RC_TYPE_TEXT,
    1,
    0.0,
    0.0};
const rc_option_spec* const options[] = {&planning};
const rc_backend backend = {sizeof(rc_backend),
                            "fft",
                            "fast Fourier transforms (FFTW) on the box of the points that may carry pressure",
                            "GPL-2.0-or-later",
                            RC_CAP_FREE | RC_CAP_PERIODIC | RC_CAP_THREAD_INVARIANT,
                            1,
                            options,
                            create,
                            destroy,
                            bind,
                            apply,
                            field,
                            modelled,
                            nullptr,
                            nullptr,
                            nullptr};
const rc_backend* const backends[] = {&backend};
const rc_plugin plugin = {sizeof(rc_plugin), RC_PLUGIN_ABI_MAJOR, RC_PLUGIN_ABI_MINOR, "fft", "0.1.0", 1, 0, backends, nullptr};

}  // namespace

}  // namespace rc_fft

RC_PLUGIN_ENTRY(fft, , out) {
  *out = &rc_fft::plugin;
  return RC_OK;
}

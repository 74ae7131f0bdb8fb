// The caller's matrix-free product as a backend.
#include <roughcontact/plugin.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <new>
#include <vector>

namespace {

struct Callback {
  const rc_host* host;
  const rc_system* system;
  std::vector<std::int64_t> index;  // empty: every point
  std::vector<double> full_x, full_y;

  std::int64_t points() const { return system->nx * system->ny; }
};

// The message of a failed product is allocation-free: it may be the allocation that failed.
rc_status multiply(const Callback& self, const double* x, double* y) {
  if (self.system->apply(x, y, self.points(), self.system->user) != 0)
    return self.host->fail(self.host, RC_ERR_EXTERNAL, "callback: the caller's apply function reported failure");
  if (!std::all_of(y, y + self.points(), [](double value) { return std::isfinite(value); }))
    return self.host->fail(self.host, RC_ERR_NUMERIC,
                           "callback: the caller's apply function returned a value that is not finite");
  return RC_OK;
}

rc_status create(const rc_host* host, const rc_operator_spec* spec, void** self) {
  *self = new (std::nothrow) Callback{host, spec->system, {}, {}, {}};
  return *self ? RC_OK : host->fail(host, RC_ERR_MEMORY, "callback: out of memory");
}

void destroy(void* self) { delete static_cast<Callback*>(self); }

rc_status bind(void* handle, const rc_domain* domain) {
  auto& self = *static_cast<Callback*>(handle);
  try {
    self.index.assign(domain->index, domain->index ? domain->index + domain->n : domain->index);
    const auto n = static_cast<std::size_t>(domain->index ? self.points() : 0);
    self.full_x.assign(n, 0.0);
    self.full_y.resize(n);
    return RC_OK;
  } catch (const std::bad_alloc&) {
    return self.host->fail(self.host, RC_ERR_MEMORY, "callback: out of memory for two vectors over all points");
  }
}

void scatter(Callback& self, const double* x) {
  for (std::size_t i = 0; i < self.index.size(); ++i) self.full_x[static_cast<std::size_t>(self.index[i])] = x[i];
}

rc_status apply(void* handle, const double* x, double* y) {
  auto& self = *static_cast<Callback*>(handle);
  if (self.index.empty()) return multiply(self, x, y);
  scatter(self, x);
  const rc_status status = multiply(self, self.full_x.data(), self.full_y.data());
  for (std::size_t i = 0; i < self.index.size(); ++i) y[i] = self.full_y[static_cast<std::size_t>(self.index[i])];
  return status;
}

rc_status field(void* handle, const double* x, double* y) {
  auto& self = *static_cast<Callback*>(handle);
  if (self.index.empty()) return multiply(self, x, y);
  scatter(self, x);
  return multiply(self, self.full_x.data(), y);
}

std::int64_t modelled(void* handle) { return static_cast<Callback*>(handle)->points(); }

const rc_backend backend = {sizeof(rc_backend),
                            "callback",
                            "the caller's own product",
                            "BSD-3-Clause",
                            RC_CAP_CALLBACK,
                            0,
                            nullptr,
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
const rc_plugin plugin = {
    sizeof(rc_plugin), RC_PLUGIN_ABI_MAJOR, RC_PLUGIN_ABI_MINOR, "callback", "0.1.0", 1, 0, backends, nullptr};

}  // namespace

RC_PLUGIN_ENTRY(callback, , out) {
  *out = &plugin;
  return RC_OK;
}

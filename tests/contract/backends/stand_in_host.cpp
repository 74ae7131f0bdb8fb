#include "stand_in_host.h"

#include <cstdlib>

#include "kernel/kernel.h"
#include "kernel/kernels.h"
#include "kernel/semi_periodic.h"

namespace contract {

namespace {

thread_local std::string last_message;

}  // namespace

const std::string& StandInHost::message() { return last_message; }

const char* kernel_name(std::int32_t boundary) { return boundary == RC_BOUNDARY_PERIODIC ? "spectral" : "love"; }

rc_status StandInHost::value(const rc_options* options, const char* key, const std::string*& out) {
  const auto& known = *reinterpret_cast<const std::map<std::string, std::string>*>(options);
  const auto found = known.find(key);
  if (found == known.end()) return RC_ERR_OPTION;
  out = &found->second;
  return RC_OK;
}

StandInHost::StandInHost(const rc_backend& backend)
    : rc_host{}, options_{{"threads", "1"}, {"tol", "1e-3"}, {"resumable", "0"}, {"accuracy", "0"}, {"accuracy.of", "load"}} {
  for (std::int64_t i = 0; i < backend.n_options; ++i) options_[backend.options[i]->name] = backend.options[i]->default_value;
  struct_size = sizeof(rc_host);
  abi_major = RC_PLUGIN_ABI_MAJOR;
  abi_minor = RC_PLUGIN_ABI_MINOR;
  fail = [](const rc_host*, rc_status code, const char* text) {
    last_message = text;
    return code;
  };
  log = [](const rc_host*, std::int32_t, const char*) {};
  lock = [](const rc_host* host, const char*) { self(host).lock_.lock(); };
  unlock = [](const rc_host* host, const char*) { self(host).lock_.unlock(); };
  option_int = [](const rc_host*, const rc_options* all, const char* key, std::int64_t* out) {
    const std::string* text = nullptr;
    const rc_status status = value(all, key, text);
    if (status == RC_OK) *out = std::stoll(*text);
    return status;
  };
  option_real = [](const rc_host*, const rc_options* all, const char* key, double* out) {
    const std::string* text = nullptr;
    const rc_status status = value(all, key, text);
    if (status == RC_OK) *out = std::stod(*text);
    return status;
  };
  option_text = [](const rc_host*, const rc_options* all, const char* key, const char** out) {
    const std::string* text = nullptr;
    const rc_status status = value(all, key, text);
    if (status == RC_OK) *out = text->c_str();
    return status;
  };
  coefficients = [](const rc_host* host, const rc_system* system, const char* kernel, std::int64_t mx, std::int64_t my,
                    double* out) {
    if (self(host).answer_ != RC_OK) return self(host).answer_.load();
    const rc::kernel::Kernel& used = *rc::kernel::find(kernel);
    if (system->boundary == RC_BOUNDARY_PERIODIC)
      rc::kernel::periodic_coefficients(used, system->hx, system->hy, system->nx, system->ny, mx, my, out);
    else if (rc::kernel::semi_periodic(system->boundary))
      rc::kernel::semi_periodic_coefficients(used, *system, {0, 0, mx, my}, out);
    else
      rc::kernel::coefficients(used, system->hx, system->hy, mx, my, out);
    return rc_status{RC_OK};
  };
  symbol = [](const rc_host* host, const rc_system* system, const char* kernel, double* out) {
    if (self(host).answer_ != RC_OK) return self(host).answer_.load();
    rc::kernel::symbol(*rc::kernel::find(kernel), system->hx, system->hy, system->nx, system->ny, out);
    return rc_status{RC_OK};
  };
  window = [](const rc_host* host, const rc_system* system, const char* kernel, std::int64_t first_x, std::int64_t first_y,
              std::int64_t mx, std::int64_t my, double* out) {
    if (self(host).answer_ != RC_OK) return self(host).answer_.load();
    const rc::kernel::Kernel& used = *rc::kernel::find(kernel);
    if (rc::kernel::semi_periodic(system->boundary))
      rc::kernel::semi_periodic_coefficients(used, *system, {first_x, first_y, mx, my}, out);
    else
      rc::kernel::window_coefficients(used, system->hx, system->hy, {first_x, first_y, mx, my}, out);
    return rc_status{RC_OK};
  };
  share = [](const rc_host* host, const char*, rc_status (*make)(void*, void**), void (*destroy)(void*), void* argument,
             void** object) { return self(host).objects_.add(make, destroy, argument, object); };
  release = [](const rc_host* host, void* object) { self(host).objects_.remove(object); };
  keep = [](const rc_host* host, std::int32_t, const char*, rc_status (*make)(void*, void**), void (*destroy)(void*),
            void* argument, void** object) { return self(host).objects_.add(make, destroy, argument, object); };
}

}  // namespace contract

// The services behind rc_host.
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>

#include "core/caught.h"
#include "registry/context.h"
#include "registry/options_handle.h"
#include "registry/system_kernel.h"

namespace rc {

namespace {

// Components are C: exceptions stay on this side.
template <class Body> rc_status shielded(const Body& body) {
  return caught([&]() -> rc_status {
    body();
    return RC_OK;
  });
}

// Never destroyed: operators may be destroyed by the program's last static destructors. A lock that exists is found without an
// allocation, so that taking it again cannot fail.
std::mutex& named_lock(std::string_view resource) {
  struct Locks {
    std::mutex guard;
    std::map<std::string, std::mutex, std::less<>> by_name;
  };
  static Locks& locks = *new Locks;
  const std::lock_guard lock(locks.guard);
  const auto it = locks.by_name.find(resource);
  return it != locks.by_name.end() ? it->second : locks.by_name[std::string(resource)];
}

const OptionValue& value(const rc_options* options, const char* key, int type) {
  const OptionSpec& spec = options->context->option(key);
  if (spec.type != type) fail(RC_ERR_OPTION, "option \"", key, "\" is read with the wrong type");
  return options->values.get(spec);
}

const SystemKernel& kernel_of(const rc_host* host, const char* name) {
  const SystemKernel* kernel = static_cast<const Host*>(host)->kernel;
  if (!kernel || kernel->name() != name) fail(RC_ERR_INTERNAL, "kernel \"", name, "\" is not that of the system");
  return *kernel;
}

void divide(double* values, std::int64_t n, double modulus) {
  if (modulus == 1) return;
  for (std::int64_t i = 0; i < n; ++i) values[i] /= modulus;
}

using Make = rc_status (*)(void* argument, void** object);
using Destroy = void (*)(void* object);

struct Maker {
  Make make;
  Destroy destroy;
  void* argument;

  std::shared_ptr<void> operator()() const {
    void* fresh = nullptr;
    clear_message();
    raise_if_failed(make(argument, &fresh), "making a shared object");
    return {fresh, destroy};
  }
};

// Components cannot have the keys of the core, which has no space in its own.
std::shared_ptr<void> found_or_made(const Host& host, std::string_view whose, const char* key, const Maker& maker) {
  return host.context->shared().get<void>(join("component ", key, " ", whose), maker);
}

}  // namespace

Host::Host(const Context& owner, const SystemKernel* of_system, std::string of_key)
    : rc_host{}, context(&owner), kernel(of_system), identity(std::move(of_key)) {
  struct_size = sizeof(rc_host);
  abi_major = RC_PLUGIN_ABI_MAJOR;
  abi_minor = RC_PLUGIN_ABI_MINOR;
  fail = [](const rc_host*, rc_status code, const char* message) {
    set_message(message);
    return code;
  };
  log = [](const rc_host* host, std::int32_t level, const char* message) {
    shielded([&] { static_cast<const Host*>(host)->context->log(level, message); });
  };
  lock = [](const rc_host*, const char* resource) { named_lock(resource).lock(); };
  unlock = [](const rc_host*, const char* resource) { named_lock(resource).unlock(); };
  option_int = [](const rc_host*, const rc_options* options, const char* key, std::int64_t* out) {
    return shielded([&] { *out = std::get<std::int64_t>(value(options, key, RC_TYPE_INT)); });
  };
  option_real = [](const rc_host*, const rc_options* options, const char* key, double* out) {
    return shielded([&] { *out = std::get<double>(value(options, key, RC_TYPE_REAL)); });
  };
  option_text = [](const rc_host*, const rc_options* options, const char* key, const char** out) {
    return shielded([&] { *out = std::get<std::string>(value(options, key, RC_TYPE_TEXT)).c_str(); });
  };
  coefficients = [](const rc_host* host, const rc_system* system, const char* name, std::int64_t mx, std::int64_t my,
                    double* out) {
    return shielded([&] {
      kernel_of(host, name).coefficients(*system, mx, my, out);
      divide(out, mx * my, system->modulus);
    });
  };
  symbol = [](const rc_host* host, const rc_system* system, const char* name, double* out) {
    return shielded([&] {
      kernel_of(host, name).symbol(*system, out);
      divide(out, (system->nx / 2 + 1) * (system->ny / 2 + 1), system->modulus);
    });
  };
  window = [](const rc_host* host, const rc_system* system, const char* name, std::int64_t first_x, std::int64_t first_y,
              std::int64_t mx, std::int64_t my, double* out) {
    return shielded([&] {
      kernel_of(host, name).window(*system, {first_x, first_y, mx, my}, out);
      divide(out, mx * my, system->modulus);
    });
  };
  share = [](const rc_host* host, const char* key, Make make, Destroy destroy, void* argument, void** object) {
    return shielded([&] {
      const Host& own = *static_cast<const Host*>(host);
      std::shared_ptr<void> found = found_or_made(own, own.identity, key, {make, destroy, argument});
      const std::lock_guard guarded(own.holdings->mutex);
      *object = own.holdings->objects.emplace(found.get(), found)->first;
    });
  };
  keep = [](const rc_host* host, std::int32_t per_system, const char* key, Make make, Destroy destroy, void* argument,
            void** object) {
    return shielded([&] {
      const Host& own = *static_cast<const Host*>(host);
      std::shared_ptr<void> found = found_or_made(own, per_system != 0 ? own.identity : "of all", key, {make, destroy, argument});
      const std::lock_guard guarded(own.holdings->mutex);
      *object = own.holdings->kept.insert(std::move(found)).first->get();
    });
  };
  release = [](const rc_host* host, void* object) {
    Host::Holdings& all = *static_cast<const Host*>(host)->holdings;
    std::shared_ptr<void> last;  // destroyed outside the lock
    const std::lock_guard guarded(all.mutex);
    const auto it = all.objects.find(object);
    if (it == all.objects.end()) return;
    last = std::move(it->second);
    all.objects.erase(it);
  };
}

}  // namespace rc

/* roughcontact plugin helpers for C++20: failures as exceptions inside a component, statuses and messages outside of it.
 *
 * Header only, and only over <roughcontact/plugin.h>: a plugin that includes it still links nothing of the library. Nothing
 * here is part of the binary interface.
 *
 *   class MyOperator {
 *    public:
 *     static constexpr roughcontact::Component component{"my", "use a smaller grid"};
 *     MyOperator(const rc_host*, const rc_operator_spec&);   // may throw, as may every function below
 *     const rc_host* host() const;
 *     void bind(const rc_domain&);
 *     void apply(const double* x, double* y);
 *     void field(const double* x, double* y);
 *     std::int64_t modelled() const;
 *     // optional, as in rc_backend:
 *     static void score(const rc_facts&, rc_estimate&);
 *     void apply_float(const float* x, float* y);
 *     void screen(const double* x, rc_screen&);
 *     void subset(std::int64_t na, const std::int64_t* a, const double* b, double* x);
 *     void shifted(double rho, const double* b, double* x);
 *     double norm();
 *     void forget();
 *     void rest();
 *     static void fetch(const rc_host*, const rc_options*, void* to_host, const void* from_device, std::int64_t bytes);
 *     static void store(const rc_host*, const rc_options*, void* to_device, const void* from_host, std::int64_t bytes);
 *   };
 *
 *   constexpr rc_backend my = roughcontact::backend<MyOperator>("a summary", "BSD-3-Clause", RC_CAP_FREE, options);
 *   constexpr const rc_backend* backends[] = {&my};
 *   constexpr rc_plugin plugin = roughcontact::plugin("my", "1.0", backends);
 */
#ifndef ROUGHCONTACT_PLUGIN_HPP
#define ROUGHCONTACT_PLUGIN_HPP

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <locale>
#include <memory>
#include <new>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>

#ifdef __GLIBCXX__
#include <cxxabi.h>
#endif

#include "plugin.h"

namespace roughcontact {

// Whose messages they are.
struct Component {
  const char* name;              // every message begins with it
  const char* on_out_of_memory;  // what the user can do about it
};

// The exception of a component; guard() turns it into a status and a message.
struct Failure {
  rc_status code;
  std::string message;  // empty: the host has set it already
};

// fail(component, RC_ERR_NUMERIC, "pivot ", k, " is ", value); the same text in every locale.
template <class... Parts> [[noreturn]] void fail(const Component& component, rc_status code, const Parts&... parts) {
  std::ostringstream out;
  out.exceptions(std::ios::badbit);  // else the text would end silently where memory ran out
  out.imbue(std::locale::classic());
  out << component.name << ": ";
  (out << ... << parts);
  throw Failure{code, out.str()};
}

// Throws a status of the host's that is not RC_OK; the host has set the message.
inline void check(rc_status status) {
  if (status != RC_OK) throw Failure{status, std::string()};
}

// The exception that unwinds a thread which the host of the library has cancelled or ended inside a function of its own.
#ifdef __GLIBCXX__
using ThreadEnds = abi::__forced_unwind;
#else
struct ThreadEnds {};  // other C++ libraries have none
#endif

// Runs action(); no other exception leaves it. The message of a failed allocation is itself free of allocations.
template <class Action> rc_status guard(const rc_host* host, const Component& component, Action&& action) {
  const auto report = [&](rc_status code, const char* what, const char* advice) {
    char text[512];
    std::snprintf(text, sizeof text, "%s: %s%s", component.name, what, advice);
    return host->fail(host, code, text);
  };
  const auto no_memory = [&] { return report(RC_ERR_MEMORY, "out of memory; ", component.on_out_of_memory); };
  try {
    action();
    return RC_OK;
  } catch (const Failure& failure) {
    return failure.message.empty() ? failure.code : host->fail(host, failure.code, failure.message.c_str());
  } catch (const std::bad_alloc&) {
    return no_memory();
  } catch (const std::length_error&) {  // a container was asked for more than an address space
    return no_memory();
  } catch (const std::exception& exception) {
    return report(RC_ERR_INTERNAL, "unexpected: ", exception.what());
  } catch (const ThreadEnds&) {
    throw;
  } catch (...) {
    return report(RC_ERR_INTERNAL, "an exception of unknown type", "");
  }
}

// The functions that rc_host.share and rc_host.keep call to make and destroy an object.
template <class Object, class Make> struct SharedRequest {
  const rc_host* host;
  const Component& component;
  const Make& make;

  static rc_status make_object(void* argument, void** object) {
    const SharedRequest& asked = *static_cast<const SharedRequest*>(argument);
    return guard(asked.host, asked.component, [&] { *object = asked.make().release(); });
  }
  static void destroy_object(void* old) { delete static_cast<Object*>(old); }
};

// rc_host.share: the object under this key, made by make(), a function that returns a std::unique_ptr, where no contact of the
// context with the same system holds one.
template <class T, class Make>
std::shared_ptr<T> shared(const rc_host* host, const Component& component, const std::string& key, const Make& make) {
  using Object = std::remove_const_t<T>;
  SharedRequest<Object, Make> request{host, component, make};
  void* object = nullptr;
  check(host->share(host, key.c_str(), request.make_object, request.destroy_object, &request, &object));
  return {static_cast<Object*>(object), [host](T* held) { host->release(host, const_cast<Object*>(held)); }};
}

// rc_host.keep: the same, and the contact holds it until it ends. of_system: whether only contacts with the same system share it.
template <class T, class Make>
std::shared_ptr<T> kept(const rc_host* host, const Component& component, bool of_system, const std::string& key,
                        const Make& make) {
  using Object = std::remove_const_t<T>;
  SharedRequest<Object, Make> request{host, component, make};
  void* object = nullptr;
  check(host->keep(host, of_system ? 1 : 0, key.c_str(), request.make_object, request.destroy_object, &request, &object));
  return {static_cast<Object*>(object), [](T*) {}};
}

// Options by key; throw if the host does not know the key.
inline std::int64_t option_int(const rc_host* host, const rc_options* options, const char* key) {
  std::int64_t value = 0;
  check(host->option_int(host, options, key, &value));
  return value;
}
inline double option_real(const rc_host* host, const rc_options* options, const char* key) {
  double value = 0;
  check(host->option_real(host, options, key, &value));
  return value;
}
inline const char* option_text(const rc_host* host, const rc_options* options, const char* key) {
  const char* value = "";
  check(host->option_text(host, options, key, &value));
  return value;
}

// Holds one of the host's named locks.
class HostLock {
 public:
  HostLock(const rc_host* host, const char* resource) : host_(host), resource_(resource) { host_->lock(host_, resource_); }
  ~HostLock() { host_->unlock(host_, resource_); }
  HostLock(const HostLock&) = delete;
  HostLock& operator=(const HostLock&) = delete;

 private:
  const rc_host* host_;
  const char* resource_;
};

// task(item, thread) for 0 <= item < items, by the team if `parallel`. task must not throw.
template <class Task> void for_each(const rc_team& team, std::int64_t items, bool parallel, const Task& task) {
  if (!parallel) {
    for (std::int64_t item = 0; item < items; ++item) task(item, 0);
    return;
  }
  const auto call = [](void* argument, std::int64_t item, std::int64_t thread) {
    (*static_cast<const Task*>(argument))(item, thread);
  };
  team.share(&team, items, call, const_cast<Task*>(&task));
}

// The functions of an rc_backend over a C++ class; those that backend() does not take are not instantiated.
template <class Operator> struct Functions {
  static rc_status create(const rc_host* host, const rc_operator_spec* spec, void** self) {
    return guard(host, Operator::component, [&] { *self = new Operator(host, *spec); });
  }
  static void destroy(void* self) noexcept { delete static_cast<Operator*>(self); }
  static rc_status bind(void* self, const rc_domain* domain) {
    return with(self, [&](Operator& op) { op.bind(*domain); });
  }
  static rc_status apply(void* self, const double* x, double* y) {
    return with(self, [&](Operator& op) { op.apply(x, y); });
  }
  static rc_status field(void* self, const double* x, double* y) {
    return with(self, [&](Operator& op) { op.field(x, y); });
  }
  static std::int64_t modelled(void* self) noexcept { return static_cast<Operator*>(self)->modelled(); }
  static rc_status subset(void* self, std::int64_t na, const std::int64_t* a, const double* b, double* x) {
    return with(self, [&](Operator& op) { op.subset(na, a, b, x); });
  }
  static rc_status shifted(void* self, double rho, const double* b, double* x) {
    return with(self, [&](Operator& op) { op.shifted(rho, b, x); });
  }
  static rc_status norm(void* self, double* out) {
    return with(self, [&](Operator& op) { *out = op.norm(); });
  }
  static rc_status apply_float(void* self, const float* x, float* y) {
    return with(self, [&](Operator& op) { op.apply_float(x, y); });
  }
  static rc_status screen(void* self, const double* x, rc_screen* request) {
    return with(self, [&](Operator& op) { op.screen(x, *request); });
  }
  static rc_status forget(void* self) {
    return with(self, [&](Operator& op) { op.forget(); });
  }
  static void rest(void* self) {
    with(self, [&](Operator& op) { op.rest(); });
  }
  static rc_status fetch(const rc_host* host, const rc_options* options, void* to_host, const void* from_device,
                         std::int64_t bytes) {
    return guard(host, Operator::component, [&] { Operator::fetch(host, options, to_host, from_device, bytes); });
  }
  static rc_status store(const rc_host* host, const rc_options* options, void* to_device, const void* from_host,
                         std::int64_t bytes) {
    return guard(host, Operator::component, [&] { Operator::store(host, options, to_device, from_host, bytes); });
  }
  static rc_status score(const rc_facts* facts, rc_estimate* estimate) {
    return guard(facts->host, Operator::component, [&] { Operator::score(*facts, *estimate); });
  }

 private:
  template <class Action> static rc_status with(void* self, Action&& action) {
    Operator& op = *static_cast<Operator*>(self);
    return guard(op.host(), Operator::component, [&] { action(op); });
  }
};

// Options for the lists of rc_backend, rc_solver and rc_kernel, with the default as text. fixed: cannot change after
// rc_contact_create; those of kernels never can.
constexpr rc_component text_option(const char* key, const char* value, const char* choices, const char* summary,
                                   bool fixed = false) {
  return {sizeof(rc_component), key, summary, nullptr, nullptr, value, choices, RC_TYPE_TEXT, fixed, 0, 0};
}
constexpr rc_component int_option(const char* key, const char* value, double minimum, double maximum, const char* summary,
                                  bool fixed = false) {
  return {sizeof(rc_component), key, summary, nullptr, nullptr, value, nullptr, RC_TYPE_INT, fixed, minimum, maximum};
}
constexpr rc_component real_option(const char* key, const char* value, double minimum, double maximum, const char* summary,
                                   bool fixed = false) {
  return {sizeof(rc_component), key, summary, nullptr, nullptr, value, nullptr, RC_TYPE_REAL, fixed, minimum, maximum};
}

// The table of a class with the functions that the class has, and their bits. caps: RC_CAP_* of systems and products; options: keys
// "<name>.<key>".
template <class Operator>
consteval rc_backend backend(const char* summary, const char* license, std::uint64_t caps,
                             std::span<const rc_component* const> options = {}) {
  using F = Functions<Operator>;
  if (caps & (RC_CAP_FLOAT | RC_CAP_SCREEN | RC_CAP_SUBSET | RC_CAP_SHIFTED | RC_CAP_NORM))
    throw "bits of functions follow from the class";
  rc_backend made{};
  made.struct_size = sizeof made;
  made.name = Operator::component.name;
  made.summary = summary;
  made.license = license;
  made.caps = caps;
  made.n_options = static_cast<std::int64_t>(options.size());
  made.options = options.data();
  made.create = F::create;
  made.destroy = F::destroy;
  made.bind = F::bind;
  made.apply = F::apply;
  made.field = F::field;
  made.modelled = F::modelled;
  if constexpr (requires { &Operator::score; }) made.score = F::score;
  if constexpr (requires { &Operator::forget; }) made.forget = F::forget;
  if constexpr (requires { &Operator::rest; }) made.rest = F::rest;
  if constexpr (requires { &Operator::fetch; }) made.fetch = F::fetch;
  if constexpr (requires { &Operator::store; }) made.store = F::store;
  const auto add = [&](auto& member, auto function, std::uint64_t bit) {
    member = function;
    made.caps |= bit;
  };
  if constexpr (requires { &Operator::apply_float; }) add(made.apply_float, F::apply_float, RC_CAP_FLOAT);
  if constexpr (requires { &Operator::screen; }) add(made.screen, F::screen, RC_CAP_SCREEN);
  if constexpr (requires { &Operator::subset; }) add(made.subset, F::subset, RC_CAP_SUBSET);
  if constexpr (requires { &Operator::shifted; }) add(made.shifted, F::shifted, RC_CAP_SHIFTED);
  if constexpr (requires { &Operator::norm; }) add(made.norm, F::norm, RC_CAP_NORM);
  return made;
}

// The table of a plugin with these backends.
template <std::size_t n>
constexpr rc_plugin plugin(const char* name, const char* version, const rc_backend* const (&backends)[n]) {
  rc_plugin made{};
  made.struct_size = sizeof made;
  made.abi_major = RC_PLUGIN_ABI_MAJOR;
  made.abi_minor = RC_PLUGIN_ABI_MINOR;
  made.name = name;
  made.version = version;
  made.n_backends = n;
  made.backends = backends;
  return made;
}

}  // namespace roughcontact
#endif

// The library's C interface with ownership and exceptions.
#pragma once

#include <roughcontact/plugin.h>
#include <roughcontact/roughcontact.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace bench {

// A call that failed (status < 0).
struct Failure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

rc_status check(rc_status status);

template <class Handle, void (*destroy)(Handle*)> struct Destroy {
  void operator()(Handle* handle) const { destroy(handle); }
};

// Option keys and their values as text.
using Settings = std::vector<std::pair<std::string, std::string>>;

class Context {
 public:
  Context();
  void add(const rc_plugin& plugin) { check(rc_context_register(handle_.get(), &plugin)); }
  rc_context* get() const { return handle_.get(); }

 private:
  std::unique_ptr<rc_context, Destroy<rc_context, rc_context_destroy>> handle_;
};

class Options {
 public:
  // A null context is the default one.
  explicit Options(rc_context* context = nullptr);
  Options& set(const char* key, const std::string& value);
  Options& set(const char* key, double value);
  Options& set(const Settings& settings);
  const rc_options* get() const { return handle_.get(); }

 private:
  std::unique_ptr<rc_options, Destroy<rc_options, rc_options_destroy>> handle_;
};

class Contact {
 public:
  Contact(const rc_system& system, const Options& options);
  void set(const Options& options) { check(rc_contact_set_options(handle_.get(), options.get())); }
  void reset() { check(rc_contact_reset(handle_.get())); }
  // Calls fn at every iteration.
  void watch(rc_progress_fn fn, void* user) { check(rc_contact_on_progress(handle_.get(), fn, user, 1)); }
  // Pressures go to p where it is not null.
  rc_result solve(const rc_step& step, double* p = nullptr);

 private:
  std::unique_ptr<rc_contact, Destroy<rc_contact, rc_contact_destroy>> handle_;
};

std::vector<std::string> solver_names();
std::vector<std::string> backend_names();
std::vector<std::string> kernel_names();

// n x n cells that fill the unit square, free boundaries, contact modulus 1.
rc_system unit_square(std::int64_t n);

}  // namespace bench

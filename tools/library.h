// Ownership and error text for the C interface.
#pragma once

#include <roughcontact/registry.h>

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cli {

template <auto destroy> struct Destroy {
  void operator()(auto* handle) const { destroy(handle); }
};
using Options = std::unique_ptr<rc_options, Destroy<rc_options_destroy>>;
using Contact = std::unique_ptr<rc_contact, Destroy<rc_contact_destroy>>;

// A registry whose log (a plugin that was refused, say) is kept until it is asked for.
class Context {
 public:
  Context();
  rc_context* get() const { return handle_.get(); }

  // Reports what was logged so far, of this level at least, to standard error and forgets the log.
  void report_log(int32_t least = RC_LOG_WARNING);

 private:
  static void log(int32_t level, const char* message, void* user);

  std::vector<std::pair<int32_t, std::string>> log_;
  std::unique_ptr<rc_context, Destroy<rc_context_destroy>> handle_;
};

// The components of a kind, RC_COMPONENT_*, of a registry.
std::vector<rc_component> components(const Context& context, int32_t kind);

// Throws an Error with the library's own text if the call failed; `subject` ("--tol", "step 3") opens the message.
void check(rc_status status, std::string_view subject);

// The defaults of the registry, but for the threads; then these keys and values, of which later ones win.
Options make_options(const Context& context, int threads, const std::vector<std::pair<std::string, std::string>>& settings);

// A library's message without the name of the C function that it begins with, which means nothing on a command line.
std::string_view without_function(std::string_view message);
// The calling thread's last message, without that name.
std::string last_message();

// One for each 16384 points of a grid, at least 1, at most rc_usable_cores; as in Python.
int default_threads(std::int64_t points);

}  // namespace cli

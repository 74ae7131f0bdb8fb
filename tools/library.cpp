#include "library.h"

#include <algorithm>
#include <cstdlib>

#include "formats/error.h"
#include "formats/numbers.h"
#include "platform/terminal.h"
#include "text.h"

namespace cli {

std::string_view without_function(std::string_view message) {
  if (!message.starts_with("rc_")) return message;
  const auto colon = message.find_first_not_of("abcdefghijklmnopqrstuvwxyz_");
  return colon == message.npos || message[colon] != ':' ? message : trimmed(message.substr(colon + 1));
}

Context::Context() {
  rc_context* context = nullptr;
  check(rc_context_create(0, nullptr, log, this, &context), "");
  handle_.reset(context);
}

void Context::report_log(int32_t least) {
  for (const auto& [level, message] : log_)
    if (level >= least) report(message);
  log_.clear();
}

void Context::log(int32_t level, const char* message, void* user) {
  static_cast<Context*>(user)->log_.emplace_back(level, message);
}

void check(rc_status status, std::string_view subject) {
  if (status >= 0) return;
  const std::string message = last_message();
  throw Error(subject, subject.empty() ? "" : ": ", message.empty() ? rc_status_text(status) : message);
}

std::vector<rc_component> components(const Context& context, int32_t kind) {
  std::vector<rc_component> found(static_cast<std::size_t>(rc_component_count(context.get(), kind)), RC_COMPONENT_INIT);
  for (std::size_t i = 0; i < found.size(); ++i)
    check(rc_component_describe(context.get(), kind, static_cast<int64_t>(i), &found[i]), "");
  return found;
}

Options make_options(const Context& context, int threads, const std::vector<std::pair<std::string, std::string>>& settings) {
  rc_options* handle = nullptr;
  check(rc_options_create(context.get(), &handle), "");
  Options options{handle};
  check(rc_options_set_number(handle, RC_OPT_THREADS, threads), "");
  for (const auto& [key, text] : settings) check(rc_options_set_text(handle, key.c_str(), text.c_str()), "");
  return options;
}

std::string last_message() { return std::string(without_function(rc_last_error())); }

int default_threads(std::int64_t points) {
  constexpr std::int64_t points_each = 16384;  // fewer points gain nothing
  return static_cast<int>(std::clamp<std::int64_t>(points / points_each, 1, rc_usable_cores(0)));
}

}  // namespace cli

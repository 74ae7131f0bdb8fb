#include "library.h"

#include "error.h"
#include "text.h"

namespace cli {

Context::Context() {
  rc_context_config config = RC_CONTEXT_CONFIG_INIT;
  config.log = log;
  config.log_user = this;
  rc_context* context = nullptr;
  check(rc_context_create(&config, &context), "");
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
  std::string message = last_message();
  if (message.empty()) message = rc_status_text(status);
  throw Error(subject.empty() ? message : std::string(subject) + ": " + message);
}

Options make_options(const Context& context, int threads, const std::vector<std::pair<std::string, std::string>>& settings) {
  rc_options* handle = nullptr;
  check(rc_options_create(context.get(), &handle), "");
  Options options{handle};
  check(rc_options_set_int(handle, RC_OPT_THREADS, threads), "");
  for (const auto& [key, text] : settings) check(rc_options_parse(handle, key.c_str(), text.c_str()), "");
  return options;
}

std::string last_message() {
  const std::string_view message = rc_last_error();
  if (!message.starts_with("rc_")) return std::string(message);
  const auto colon = message.find_first_not_of("abcdefghijklmnopqrstuvwxyz_");
  if (colon == std::string_view::npos || message[colon] != ':') return std::string(message);
  return std::string(trimmed(message.substr(colon + 1)));
}

}  // namespace cli

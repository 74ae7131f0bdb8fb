#include "surface/library.h"

#include <string_view>

#include "error.h"
#include "text.h"

namespace cli {

void check_surface(rc_status status, const std::string& subject) {
  if (status == RC_OK) return;
  std::string_view message = rc_surface_last_error();
  const auto colon = message.find(": ");
  if (message.starts_with("rc_surface_") && colon != std::string_view::npos) message = message.substr(colon + 2);
  throw Error((subject.empty() ? "" : subject + ": ") + std::string(message));
}

}  // namespace cli

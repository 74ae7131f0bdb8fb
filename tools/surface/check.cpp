#include "surface/check.h"

#include "formats/error.h"
#include "library.h"

namespace cli {

void check_surface(rc_status status, std::string_view subject) {
  if (status != RC_OK) throw Error(subject, subject.empty() ? "" : ": ", without_function(rc_surface_last_error()));
}

}  // namespace cli

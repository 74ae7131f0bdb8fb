// Error text for the C interface of the surface library.
#pragma once

#include <roughcontact/surface.h>

#include <string>

namespace cli {

// Throws an Error if the call failed: `subject`, then the library's own text without the name of the C function.
void check_surface(rc_status status, const std::string& subject = "");

}  // namespace cli

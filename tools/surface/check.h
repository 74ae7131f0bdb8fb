// Statuses of libroughcontact-surface.
#pragma once

#include <roughcontact/surface.h>

#include <string_view>

namespace cli {

// Throws an Error with the library's own text if the call failed; `subject` ("sphere.gsf") opens the message.
void check_surface(rc_status status, std::string_view subject = "");

}  // namespace cli

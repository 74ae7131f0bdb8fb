// The formats that can be read, one line each.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "formats/surface.h"

namespace rc::formats {

struct Format {
  std::string_view name;  // of --format
  std::string_view summary;
  std::string_view extensions;             // separated by spaces
  bool (*matches)(std::string_view file);  // whether the contents are of this format; null if they cannot show it
  std::string_view lengths;                // what the file says of its lengths
  Surface (*read)(std::string_view file, const BareUnit& unit);
};

std::span<const Format> surface_formats();

// The format of that name. Throws an Error that lists the names, and suggests the nearest, if there is none.
const Format& named_format(std::string_view name);

// The format by contents, or else by extension (".gsf", lower case). Throws an Error that lists the formats if neither is known.
const Format& recognised_format(std::string_view file, std::string_view extension);

// For a program whose only use of libhdf5 is these readers: libhdf5 prints nothing more, not even when the program ends, as it
// does after some damaged files.
void silence_hdf5();

}  // namespace rc::formats

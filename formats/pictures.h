// Pictures of one grey channel, as readers of picture files hand them over.
#pragma once

#include <cstdint>
#include <string_view>

#include "formats/readers.h"

namespace rc::formats {

enum class Samples { whole, real };

// The header of a picture; throws unless it is a map of heights. bits: of a sample.
void check_picture(std::int64_t nx, std::int64_t ny, int channels, int bits, Samples samples);

// The surface of rows in the machine's byte order. Whole numbers stay as they are, for the height range to scale; real ones are
// heights in `unit`.
Surface surface_of_picture(std::int64_t nx, std::int64_t ny, int bits, Samples samples, std::string_view rows,
                           const BareUnit& unit);

}  // namespace rc::formats

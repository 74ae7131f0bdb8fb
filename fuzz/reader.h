// Checks that must hold for every reader and any bytes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "formats/surface.h"

namespace fuzz {

using Reader = rc::formats::Surface (*)(std::string_view file, const rc::formats::BareUnit& unit);

/** Reads the bytes. A reader ends in a surface whose sizes, pitch and memory agree with each other, or in a rc::formats::Error of
 * one line; anything else ends the process. A surface's form is removed and its missing points are filled, which keeps it in
 * order. Returns the surface as read; nothing after an Error. */
std::optional<rc::formats::Surface> check_reader(Reader read, std::string_view file);

inline std::string_view text(const std::uint8_t* data, std::size_t size) { return {reinterpret_cast<const char*>(data), size}; }

}  // namespace fuzz

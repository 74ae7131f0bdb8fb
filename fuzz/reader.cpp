#include "reader.h"

#include <cmath>

#include "formats/error.h"
#include "formats/form.h"
#include "formats/missing.h"
#include "formats/readers.h"
#include "require.h"

namespace fuzz {

namespace {

constexpr std::size_t most_processed = 1 << 12;  // heights of which forms are removed and holes filled

void require_in_order(const rc::formats::Surface& surface, std::size_t file_size) {
  require(surface.nx >= 1 && surface.ny >= 1, "a surface has points");
  const auto points = static_cast<std::uint64_t>(surface.nx) * static_cast<std::uint64_t>(surface.ny);
  require(points == surface.heights.size(), "nx times ny heights");
  require(points <= rc::formats::most_unpacked(file_size), "the file's size justifies the memory");
  for (const auto& pitch : {surface.hx, surface.hy})
    require(!pitch || (*pitch > 0 && std::isfinite(*pitch)), "a pitch is positive and finite");
}

void require_one_line(const std::string& message) {
  require(!message.empty() && message.find_first_of(std::string_view("\n\r\0", 3)) == std::string::npos, "an error is one line");
}

// The steps of the command after it has read a file.
void process(rc::formats::Surface surface) {
  double highest = 0;
  for (double& z : surface.heights) {
    if (!std::isfinite(z)) z = rc::formats::missing_height;
    if (std::abs(z) > highest) highest = std::abs(z);
  }
  const auto missing = rc::formats::count_missing(surface);
  const std::size_t size = surface.heights.size();
  constexpr rc::formats::Form forms[] = {rc::formats::Form::mean, rc::formats::Form::plane, rc::formats::Form::quadric};
  rc::formats::remove_form(forms[(surface.nx + surface.ny) % 3], surface);
  require(surface.heights.size() == size, "removing a form keeps the grid");
  if (missing == 0 || missing == static_cast<std::int64_t>(size)) return;
  surface.hx = surface.hx.value_or(1);
  surface.hy = surface.hy.value_or(1);
  try {
    rc::formats::fill_missing(surface);
  } catch (const rc::formats::Error& error) {
    require_one_line(error.what());
    return;
  }
  // Sums over the grid need some room below the largest double.
  if (highest < 1e150) require(rc::formats::count_missing(surface) == 0, "no point is missing after filling");
}

}  // namespace

std::optional<rc::formats::Surface> check_reader(Reader read, std::string_view file) {
  try {
    rc::formats::Surface surface = read(file, {"um", 1e-6, true});
    require_in_order(surface, file.size());
    if (surface.heights.size() <= most_processed) process(surface);
    return surface;
  } catch (const rc::formats::Error& error) {
    require_one_line(error.what());
    return std::nullopt;
  }
}

}  // namespace fuzz

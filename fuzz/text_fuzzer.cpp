// Matrices of text and lists of points.
#include "formats/readers.h"
#include "reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view file = fuzz::text(data, size);
  if (const auto matrix = fuzz::check_reader(rc::formats::read_text, file)) rc::formats::kind_of_columns(matrix->heights);
  fuzz::check_reader(rc::formats::read_text_or_points, file);
  fuzz::check_reader(rc::formats::read_xyz, file);
  return 0;
}

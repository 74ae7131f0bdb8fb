// PNG of one grey channel.
#include "formats/readers.h"
#include "reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::check_reader(rc::formats::read_png, fuzz::text(data, size));
  return 0;
}

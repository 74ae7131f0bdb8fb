// Surface data files (ISO 25178-71, BCR, NPL) and, where the first bytes are of none of these, Sensofar's PLu.
#include "formats/readers.h"
#include "reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view file = fuzz::text(data, size);
  const bool sdf = file.starts_with("aISO") || file.starts_with("aBCR") || file.starts_with("aNPL") || file.starts_with("bISO") ||
                   file.starts_with("bBCR");
  fuzz::check_reader(sdf ? rc::formats::read_sdf : rc::formats::read_plu, file);
  return 0;
}

#include "files/gsf_writer.h"

#include <bit>
#include <cstdint>
#include <string>

#include "formats/readers.h"
#include "text.h"

namespace cli {

void write_gsf(std::FILE* file, const Surface& surface) {
  std::string header{gsf_magic};
  header += format("XRes = %lld\nYRes = %lld\n", static_cast<long long>(surface.nx), static_cast<long long>(surface.ny));
  header += format("XReal = %.17g\nYReal = %.17g\nXYUnits = m\nZUnits = m\n", *surface.hx * static_cast<double>(surface.nx),
                   *surface.hy * static_cast<double>(surface.ny));
  if (surface.periodic) header += format("Periodic = %d\n", *surface.periodic ? 1 : 0);
  header.append(4 - header.size() % 4, '\0');
  std::fwrite(header.data(), 1, header.size(), file);
  for (const double z : surface.heights) {
    const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(z));
    unsigned char bytes[4];
    for (unsigned k = 0; k < 4; ++k) bytes[k] = static_cast<unsigned char>(bits >> (8 * k));
    std::fwrite(bytes, 1, sizeof bytes, file);
  }
}

}  // namespace cli

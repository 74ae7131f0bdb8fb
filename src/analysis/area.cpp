// The grid overrates the area, because cells that the border of the contact crosses count as a whole. A random line cuts a cell
// in two; the smaller part has a mean area of (pi - 1 + ln 2) / (6 pi) cells. A border as long as a cell has 4 / pi edges of
// cells on average. Yastrebov, Anciaux & Molinari, Tribology International 114 (2017) 161.
#include "analysis/area.h"

#include <numbers>

namespace rc {

namespace {
constexpr double cells_per_edge = (std::numbers::pi - 1 + std::numbers::ln2) / 24;
}

rc_area measure_area(const ContactMap& map) {
  const rc_system& system = map.system();
  rc_area found{};
  found.struct_size = sizeof found;
  Edges edges;
  for (std::int64_t iy = 0; iy < system.ny; ++iy)
    for (std::int64_t ix = 0; ix < system.nx; ++ix)
      if (map.touches(iy * system.nx + ix)) {
        ++found.contacts;
        edges += map.edges(ix, iy);
      }
  found.area = static_cast<double>(found.contacts) * map.cell_area();
  found.perimeter = edges.length(system);
  found.corrected_area =
      (static_cast<double>(found.contacts) - cells_per_edge * static_cast<double>(edges.front)) * map.cell_area();
  return found;
}

}  // namespace rc

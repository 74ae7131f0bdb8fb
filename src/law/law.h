// A contact law: what is said of it, its nodes, and the table that is evaluated.
#pragma once

#include <roughcontact/law.h>

#include <cstddef>
#include <vector>

#include "law/interval.h"

namespace rc {

inline constexpr const char* no_conductance =
    "no conductance follows from the slope of this law, whose system is not a homogeneous half-space: a layer, or the caller's "
    "own "
    "matrix, product or kernel";

struct Law {
  rc_law_info info = RC_LAW_INFO_INIT;
  double tolerance = 0, tolerance_conductance = 0;  // as asked for
  std::vector<rc_law_node> nodes;
  std::vector<double> table;  // see table.h

  // Fills the table from the nodes, and what follows from both: energies that are not known (NaN), widths, ranges and bounds.
  void finish();
  LawInterval curve_of(std::size_t i) const;  // from node i to the next
  double bulk_yield() const { return info.bulk_stiffness > 0 ? info.area / info.bulk_stiffness : 0; }
};

// Where the bounds of p between two neighbouring nodes are widest, as a share of the interval, and half their width over p there.
// bulk_yield: by how much the bulk makes the approach larger than the overclosure, over the nominal pressure.
struct LawWidth {
  double at, half;
};
LawWidth widest(const rc_law_node& node, const rc_law_node& next, double bulk_yield);

}  // namespace rc

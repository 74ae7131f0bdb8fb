// A contact law: its facts, its nodes, and the table that is evaluated.
#pragma once

#include <roughcontact/law.h>

#include <cstddef>
#include <string>
#include <vector>

#include "law/interval.h"
#include "law/table.h"

namespace rc {

inline constexpr const char* no_conductance =
    "no conductance follows from the slope of this law, whose system is not a homogeneous half-space: "
    "a layer, or the caller's own matrix, product or kernel";

struct Law {
  rc_law_info info = RC_LAW_INFO_INIT;
  double tolerance = 0, tolerance_conductance = 0;  // as asked for
  std::vector<rc_law_point> nodes;
  std::vector<double> table;  // see table.h
  rc_status status = RC_OK;   // that rc_law_create returned
  std::string remark;         // why it is not RC_OK

  // Fills the table from the nodes, and what follows from both: energies that are not known (NaN), widths, ranges and bounds.
  // With RC_OK, the status follows from width, tolerance and kind of the bounds; without a remark, it gets the usual one.
  void finish();
  LawInterval curve_of(std::size_t i) const;                                  // from node i to the next
  double conductance() const { return law_head(table.data())->conductance; }  // see table.h
  double bulk_yield() const { return info.bulk_stiffness > 0 ? info.area / info.bulk_stiffness : 0; }
};

// Where the bounds of p between two neighbouring nodes are widest, as a share of the interval, and half their width over p there.
// bulk_yield: by how much the bulk makes the approach larger than the overclosure, over the nominal pressure.
struct LawWidth {
  double at, half;
};
LawWidth widest(const rc_law_point& node, const rc_law_point& next, double bulk_yield);

// Widens the slopes' interval of `node` as little as it takes for a chord between the pressures of both nodes to be inside all
// bounds. The intervals of loads and stiffnesses at the nodes, and round-off, can contradict a chord by as little as they are
// wide.
void admit_chord(rc_law_point& node, const rc_law_point& next);

}  // namespace rc

// The handle that callers hold.
struct rc_law : rc::Law {};

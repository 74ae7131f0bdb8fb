// A contact law: what is said of it, its nodes, and the table that is evaluated.
#pragma once

#include <roughcontact/law.h>

#include <vector>

namespace rc {

struct Law {
  rc_law_info info = RC_LAW_INFO_INIT;
  double tolerance = 0, tolerance_conductance = 0;  // as asked for
  std::vector<rc_law_node> nodes;
  std::vector<double> table;  // see table.h

  // Fills the table from the nodes, and what follows from both: energies that are not known (NaN), widths, ranges and bounds.
  void finish();
};

// The largest half-width of the bounds of p over p between two neighbouring nodes.
double half_width(const rc_law_node& node, const rc_law_node& next);

}  // namespace rc

// A contact law with additional facts of the command, and its values in SI units.
#pragma once

#include <roughcontact/law.h>

#include <memory>
#include <string>
#include <vector>

#include "library.h"

namespace cli {

// SI units per unit of a law or of a deck.
struct LawUnits {
  double length = 1, force = 1;  // [m], [N]

  double pressure() const { return force / length / length; }
};

struct LawRow {
  rc_law_point at;
  bool beyond;  // the last node

  // Half the distance of the bounds of p, over p; infinite if nothing is proven.
  double half_width() const;
};

struct PatchLaw {
  std::unique_ptr<rc_law, Destroy<rc_law_destroy>> handle;
  rc_law_info info = RC_LAW_INFO_INIT;  // in the law's units
  LawUnits units{};
  std::string source{};          // the name of its file, and how the surface was prepared
  std::string assumed{};         // of its surface, as SurfaceInput has it
  rc_status status = RC_OK;      // of making it
  std::string remark{};          // why the status is not RC_OK
  double asked_conductance = 0;  // tolerance; 0: none was asked for

  // In SI units, at an overclosure or at a pressure in SI units.
  LawRow row(double x) const;
  LawRow row_at_pressure(double p) const;
  std::vector<rc_law_point> nodes() const;

  // Equal ratios of pressure over the range of the law.
  std::vector<LawRow> rows(int count) const;
};

}  // namespace cli

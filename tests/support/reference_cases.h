// The reference cases of tests/data/cases with trusted solutions; forces per element become pressures here.
#pragma once

#include <string>
#include <vector>

#include "support/contact.h"

namespace pairs {

struct ReferenceCase {
  std::string name;
  Problem problem;  // approach control; spacing 2 is a grid of elements with masked ones between
  Field p;          // pressures, 0 on masked points
  double load = 0;  // force
  std::int64_t contacts = 0, candidates = 0;
  bool count_is_robust = false;                     // the margins are far above the tolerance
  double depth = 0;                                 // largest penetration
  std::int64_t rows = 0, columns = 0, spacing = 1;  // as the case is stored
};

struct LoadEntry {
  std::string name, inputs;
  double load = 0, approach = 0;  // the approach of heights whose lowest gap is 0
  std::int64_t contacts = 0;
};

struct ReferenceCases {
  std::vector<ReferenceCase> cases;
  std::vector<LoadEntry> load_control;
};

ReferenceCases read_reference_cases();

/** The values at the points of the stored case, row by row. */
Field stored_points(const ReferenceCase& reference, const Field& values);

/** The doubles of a .npy file, row by row. */
Field read_npy(const std::string& file, std::size_t expected);

}  // namespace pairs

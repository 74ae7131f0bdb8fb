// Rough patches and their laws.
#pragma once

#include <roughcontact/law.h>

#include <memory>
#include <string>
#include <vector>

#include "support/contact.h"

namespace laws {

struct DestroyLaw {
  void operator()(rc_law* law) const { rc_law_destroy(law); }
};
using LawHandle = std::unique_ptr<rc_law, DestroyLaw>;

struct Patch {
  std::string name;
  pairs::Problem problem;  // system, kernel, gap, mask
  rc_law_spec spec = RC_LAW_SPEC_INIT;

  // The law's spec on the arrays of this patch.
  rc_law_spec asked() const;
};

// A patch of 16 by 16 cells: "disc", free, with a mask; "hardness", periodic; "mean gap", free, with a hardness.
Patch patch_named(const std::string& name);
// A periodic patch of n by n cells, within a factor of 500 in pressure.
Patch usual_patch(std::int64_t n);

struct MadeLaw {
  rc_status status = RC_ERR_INTERNAL;
  std::string message;
  LawHandle law;
};
MadeLaw make(const Patch& patch);
LawHandle made(const Patch& patch);  // fails unless the status is >= 0

rc_law_info describe(const rc_law* law);
rc_law_point evaluate(const rc_law* law, double x);

std::string content(const std::string& path);                                      // of a file
const rc_law* usual_law();                                                         // of usual_patch(32)
void refuses(rc_status status, const std::string& part, const std::string& what);  // ARGUMENT, and the message has the part
std::vector<double> overclosures(const rc_law* law);                               // of all magnitudes of a law, and beyond it

}  // namespace laws

// Rough patches, their laws, and what cold certified solves say of them.
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

// Free and periodic, every kernel, masks, grids that are not square, a hardness, nearly full contact.
std::vector<Patch> patches(std::int64_t n);
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

const rc_law* usual_law();                                                         // of usual_patch(32)
void refuses(rc_status status, const std::string& part, const std::string& what);  // ARGUMENT, and the message has the part
std::vector<double> overclosures(const rc_law* law);                               // of all magnitudes of a law, and beyond it

// The result of a separate solve at a nominal pressure, from the surface as it was, to tol 1e-11.
struct Truth {
  double x, p, slope, energy, area;
};
class Referee {
 public:
  explicit Referee(const Patch& patch, const rc_law_info& info);
  Truth at(double p);

 private:
  double mean_rate(const rc_result& result);

  const Patch& patch_;
  rc_law_info info_;
  pairs::Contact contact_;
  pairs::Field gap_, weights_;
};

}  // namespace laws

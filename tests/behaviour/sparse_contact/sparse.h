// Steps without arrays over all points.
#pragma once

#include "support/contact.h"

namespace sparse_contact {

using pairs::Field;
using pairs::Problem;
using pairs::Settings;

struct Sparse {
  rc_status status = RC_ERR_INTERNAL;
  rc_result result = {};
  std::vector<std::int64_t> index;
  Field p;
  std::string message;

  Field everywhere() const;
};

/** A contact that solves without asking for pressures or gap, and is then asked for its contact points. */
class SparseContact {
 public:
  explicit SparseContact(const Problem& problem, const Settings& settings = {}, const pairs::Pair& pair = pairs::automatic);
  Sparse solve(const Problem& problem, bool borrow = false) const;
  rc_contact* handle() const { return contact_.get(); }

 private:
  std::unique_ptr<rc_contact, pairs::DestroyContact> contact_;
};

/** One step; fails unless certified, and unless this backend did it. */
Sparse solved(const Problem& problem, const char* backend, const Settings& settings = {});

/** Waves of amplitudes k^-1.8 from `first` to n/4 a side, pressed in by `depth` standard deviations below the highest point. */
Problem self_affine(std::int64_t nx, std::int64_t ny, unsigned seed, double depth, std::int64_t first = 8);

}  // namespace sparse_contact

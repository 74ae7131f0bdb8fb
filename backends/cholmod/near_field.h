// A factored preconditioner: H on a set of points, tapered to a sparse positive definite matrix of O(n radius^2) entries.
#pragma once

#include <roughcontact/plugin.h>

#include <cstdint>
#include <optional>
#include <span>

#include "common/influence.h"
#include "common/memory_limit.h"
#include "session.h"

namespace rc_cholmod {

class NearField {
 public:
  // Tapers H[points, points] to points up to `radius` cells apart, and adds `shift` times the identity.
  NearField(Session&, const rc_common::MemoryLimit&, const rc_operator_spec&, const rc_common::Influence&,
            std::span<const rc_common::Point> points, double radius, double shift);

  // r = M^-1 r
  void solve(double* r) { session_.solve(*L_, r); }

 private:
  Session& session_;
  Session::Factor L_{nullptr, {nullptr}};
};

}  // namespace rc_cholmod

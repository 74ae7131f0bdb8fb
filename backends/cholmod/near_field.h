// A preconditioner: H on a set of points, tapered to a sparse positive definite matrix of O(n radius^2) entries.
#pragma once

#include <roughcontact/plugin.h>

#include <span>

#include "common/influence.h"
#include "common/memory_limit.h"
#include "session.h"

namespace rc_cholmod {

// The factor of H[points, points] tapered to points up to `radius` cells apart, plus `shift` times the identity.
Session::Factor near_field(Session&, const rc_common::MemoryLimit&, const rc_operator_spec&, const rc_common::Influence&,
                           std::span<const rc_common::Point> points, double radius, double shift);

}  // namespace rc_cholmod

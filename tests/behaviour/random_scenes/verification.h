// Certified answers checked by other means than the solving contact's.
#pragma once

#include <optional>

#include "scene.h"
#include "support/contact.h"

namespace scenes {

/** For one system and kernel. Small grids: sums over pairs of points. Others: another contact, with stored coefficients or with
 *  transforms on the points that carry pressure. */
class Verification {
 public:
  explicit Verification(const Scene& scene);

  /** Throws pairs::Failure with what is wrong. `problem`: with the gap, mask, control and target of this step. */
  void check(const pairs::Problem& problem, const pairs::Answer& answer);

 private:
  Field gap_of(const pairs::Problem& problem, const pairs::Answer& answer);

  double tol_;
  pairs::Settings settings_;
  std::optional<Field> matrix_;
  std::optional<pairs::Contact> other_;
};

}  // namespace scenes

// Checks whether an answer of the library is right, without the library.
#pragma once

#include "influence.h"
#include "scene.h"

namespace fuzz {

/** A step as the contact sees it: with the gap and mask of the step before where it brings none. */
struct Problem {
  const double* gap;
  const std::uint8_t* mask;  // or null
  std::int32_t control;
  double target;
};

/** The caller's arrays, filled with a pattern that a failed call must leave. */
class Answer {
 public:
  explicit Answer(std::size_t points);
  Answer(const Answer&) = delete;
  Answer& operator=(const Answer&) = delete;
  bool untouched() const;
  /** What the call returned, at once: the next one forgets its message. */
  void took(rc_status returned);

  rc_status status = RC_ERR_INTERNAL;
  bool explained = false;
  bool given = false;     // the pressures are the caller's, to be certified
  rc_result result = {};  // its p and gap are the two below
  Reals p, gap;
};

class Oracle {
 public:
  explicit Oracle(const Scene& scene) : scene_(scene), h_(influence(scene)) {}

  /** Ends the process where the answer is wrong: residuals of a certified one, sums, intervals, arrays of a failed one. */
  void check(const Problem& problem, const Answer& answer) const;

 private:
  struct Parts;
  Real cap() const;
  Real round_off() const;
  void check_sums(const Problem& problem, const Answer& answer) const;
  void check_residuals(const Problem& problem, const Answer& answer, Parts& parts) const;
  void check_intervals(const Answer& answer, const Parts& parts) const;

  const Scene& scene_;
  const std::optional<std::vector<Real>> h_;
};

}  // namespace fuzz

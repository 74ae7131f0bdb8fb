// A batch with every output, and its outcome.
#pragma once

#include <roughcontact/history.h>

#include <functional>
#include <string>
#include <vector>

#include "support/contact.h"

namespace batch {

using pairs::Field;

// The value of outputs that no contact has written.
inline constexpr double blank = -7;

struct Outcome {
  rc_status status = RC_ERR_INTERNAL;
  std::string message;
  std::int64_t written = -7, certified = -7, first = -7;
  Field load, approach, contact_area, stiffness, certificate, p;
  std::vector<rc_status> statuses;
  std::vector<std::int64_t> iterations, products;

  // The outcome of one more contact, which is certified.
  void append(const Outcome& more);
};

// Rough surfaces, each with a history of its own.
struct Study {
  pairs::Problem problem;  // the system; control; its surface is not used
  std::int64_t n = 0, steps = 0;
  Field gaps, targets;
  std::vector<std::uint8_t> masks;  // empty: none
  Field p0;                         // empty: none
  bool warm = true, with_stiffness = false;
  pairs::Settings settings;
  pairs::Pair pair = pairs::automatic;
  std::function<bool(std::int64_t contact, std::int64_t step, const rc_result&)> ends;  // empty: no callback

  std::size_t points() const { return problem.points(); }
  double* gap(std::int64_t i) { return gaps.data() + static_cast<std::size_t>(i) * points(); }
  double& target(std::int64_t i, std::int64_t k) { return targets[static_cast<std::size_t>(i * steps + k)]; }
  // The study of contact i alone.
  Study alone(std::int64_t i) const;
  Outcome solve(int threads, const std::function<void(rc_batch&)>& change = {}) const;
};

Study rough_study(std::int64_t n, std::int64_t steps, std::int32_t control = RC_CONTROL_APPROACH,
                  std::int32_t boundary = RC_BOUNDARY_FREE, std::int64_t nx = 24, std::int64_t ny = 18);

// The same bits everywhere.
void check_same(const Outcome& a, const Outcome& b);
void check_outcome(const Outcome& outcome, rc_status status, std::int64_t written, std::int64_t certified, std::int64_t first);

std::vector<pairs::Test> against_single_tests();
std::vector<pairs::Test> ending_tests();

}  // namespace batch

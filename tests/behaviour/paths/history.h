// A path with every output, and the results that its callback got.
#pragma once

#include <functional>

#include "support/contact.h"

namespace paths {

using pairs::Field;

struct Seen {
  rc_result result = {};
  Field p, gap;
};

struct History {
  rc_status status = RC_ERR_INTERNAL;
  std::int64_t completed = -1;
  Field load, approach, contact_area, stiffness, certificate;
  std::vector<std::int64_t> products;
  std::vector<Seen> seen;
  std::string message;
};

struct Request {
  std::int32_t control = RC_CONTROL_APPROACH;
  std::int32_t warm_start = 1;
  Field targets;
  bool with_gap = true;        // else as in the step before
  bool with_stiffness = true;  // else the output is null
  std::function<bool(std::int64_t)> ends = [](std::int64_t) { return false; };
};

// In outputs that no step has written.
inline constexpr double blank = -7;

History follow(const pairs::Contact& contact, const pairs::Problem& problem, const Request& request);
/** The same; fails unless every step is certified. */
History followed(const pairs::Contact& contact, const pairs::Problem& problem, const Request& request);

void check_status(const History& history, rc_status expected, std::int64_t completed);
/** Outputs of the first `steps` steps of `part` are those of `whole` from step `from` on, bit for bit. */
void check_same(const History& part, const History& whole, std::size_t from, std::size_t steps);

}  // namespace paths

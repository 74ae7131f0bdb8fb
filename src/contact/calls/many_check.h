// The check of the answers of rc_solver.solve_many, before the library takes any of them.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "contact/calls/contact.h"
#include "contact/calls/many.h"

namespace rc {

// Why the answers are refused; empty if they may be taken. The answers of the contacts in `solved`, numbered from 0 as in
// `answers`, are compared with their pressures; the residuals of some, which the solver cannot foresee, are computed anew by
// products of `contact`, which has the batch's system and options. first: number in the batch of the first contact of `answers`.
std::string refusal(const rc_batch& batch, ManyAnswers& answers, std::span<const std::int64_t> solved, std::int64_t first,
                    Contact& contact);

}  // namespace rc

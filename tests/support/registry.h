// The pairs that the registry offers, and how their tests are named: solver*backend/boundary/control/...
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "support/contact.h"

namespace pairs {

std::vector<std::string> solver_names();
std::vector<std::string> backend_names();
/** The kernels of a half-space, which need no options. */
std::vector<std::string> kernel_names();
/** Every solver with every backend; those of the solver that RC_TEST_SOLVER names, if it is set. */
std::vector<Pair> all_pairs();

inline constexpr std::int32_t controls[] = {RC_CONTROL_APPROACH, RC_CONTROL_LOAD};

/** Why this pair cannot run, "" if it can. */
std::string obstacle(const Pair& pair, const rc_system& system, std::int32_t control);

/** "free", "periodic", "matrix" (the caller's dense one) or "product" (the caller's). */
std::string kind_of(const rc_system& system);
/** "nnls*fft/free/load" */
std::string group_name(const Pair& pair, const rc_system& system, std::int32_t control);

/** First-order methods and those that solve without a factor: too slow for large stored matrices. */
bool multiplies_often(const Pair& pair);
/** False for the greedy method, which begins with all points in contact unless the start is the solution. */
bool gains_from_a_start(const Pair& pair);
/** The greedy method is exact only where H^-1 has no positive entry off its diagonal: love and disc with free boundaries. */
bool may_fail(const Pair& pair, const Problem& problem);
/** An answer that is not certified, of a solver that may fail on this problem and whose note says that it has. */
bool is_told_failure(const Pair& pair, const Problem& problem, const Answer& answer);

/** One test per pair that supports this kind of half-space grid in approach and in load control. */
void add_for_pairs(std::vector<Test>& tests, const std::string& name, std::int32_t boundary,
                   const std::function<void(const Pair&)>& body);

}  // namespace pairs

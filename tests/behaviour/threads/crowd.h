// Threads that start together, and the failures they report: an assertion may only be made by the test's own thread.
#pragma once

#include <functional>
#include <string>

namespace threads {

inline constexpr int crowd = 8;

// Runs body(0) .. body(crowd - 1) at the same time; each returns "" or what went wrong. Asserts that nothing did.
void together(const std::function<std::string(int)>& body);

// Rounds of a test; fewer where RC_TEST_QUICK is set.
int rounds(int full);

}  // namespace threads

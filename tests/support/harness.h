// Tests whose names are made at run time, on cmocka. A body fails or skips by an exception, so that nothing it owns is leaked.
#pragma once

#include <concepts>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace pairs {

using Field = std::vector<double>;

struct Failure : std::runtime_error {
  using std::runtime_error::runtime_error;
};
struct Skipped : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Test {
  std::string name;
  std::function<void()> body;
};

/** Tests of functions, which are called as these. */
#define RC_TESTS(...) pairs::tests_of(#__VA_ARGS__, {__VA_ARGS__})
std::vector<Test> tests_of(const std::string& names, const std::vector<void (*)()>& bodies);

/** The number of failed tests. An argument is a pattern of names (* and ?). */
int run_group(const char* group, const std::vector<Test>& tests, int argc, char** argv);

/** RC_TEST_QUICK=1 asks for the reduced set, for slow builds. */
bool quick();
/** RC_TEST_FULL=1 asks for what takes many minutes too. */
bool full();

std::string text(double value);

void check(bool condition, const std::string& what);
// A line of figures for whoever reads the test's output.
void report(const std::string& figures);
void check_equal(std::int64_t value, std::int64_t expected, const std::string& what);
template <std::floating_point Value> void check_equal(Value value, auto expected, const std::string& what) = delete;
/** |value - expected| <= tolerance; fails on NaN. */
void check_near(double value, double expected, double tolerance, const std::string& what);
/** Every |a_i - b_i| <= tolerance * max|b|. */
void check_near(const Field& a, const Field& b, double tolerance, const std::string& what);
/** The same bits. */
void check_same(const Field& a, const Field& b, const std::string& what);

double largest(const Field& values);
double sum(const Field& values);

}  // namespace pairs

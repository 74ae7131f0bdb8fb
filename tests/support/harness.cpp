#include "support/harness.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <numeric>
#include <sstream>

#include "support/cmocka.hpp"

namespace pairs {

namespace {

bool asked_for(const char* variable) {
  const char* value = std::getenv(variable);
  return value && *value && std::strcmp(value, "0") != 0;
}

enum class Outcome { passed, failed, skipped };
char message[2048];

Outcome outcome_of(const Test& test) {
  const auto keep = [](const std::string& what) { std::snprintf(message, sizeof message, "%s", what.c_str()); };
  try {
    test.body();
    return Outcome::passed;
  } catch (const Skipped& reason) {
    keep(reason.what());
    return Outcome::skipped;
  } catch (const std::exception& failure) {
    keep(failure.what());
    return Outcome::failed;
  }
}

// cmocka leaves a test by longjmp: nothing with a destructor may live here.
void run_one(void** state) {
  const Outcome outcome = outcome_of(*static_cast<const Test*>(*state));
  if (outcome == Outcome::skipped) {
    print_message("             skipped: %s\n", message);
    skip();
  }
  if (outcome == Outcome::failed) fail_msg("%s", message);
}

}  // namespace

void report(const std::string& figures) { print_message("             %s\n", figures.c_str()); }

std::vector<Test> tests_of(const std::string& names, const std::vector<void (*)()>& bodies) {
  std::vector<Test> tests;
  std::istringstream words(names);
  std::string name;
  for (void (*const body)() : bodies) {
    words >> name;
    tests.push_back({name.substr(0, name.find(',')), body});
  }
  return tests;
}

int run_group(const char* group, const std::vector<Test>& tests, int argc, char** argv) {
  if (argc > 1) cmocka_set_test_filter(argv[1]);
  std::vector<CMUnitTest> list;
  for (const Test& test : tests) list.push_back({test.name.c_str(), run_one, nullptr, nullptr, const_cast<Test*>(&test)});
  return _cmocka_run_group_tests(group, list.data(), list.size(), nullptr, nullptr);
}

bool quick() { return asked_for("RC_TEST_QUICK"); }
bool full() { return asked_for("RC_TEST_FULL"); }

std::string text(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.12g", value);
  return buffer;
}

void check(bool condition, const std::string& what) {
  if (!condition) throw Failure(what);
}

void check_equal(std::int64_t value, std::int64_t expected, const std::string& what) {
  check(value == expected, what + ": " + std::to_string(value) + " instead of " + std::to_string(expected));
}

void check_near(double value, double expected, double tolerance, const std::string& what) {
  check(std::abs(value - expected) <= tolerance, what + ": " + text(value) + " instead of " + text(expected) + ", off by " +
                                                     text(value - expected) + ", allowed " + text(tolerance));
}

void check_near(const Field& a, const Field& b, double tolerance, const std::string& what) {
  check_equal(static_cast<std::int64_t>(a.size()), static_cast<std::int64_t>(b.size()), what + ", length");
  const double scale = largest(b);
  for (std::size_t i = 0; i < a.size(); ++i) check_near(a[i], b[i], tolerance * scale, what + "[" + std::to_string(i) + "]");
}

void check_same(const Field& a, const Field& b, const std::string& what) {
  check_equal(static_cast<std::int64_t>(a.size()), static_cast<std::int64_t>(b.size()), what + ", length");
  for (std::size_t i = 0; i < a.size(); ++i)
    check(std::memcmp(&a[i], &b[i], sizeof a[i]) == 0,
          what + "[" + std::to_string(i) + "]: " + text(a[i]) + " and " + text(b[i]) + " differ by " + text(a[i] - b[i]));
}

double largest(const Field& values) {
  double result = 0;
  for (const double value : values) result = std::max(result, std::abs(value));
  return result;
}

double sum(const Field& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

}  // namespace pairs

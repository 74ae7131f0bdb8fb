// The lengths that the fft backend chooses.
#include <algorithm>
#include <csetjmp>
#include <cstdarg>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "fft/lengths.h"
#include "support/cmocka.hpp"

namespace {

using rc_fft::Lengths;

// By definition: every offset d has its even image's coefficient at d modulo the length, and no two targets coincide.
bool is_exact(std::int64_t length, std::int64_t begin, std::int64_t count, std::int64_t extent) {
  if (length < extent) return false;
  for (std::int64_t source = begin; source < begin + count; ++source)
    for (std::int64_t target = 0; target < extent; ++target) {
      const std::int64_t offset = std::abs(target - source), place = ((target - source) % length + length) % length;
      if (std::min(place, length - place) != offset) return false;
    }
  return true;
}

void exact_length_is_the_least_one(void**) {
  for (std::int64_t extent = 1; extent <= 9; ++extent)
    for (std::int64_t begin = 0; begin < extent; ++begin)
      for (std::int64_t count = 1; begin + count <= extent; ++count) {
        const std::int64_t length = rc_fft::exact_length(begin, count, extent);
        assert_true(is_exact(length, begin, count, extent));
        assert_true(length == 1 || !is_exact(length - 1, begin, count, extent));
        for (std::int64_t longer = length; longer < length + 5; ++longer) assert_true(is_exact(longer, begin, count, extent));
      }
}

void fast_lengths_are_even_and_smooth(void**) {
  assert_int_equal(rc_fft::fast_length(1), 1);
  for (std::int64_t n = 2; n < 5000; ++n) {
    const std::int64_t length = rc_fft::fast_length(n);
    assert_true(length >= n && length < 2 * n);
    assert_int_equal(length % 2, 0);
    std::int64_t rest = length;
    for (std::int64_t prime : {2, 3, 5, 7})
      while (rest % prime == 0) rest /= prime;
    assert_int_equal(rest, 1);
  }
  assert_int_equal(rc_fft::fast_length(2046), 2048);
  assert_true(rc_fft::fast_length(2 * rc_fft::longest_axis) <= INT32_MAX);
}

void a_sequence_of_boxes_rarely_changes_the_lengths(void**) {
  const Lengths largest{1022, 1022};
  Lengths present;
  int changes = 0;
  for (std::int64_t n = 100; n <= 1022; n += 2) {
    const Lengths needed{n, n};
    const Lengths next = rc_fft::choose_lengths(needed, largest, present);
    assert_true(rc_fft::covers(next, needed));
    changes += next == present ? 0 : 1;
    assert_true(rc_fft::choose_lengths(needed, largest, next) == next);
    present = next;
  }
  assert_true(changes < 40);
  assert_true(present == (Lengths{1024, 1024}));
  const Lengths shrunk = rc_fft::choose_lengths({1000, 1000}, largest, present);
  assert_true(shrunk == present);
  const Lengths small = rc_fft::choose_lengths({100, 100}, largest, present);
  assert_true(small.x < 128 && small.y < 128);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(exact_length_is_the_least_one),
      cmocka_unit_test(fast_lengths_are_even_and_smooth),
      cmocka_unit_test(a_sequence_of_boxes_rarely_changes_the_lengths),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}

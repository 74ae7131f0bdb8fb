// The kept inverse against the matrix, while points join the contact set and leave it.
#include <cmath>
#include <random>
#include <vector>

#include "kernel/kernel.h"
#include "solvers/haar_cg/near/contact_inverse.h"
#include "support/cmocka.hpp"

namespace {

constexpr std::int64_t nx = 24, ny = 17;

std::vector<double> coupling() {
  std::vector<double> k(static_cast<std::size_t>(nx * ny));
  rc::kernel::coefficients(*rc::kernel::find("love"), 1.5, 1 / 1.5, nx, ny, k.data());
  return k;
}

// The largest entry of H x - b, for x = H^-1 b, over that of b.
double residual_of(const rc::ContactInverse& inverse, bool second) {
  std::vector<float> b(inverse.padded()), x(b.size()), other(b.size()), y(b.size());
  for (std::size_t i = 0; i < inverse.size(); ++i) {
    b[i] = std::sin(static_cast<float>(i));
    other[i] = 1;
  }
  if (second)
    inverse.multiply(other, y, &b, &x);
  else
    inverse.multiply(b, x);
  double worst = 0;
  for (std::size_t i = 0; i < inverse.size(); ++i) {
    double left = -static_cast<double>(b[i]);
    for (std::size_t j = 0; j < inverse.size(); ++j)
      left += inverse.coupling(inverse.point(i), inverse.point(j)) * static_cast<double>(x[j]);
    worst = std::max(worst, std::abs(left));
  }
  return worst;
}

void it_follows_a_set_that_changes(void**) {
  constexpr std::size_t most = 151;
  rc::ContactInverse inverse(nx, ny, coupling(), most);
  std::mt19937 random(3);
  std::vector<std::int64_t> in;
  for (int change = 0; change < 1500; ++change) {
    if (in.size() == most || (!in.empty() && random() % 5 < 2)) {
      const std::size_t k = random() % in.size();
      inverse.remove(in[k]);
      assert_false(inverse.has(in[k]));
      in.erase(in.begin() + static_cast<std::ptrdiff_t>(k));
    } else {
      const auto point = static_cast<std::int64_t>(random() % static_cast<unsigned>(nx * ny));
      if (inverse.has(point)) continue;
      assert_true(inverse.add(point));
      in.push_back(point);
    }
    assert_int_equal(inverse.size(), in.size());
    for (const std::int64_t point : in) assert_int_equal(inverse.point(inverse.place(point)), point);
    if (change % 50 == 0) assert_true(residual_of(inverse, change % 100 == 0) < 1e-4);
  }
  assert_true(in.size() > most / 2);
}

void it_has_no_room_for_more_than_it_was_made_for(void**) {
  rc::ContactInverse inverse(nx, ny, coupling(), 2);
  assert_true(inverse.add(5) && inverse.add(77));
  assert_false(inverse.add(6));
}

void a_column_is_what_a_pressure_deflects(void**) {
  const rc::ContactInverse inverse(nx, ny, coupling(), 1);
  std::vector<double> to(static_cast<std::size_t>(nx * ny), 1);
  inverse.add_column(30, 2, to);
  for (std::int64_t i = 0; i < nx * ny; ++i)
    assert_true(std::abs(to[static_cast<std::size_t>(i)] - 1 - 2 * inverse.coupling(30, i)) < 1e-12);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(it_follows_a_set_that_changes),
                              cmocka_unit_test(it_has_no_room_for_more_than_it_was_made_for),
                              cmocka_unit_test(a_column_is_what_a_pressure_deflects)};
  return cmocka_run_group_tests_name("contact inverse", tests, nullptr, nullptr);
}

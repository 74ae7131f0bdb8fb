// What the dense backend keeps from one call to the next, and its limit of memory.
#include <algorithm>
#include <cmath>

#include "fixtures.h"
#include "support/cmocka.hpp"

RC_PLUGIN_LINKAGE rc_status rc_builtin_dense(const rc_host*, const rc_plugin**);

namespace {

using contract::Index;
using contract::range;
using contract::StandInHost;
using contract::Vector;

const rc_backend& backend() {
  const rc_plugin* plugin = nullptr;
  rc_builtin_dense(nullptr, &plugin);
  return *plugin->backends[0];
}

// A caller's matrix that is scaled behind the operator's back: what follows it was computed anew, what does not was kept.
struct Identity {
  static constexpr std::int64_t n = 20;
  Vector H = Vector(n * n);
  StandInHost host{backend()};
  contract::Operator op{backend(), host, contract::callers_matrix(H, n, n)};

  Identity() { scale(1.0); }
  void scale(double to) {
    for (std::size_t i = 0; i < n; ++i) H[(n + 1) * i] = to;
  }
  double product(std::size_t count) { return op.apply(Vector(count, 1.0))[0]; }
  double solution(const Index& positions) {
    const Vector x = op.subset(positions, Vector(positions.size(), 1.0));
    return *std::ranges::max_element(x);
  }
  double shifted(double rho, std::size_t count) { return op.shifted(rho, Vector(count, 1.0))[0]; }
};

void the_matrix_of_the_same_domain_is_kept(void**) {
  Identity of;
  of.op.bind(range(0, 20));
  assert_true(of.product(20) == 1.0);
  of.scale(0.25);
  of.op.bind(range(0, 20), 0.0, true);
  assert_true(of.product(20) == 1.0);
  of.op.bind({0, 1});
  assert_true(of.product(2) == 0.25);
}

void a_change_of_domain_keeps_the_factor_of_the_same_points(void**) {
  Identity of;
  of.op.bind(range(0, 20));
  assert_true(of.solution({4, 9, 15}) == 1.0);
  of.scale(0.25);
  of.op.bind({2, 4, 9, 11, 15});
  assert_true(of.solution({1, 2, 4}) == 1.0);
  assert_true(of.solution({1, 2, 3, 4}) == 4.0);
  of.op.bind({2, 4, 9, 11, 15}, 1.0);
  assert_true(of.solution({1, 2, 4}) == 4.0);
}

void the_shifted_factor_stays_as_long_as_set_and_shift(void**) {
  Identity of;
  of.op.bind(range(0, 20));
  assert_true(of.shifted(3.0, 20) == 0.25);
  of.scale(10.0);
  of.op.bind(range(0, 20));
  of.solution(range(0, 5));
  assert_true(of.shifted(3.0, 20) == 0.25);
  assert_true(of.shifted(6.0, 20) == 0.0625);
  of.op.bind({3, 4});
  assert_true(of.shifted(54.0, 2) == 0.015625);
}

void coefficients_are_fetched_late_and_for_the_bounding_box(void**) {
  static std::int64_t mx, my, requests;
  static decltype(rc_host::coefficients) given;
  StandInHost host(backend());
  given = host.coefficients;
  host.coefficients = [](const rc_host* of, const rc_system* system, const char* kernel, std::int64_t nx, std::int64_t ny,
                         double* out) {
    mx = nx, my = ny, ++requests;
    return given(of, system, kernel, nx, ny, out);
  };
  contract::Operator op(backend(), host,
                        contract::halfspace(RC_BOUNDARY_FREE, 200, 100, 1.0, 1.0));  // of a small grid all at once
  op.bind({5 * 200 + 7, 5 * 200 + 12, 8 * 200 + 9});                                 // 6 x 4 cells
  assert_int_equal(requests, 0);
  op.apply(Vector(3, 1.0));
  assert_true(mx == 6 && my == 4);
  op.bind({0, 3});  // fits in the table
  op.apply(Vector(2, 1.0));
  assert_int_equal(requests, 1);
  op.field(Vector(2, 1.0));
  assert_true(mx == 200 && my == 100);
}

void assert_refused(rc_status status, const char* reason, const char* advice) {
  assert_int_equal(status, RC_ERR_MEMORY);
  const std::string& message = StandInHost::message();
  if (message.find(reason) == std::string::npos || message.find(advice) == std::string::npos) fail_msg("%s", message.c_str());
}

void the_limit_is_kept_and_explained(void**) {
  StandInHost host(backend());
  host.set("dense.memory_limit", "1");
  contract::Operator op(backend(), host, contract::halfspace(RC_BOUNDARY_FREE, 60, 40, 1.0, 1.0));
  const rc_domain all{sizeof(rc_domain), 2400, nullptr, 0.0};
  assert_refused(backend().bind(op.handle(), &all), "dense: the matrix of 2400 unknowns needs 25436160 bytes, the ",
                 "limit dense.memory_limit is 1 MiB; raise it or use a backend that stores no matrix (\"fft\")");
  op.bind(range(0, 300));
  const Vector ones(300, 1.0), x = op.subset(range(0, 300), ones);  // 786432 bytes
  const Vector y = op.apply(x);                                     // 630 kB more would be too many: from the entries
  assert_true(contract::largest_difference(y, ones) <= 1e-12);
}

// Products with a caller's matrix need no memory; only its factor may be too large, and no other backend has a smaller one.
void the_limit_leaves_products_with_a_callers_matrix(void**) {
  constexpr std::int64_t n = 600;
  Vector H(n * n, 0.5), x(n);
  for (std::size_t i = 0; i < n; ++i) H[(n + 1) * i] = 1.5;
  StandInHost host(backend());
  host.set("dense.memory_limit", "1");
  contract::Operator op(backend(), host, contract::callers_matrix(H, n, n));
  op.bind(range(0, n));
  const Vector ones(n, 1.0);
  assert_true(std::abs(op.apply(ones)[7] - 301.0) < 1e-10);
  assert_refused(backend().subset(op.handle(), n, range(0, n).data(), ones.data(), x.data()),
                 "the Cholesky factor of 600 unknowns needs 1966080 bytes", "raise it or use a solver that only multiplies");
  assert_int_equal(backend().shifted(op.handle(), 0.1, ones.data(), x.data()), RC_ERR_MEMORY);
  op.subset(range(0, 300), Vector(300, 1.0));
}

// Matrix and both factors in turn, where only one of them fits at a time.
void results_are_the_same_without_room_for_everything(void**) {
  std::vector<Vector> results;
  const Vector b = contract::random_vector(360, 12);
  for (const char* limit : {"8192", "1"}) {
    StandInHost host(backend());
    host.set("dense.memory_limit", limit);
    contract::Operator op(backend(), host, contract::halfspace(RC_BOUNDARY_FREE, 20, 18, 1.0, 1.0));
    op.bind(range(0, 360));
    for (int repeat = 0; repeat < 3; ++repeat)
      results.insert(results.end(),
                     {op.apply(b), op.shifted(0.2, b), op.subset(range(3, 353), Vector(b.begin(), b.begin() + 350))});
  }
  for (std::size_t i = 0; i < 9; ++i) assert_true(contract::largest_difference(results[i], results[i + 9]) <= 1e-11 * 20);
}

// Its last pivot is of rounding. Without any one of its points it is definite.
void a_projector_is_singular_as_a_whole(void**) {
  constexpr std::int64_t n = 100;
  Vector H(n * n, -1.0 / n), ones(n, 1.0), x(n);
  for (std::size_t i = 0; i < n; ++i) H[(n + 1) * i] += 1.0;
  StandInHost host(backend());
  contract::Operator op(backend(), host, contract::callers_matrix(H, n, n));
  op.bind(range(0, n));
  const auto solved = [&](std::int64_t count) {
    return backend().subset(op.handle(), count, range(0, n).data(), ones.data(), x.data());
  };
  assert_int_equal(solved(n), RC_ERR_NUMERIC);
  assert_int_equal(solved(n - 1), RC_OK);
  assert_int_equal(solved(n), RC_ERR_NUMERIC);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(the_matrix_of_the_same_domain_is_kept),
      cmocka_unit_test(a_change_of_domain_keeps_the_factor_of_the_same_points),
      cmocka_unit_test(the_shifted_factor_stays_as_long_as_set_and_shift),
      cmocka_unit_test(coefficients_are_fetched_late_and_for_the_bounding_box),
      cmocka_unit_test(the_limit_is_kept_and_explained),
      cmocka_unit_test(the_limit_leaves_products_with_a_callers_matrix),
      cmocka_unit_test(results_are_the_same_without_room_for_everything),
      cmocka_unit_test(a_projector_is_singular_as_a_whole),
  };
  return cmocka_run_group_tests_name("dense_backend", tests, nullptr, nullptr);
}

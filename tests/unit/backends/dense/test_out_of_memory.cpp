// Every allocation of the backend fails in turn: the call must report it, and the operator must go on working.
#include <numeric>
#include <vector>

#include "stand_in_host.h"
#include "support/cmocka.hpp"
#include "support/failing_new.h"

namespace {

using Eigen::VectorXd;
using Positions = std::vector<std::int64_t>;

constexpr std::int64_t nx = 12, ny = 9, n = nx * ny;

// Products and solves that touch every path: assembly, factor, growth, rotations, cut, change of domain.
struct Walk {
  Positions everywhere = Positions(n), half = Positions(n / 2), fewer, other = {3, 50, 51, 100};
  VectorXd x = VectorXd::Ones(n), y = VectorXd::Zero(n);

  Walk() {
    std::iota(everywhere.begin(), everywhere.end(), 0);
    std::iota(half.begin(), half.end(), 10);
    for (const auto i : half)
      if (i % 20 != 0) fewer.push_back(i);
  }

  rc_status operator()(void* self) {
    const rc_backend& backend = stand_in::backend();
    const rc_domain domain = {sizeof(rc_domain), n, nullptr, 0.0};
    rc_status status = backend.bind(self, &domain);
    if (status == RC_OK) status = backend.apply(self, x.data(), y.data());
    if (status == RC_OK) status = backend.field(self, x.data(), y.data());
    for (const Positions* a : {&half, &fewer, &everywhere, &other})
      if (status == RC_OK) status = backend.subset(self, static_cast<std::int64_t>(a->size()), a->data(), x.data(), y.data());
    if (status == RC_OK) status = backend.shifted(self, 0.5, x.data(), y.data());
    if (status == RC_OK) status = backend.norm(self, y.data());
    const rc_domain part = {sizeof(rc_domain), 54, half.data(), 0.0};
    if (status == RC_OK) status = backend.bind(self, &part);
    if (status == RC_OK) status = backend.apply(self, x.data(), y.data());
    return status;
  }
};

void every_failed_allocation_is_reported(void**) {
  const rc_system system = stand_in::half_space(nx, ny);
  const rc_operator_spec spec = {sizeof(rc_operator_spec), &system, "stand-in", nullptr, nullptr, nullptr};
  Walk walk;
  long reported = 0;
  for (long k = 0;; ++k) {
    void* self = nullptr;
    support::fail_allocation(k + 1);
    rc_status status = stand_in::backend().create(&stand_in::host(), &spec, &self);
    if (status == RC_OK) status = walk(self);
    const bool failed = support::allocation_failed();
    support::fail_allocation(0);
    assert_int_equal(status, failed ? RC_ERR_MEMORY : RC_OK);
    reported += failed;
    if (self) {
      assert_int_equal(walk(self), RC_OK);
      stand_in::backend().destroy(self);
    }
    if (!failed) break;
  }
  assert_true(reported > 20);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(every_failed_allocation_is_reported)};
  return cmocka_run_group_tests_name("dense_out_of_memory", tests, nullptr, nullptr);
}

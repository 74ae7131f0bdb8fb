#ifdef RC_CONTRACT_SUITESPARSE
#include "allocators.h"
#endif
#include "cases.h"
#include "fixtures.h"
#include "support/cmocka.hpp"
#include "support/failing_new.h"

namespace contract {

namespace {
constexpr std::size_t most_taken = 64 << 20;  // bytes
}

// Lets a later allocation fail each time, until a run succeeds.
void any_allocation_may_fail(const rc_backend& backend) {
#ifdef RC_CONTRACT_SUITESPARSE
  let_dependencies_use_operator_new();
#endif
  for (std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC}) {
    if (!(backend.caps & (boundary == RC_BOUNDARY_FREE ? RC_CAP_FREE : RC_CAP_PERIODIC))) continue;
    const rc_system system = halfspace(boundary, 9, 8, 1.0, 1.0);
    const Index domain{3, 4, 17, 30};
    const Vector x(4, 1.0);
    for (const char* threads : {"1", "3"}) {
      StandInHost host(backend);
      host.set("threads", threads);
      const rc_operator_spec spec = spec_of(system, host);
      Vector y(72);
      bool failed = true;
      for (std::int64_t k = 1; failed; ++k) {
        assert_true(k < 1000);
        support::fail_allocation(k);
        const rc_status status = status_of_operations(backend, host, spec, domain, x.data(), y.data());
        failed = support::allocation_failed();
        support::fail_allocation(0);
        assert_int_equal(status, failed ? RC_ERR_MEMORY : RC_OK);
        if (failed) assert_true(StandInHost::message().find(backend.name) == 0);
      }
    }
  }
}

// Neither can be allocated: more than the address space, and more than an integer counts. Nothing is taken for a side of them
// before they are refused.
void impossible_sizes_are_refused(const rc_backend& backend) {
  for (std::int64_t side : {std::int64_t{1} << 24, std::int64_t{1} << 28, std::int64_t{1} << 31}) {
    StandInHost host(backend);
    const rc_system system = halfspace(RC_BOUNDARY_FREE, side, side, 1.0, 1.0);
    const Index corners{0, side * side - 1};
    const Vector x(2, 1.0);
    Vector y(2);
    support::fail_allocation(0);
    const rc_status status = status_of_operations(backend, host, spec_of(system, host), corners, x.data(), y.data());
    assert_true(status == RC_ERR_MEMORY || status == RC_ERR_SHAPE);
    assert_true(StandInHost::message().find(backend.name) == 0);
    assert_true(support::largest_allocation() <= most_taken);
  }
}

}  // namespace contract

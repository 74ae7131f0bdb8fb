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

// Lets a later allocation fail each time, until a run succeeds. After a failure the operator works on. A backend that has coarse
// grids gets a grid that needs them.
void any_allocation_may_fail(const rc_backend& backend) {
#ifdef RC_CONTRACT_SUITESPARSE
  let_dependencies_use_operator_new();
#endif
  struct Grid {
    std::int32_t boundary;
    std::int64_t nx, ny;
    Index domain;
    const char* threads;
  };
  std::vector<Grid> grids;
  for (const char* threads : {"1", "3"})
    for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC})
      if (backend.caps & (boundary == RC_BOUNDARY_FREE ? RC_CAP_FREE : RC_CAP_PERIODIC))
        grids.push_back({boundary, 12, 9, range(0, 108), threads});
  const bool coarse = backend.caps & RC_CAP_SCREEN;
  if (coarse) grids.push_back({RC_BOUNDARY_FREE, 200, 160, {3, 200 * 160 - 1}, "1"});
  for (const Grid& grid : grids) {
    const rc_system system = halfspace(grid.boundary, grid.nx, grid.ny, 1.0, 1.0);
    StandInHost host(backend);
    host.set("threads", grid.threads);
    if (coarse) host.set("split.spacing", "16");
    const rc_operator_spec spec = spec_of(system, host);
    Walk walk(grid.domain, grid.nx * grid.ny);
    bool failed = true;
    for (std::int64_t k = 1; failed; k += coarse ? 1 + k / 8 : 1) {
      assert_true(k < 5000);
      void* self = nullptr;
      support::fail_allocation(k);
      rc_status status = backend.create(&host, &spec, &self);
      if (status == RC_OK) status = walk(backend, self);
      failed = support::allocation_failed();
      support::fail_allocation(0);
      assert_int_equal(status, failed ? RC_ERR_MEMORY : RC_OK);
      if (failed) assert_true(StandInHost::message().find(backend.name) == 0);
      if (!self) continue;
      assert_int_equal(walk(backend, self), RC_OK);
      backend.destroy(self);
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
    Walk walk(corners, 2);
    support::fail_allocation(0);
    const rc_status status = walk.from_creation(backend, host, spec_of(system, host));
    assert_true(status == RC_ERR_MEMORY || status == RC_ERR_SHAPE);
    assert_true(StandInHost::message().find(backend.name) == 0);
    assert_true(support::largest_allocation() <= most_taken);
  }
}

}  // namespace contract

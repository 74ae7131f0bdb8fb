#include "scene.h"
#include "support/cmocka.hpp"
#include "support/failing_new.h"
#include "support/unit_system.h"

namespace split {

namespace {

rc_status all_operations(const rc_host& host, const rc_operator_spec& spec, const Index& domain, const Vector& x,
                         const Vector& gap, Vector& y) {
  void* self = nullptr;
  rc_status status = backend().create(&host, &spec, &self);
  if (status != RC_OK) return status;
  const rc_domain bound{sizeof(rc_domain), static_cast<std::int64_t>(domain.size()), domain.data(), 0.0};
  const float single[] = {1.0F, 2.0F};
  float product[2];
  std::int64_t found[4];
  double depth[4], at_points[2];
  rc_screen request{.struct_size = sizeof(rc_screen),
                    .approach = 1.0,
                    .unit = 1.0,
                    .undeformed_gap = {gap.data(), RC_NATIVE, 0, nullptr},
                    .y = at_points,
                    .room = 4,
                    .found = found,
                    .depth = depth};
  status = backend().bind(self, &bound);
  if (status == RC_OK) status = backend().apply(self, x.data(), y.data());
  if (status == RC_OK) status = backend().apply_float(self, single, product);
  if (status == RC_OK) status = backend().field(self, x.data(), y.data());
  if (status == RC_OK) status = backend().screen(self, x.data(), &request);
  backend().destroy(self);
  return status;
}

}  // namespace

// Lets a later allocation fail each time, until a run succeeds; on a grid that needs coarse grids.
void any_allocation_may_fail(void**) {
  rc_system system = support::unit_system();
  system.nx = 200;
  system.ny = 160;
  const Index domain{3, system.nx * system.ny - 1};
  const Vector x{1.0, 2.0};
  contract::StandInHost host(backend());
  host.set("split.spacing", "16");
  const rc_operator_spec spec{sizeof(rc_operator_spec), &system, "love", host.options(), host.alone(), nullptr};
  Vector y(static_cast<std::size_t>(system.nx * system.ny));
  const Vector gap(y.size(), 0.0);
  bool failed = true;
  int failures = 0;
  for (std::int64_t k = 1; failed; k += 1 + k / 8) {
    support::fail_allocation(k);
    const rc_status status = all_operations(host, spec, domain, x, gap, y);
    failed = support::allocation_failed();
    support::fail_allocation(0);
    assert_int_equal(status, failed ? RC_ERR_MEMORY : RC_OK);
    if (failed) assert_true(contract::StandInHost::message().find("split: ") == 0);
    failures += failed ? 1 : 0;
  }
  assert_true(failures > 20);
}

}  // namespace split

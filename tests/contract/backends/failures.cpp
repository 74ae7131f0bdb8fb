#include "cases.h"
#include "fixtures.h"
#include "support/cmocka.hpp"

namespace contract {

void host_failure_is_passed_on(const rc_backend& backend) {
  for (std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC}) {
    if (!(backend.caps & (boundary == RC_BOUNDARY_FREE ? RC_CAP_FREE : RC_CAP_PERIODIC))) continue;
    StandInHost host(backend);
    const rc_system system = halfspace(boundary, 5, 4, 1.0, 1.0);
    const Index domain{3, 4, 9};
    const Vector x(3, 1.0);
    Vector y(20);
    host.answer_with(RC_ERR_NUMERIC);
    assert_int_equal(Walk(domain, 20).from_creation(backend, host, spec_of(system, host)), RC_ERR_NUMERIC);

    // An operator that failed to bind, or in field(), can be used again.
    void* self = nullptr;
    const rc_operator_spec spec = spec_of(system, host);
    const rc_domain bound{sizeof(rc_domain), 3, domain.data(), 0.0};
    host.answer_with(RC_OK);
    assert_int_equal(backend.create(&host, &spec, &self), RC_OK);
    host.answer_with(RC_ERR_NUMERIC);
    static_cast<void>(backend.bind(self, &bound));
    host.answer_with(RC_OK);
    assert_int_equal(backend.bind(self, &bound), RC_OK);
    host.answer_with(RC_ERR_NUMERIC);
    static_cast<void>(backend.field(self, x.data(), y.data()));
    host.answer_with(RC_OK);
    const Matrix matrix(system);
    assert_int_equal(backend.apply(self, x.data(), y.data()), RC_OK);
    assert_true(largest_difference({y[0], y[1], y[2]}, matrix.product(domain, domain, x)) <= 1e-13 * matrix.norm());
    assert_int_equal(backend.field(self, x.data(), y.data()), RC_OK);
    assert_true(largest_difference(y, matrix.product(range(0, 20), domain, x)) <= 1e-13 * matrix.norm());
    backend.destroy(self);
  }
}

}  // namespace contract

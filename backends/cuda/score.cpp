// What `auto` compares. The host build is for tests: it is there for those who name it.
#include "operator.h"
#include "solver.h"

namespace rc_cuda {

#ifdef __CUDACC__

namespace {

// [s] Of a device that copies 2e12 bytes a second behind a bus of 1e10 bytes a second. A launch takes 4e-6.
constexpr double of_byte = 0.5e-12, of_transfer = 1e-10, of_launch = 4e-6;
constexpr double bytes_of_product = 160, bytes_of_step = 300, launches_of_product = 9, launches_of_step = 40;  // for each point
constexpr double products = 40;                                                                                // of a usual step
constexpr double least_points = 128 * 128;

double product_of(double points) { return launches_of_product * of_launch + bytes_of_product * of_byte * points; }

}  // namespace

void Operator::score(const rc_facts& facts, rc_estimate& estimate) {
  const auto box = static_cast<double>(facts.box), grid = static_cast<double>(facts.system->nx * facts.system->ny);
  if (box < least_points) fail(RC_ERR_INCOMPATIBLE, "fewer than ", least_points, " points");
  estimate.product = product_of(box) + 16 * of_transfer * box;
  estimate.field = product_of(grid) + 8 * of_transfer * (box + grid);
  estimate.bytes = 16 * grid;  // of the host's memory
}

rc_status score(const rc_facts* facts, rc_estimate* estimate) noexcept {
  return roughcontact::guard(facts->host, component, [&] {
    const auto box = static_cast<double>(facts->box);
    if (box < least_points) fail(RC_ERR_INCOMPATIBLE, "fewer than ", least_points, " points");
    const double step = product_of(box) + launches_of_step * of_launch + bytes_of_step * of_byte * box;
    estimate->seconds = facts->backend->seconds + products * step + 16 * of_transfer * box + facts->backend->field;
    estimate->bytes = 16 * box;
  });
}

#else

void Operator::score(const rc_facts&, rc_estimate&) { fail(RC_ERR_INCOMPATIBLE, "for tests: the host in the place of a device"); }

rc_status score(const rc_facts* facts, rc_estimate*) noexcept {
  return roughcontact::guard(facts->host, component,
                             [] { fail(RC_ERR_INCOMPATIBLE, "for tests: the host in the place of a device"); });
}

#endif

}  // namespace rc_cuda

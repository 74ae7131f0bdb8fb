// The estimates that `auto` compares. The host build is for tests: only a caller who names it gets it.
#include <algorithm>

#include "operator.h"
#include "small/many.h"
#include "solver.h"

namespace rc_cuda {

#ifdef __CUDACC__

namespace {

// [s] Measured on an H100, as docs/development/device.md says. For each point: a product, the rest of a step, the host's work and
// transfers of a solve. For each byte: a transfer of an operator. For each launch: its time, with the launches on coarser grids.
constexpr double of_product = 1.3e-10, of_step = 6e-11, of_host = 1e-8, of_transfer = 1e-10, of_launch = 1.1e-5;
constexpr double launches_of_product = 9, launches_of_step = 40;
constexpr double products = 40;  // of a usual step
constexpr double least_points = 512 * 512;
// Seconds of a step and a product over 4096 points by one block of threads; blocks that run at a time; seconds that a batch takes
// besides.
constexpr double of_block = 1.9e-4, blocks = 264, of_batch = 2e-3;

// Whether a block takes each of the contacts, of which there are many.
bool many(const rc_facts& facts) { return facts.at_once > 1 && facts.box <= most_points_of_many; }

// Throws where this is not for the device: too little work, too little memory, or no device that answers.
void require_device(const rc_facts& facts) {
  const auto box = static_cast<double>(facts.box);
  if (box < least_points && !many(facts)) fail(RC_ERR_INCOMPATIBLE, "fewer than ", least_points, " points");
  const bool periodic = facts.system->boundary == RC_BOUNDARY_PERIODIC;
  const double torus = periodic ? 8 * box : 32 * box, eigenvalues = periodic ? 3 * box : 12 * box, vectors = 45 * box;
  const double needed = 2 * torus + eigenvalues + vectors;  // transforms take as much beside the torus
  const Settings settings(facts.host, facts.options);
  const double there = std::min(settings.limit, static_cast<double>(free_bytes_of(settings.index)));
  if (needed > there)
    fail(RC_ERR_INCOMPATIBLE, "needs about ", needed, " bytes on device ", settings.index, ", which has ", there);
}

double product_of(double points) { return launches_of_product * of_launch + of_product * points; }

}  // namespace

void Operator::score(const rc_facts& facts, rc_estimate& estimate) {
  const auto box = static_cast<double>(facts.box), grid = static_cast<double>(facts.system->nx * facts.system->ny);
  require_device(facts);
  estimate.product = product_of(box) + 16 * of_transfer * box;
  // Where a block takes each contact, it makes the product of the certificate as well.
  estimate.field = many(facts) ? 0 : product_of(grid) + 8 * of_transfer * (box + grid);
  estimate.bytes = 16 * grid;  // of the host's memory
}

rc_status score(const rc_facts* facts, rc_estimate* estimate) {
  return roughcontact::guard(facts->host, component, [&] {
    const auto box = static_cast<double>(facts->box);
    require_device(*facts);
    estimate->bytes = 16 * box;
    if (many(*facts)) {
      const auto n = static_cast<double>(facts->at_once);
      const double alone = products * of_block * box / 4096;
      estimate->seconds = alone / std::min(n, blocks) + of_batch / n + 16 * of_transfer * box + facts->backend->field;
      return;
    }
    const double step = product_of(box) + launches_of_step * of_launch + of_step * box;
    estimate->seconds = facts->backend->seconds + products * step + of_host * box + facts->backend->field;
  });
}

#else

void Operator::score(const rc_facts&, rc_estimate&) { fail(RC_ERR_INCOMPATIBLE, "for tests: the host in the place of a device"); }

rc_status score(const rc_facts* facts, rc_estimate*) {
  return roughcontact::guard(facts->host, component,
                             [] { fail(RC_ERR_INCOMPATIBLE, "for tests: the host in the place of a device"); });
}

#endif

}  // namespace rc_cuda

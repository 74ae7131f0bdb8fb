#include "half_space.h"

#include <cmath>

namespace rc_fft {

// Transforms of the doubled box, and of the doubled grid for field().
void HalfSpace::score(const rc_facts& facts, rc_estimate& estimate) {
  const auto seconds = [](double points) { return 1e-9 * points * std::log2(4 * points + 1); };
  const auto box = static_cast<double>(facts.box), grid = static_cast<double>(facts.system->nx * facts.system->ny);
  estimate.product = seconds(box);
  estimate.field = seconds(grid);
  estimate.bytes = 28 * box + 12 * grid;
}

HalfSpace::HalfSpace(const rc_host* host, const rc_operator_spec& spec)
    : op_(host, spec), slabs_(spec.rows ? std::make_unique<Slabs>(host, spec) : nullptr) {}

}  // namespace rc_fft

// The arrays of numbers that histories and batches have in common: value i is the number of one step.
#pragma once

#include <cstdint>

#include "contact/proof/result.h"

namespace rc {

// to: null if the caller does not want it.
template <class Number> void put(Number* to, std::int64_t i, Number value) {
  if (to) to[i] = value;
}

// Outputs: rc_history or rc_batch.
template <class Outputs> void put_numbers(const Outputs& to, std::int64_t i, const Numbers& numbers, const System& system) {
  put(to.load, i, numbers.load(system));
  put(to.approach, i, numbers.approach);
  put(to.contact_area, i, contact_area(numbers, system));
  put(to.mean_gap, i, numbers.mean_gap);
  put(to.energy, i, numbers.energy(system));
  put(to.stiffness, i, numbers.stiffness.value);
  put(to.load_lower, i, numbers.bounds.load_lower);
  put(to.load_upper, i, numbers.bounds.load_upper);
  put(to.area_lower, i, numbers.bounds.area_lower);
  put(to.area_upper, i, numbers.bounds.area_upper);
  put(to.stiffness_lower, i, numbers.stiffness.lower);
  put(to.stiffness_upper, i, numbers.stiffness.upper);
  put(to.certificate, i, numbers.certificate.worst());
  put(to.products, i, numbers.work.products);
}

}  // namespace rc

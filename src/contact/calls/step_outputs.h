// Columns of numbers: value i is the number of one step.
#pragma once

#include <roughcontact/history.h>

#include <cstdint>
#include <limits>

#include "contact/proof/result.h"

namespace rc {

// to: none if the caller does not want it.
template <class Number> void put(const rc_array& to, std::int64_t i, Number value) {
  if (to.data) values_of<Number>(to)[i] = value;
}

inline void put_numbers(const rc_columns& to, std::int64_t i, const Numbers& numbers, const System& system) {
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
  put(to.iterations, i, numbers.work.iterations);
  put(to.products, i, numbers.work.products);
  put(to.status, i, numbers.status);
}

// A step without an answer.
inline void put_none(const rc_columns& to, std::int64_t i, rc_status status) {
  for (const rc_array& values :
       {to.load, to.approach, to.contact_area, to.mean_gap, to.energy, to.stiffness, to.load_lower, to.load_upper, to.area_lower,
        to.area_upper, to.stiffness_lower, to.stiffness_upper, to.certificate})
    put(values, i, std::numeric_limits<double>::quiet_NaN());
  for (const rc_array& counts : {to.iterations, to.products}) put(counts, i, std::int64_t{-1});
  put(to.status, i, status);
}

// The least values of options stiffness and bounds with which steps have these columns.
struct ColumnWants {
  std::int64_t stiffness, bounds;
};
inline ColumnWants wants_of(const rc_columns& columns) {
  const bool stiffness_interval = columns.stiffness_lower.data || columns.stiffness_upper.data;
  return {stiffness_interval       ? 2
          : columns.stiffness.data ? 1
                                   : 0,
          stiffness_interval || columns.load_lower.data || columns.load_upper.data || columns.area_lower.data ||
              columns.area_upper.data};
}

}  // namespace rc

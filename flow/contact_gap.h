// The gap of a contact's result, with what its certificate proves of the exact one; docs/development/flow.md derives it.
#pragma once

#include <roughcontact/product.h>

#include "network_flow.h"

namespace rc::flow {

// A status of the core, with its message.
void check_core(rc_status status);

// The largest deflection under a unit pressure on one cell, of the cell itself [length per pressure].
double largest_deflection(const rc_system& system, const rc_options* options);

// The bound of |gap - exact gap| at the returned approach or, with a load, at that load [length]; NaN: none is known. options: of
// the contact. mask: null, or 0 where a point is excluded.
double gap_error(const rc_system& system, const rc_options* options, const rc_result& result, const std::uint8_t* mask,
                 double load = 0);

// error: of gap_error. Points are proven to be in contact at the returned approach alone.
Gap contact_gap(const rc_system& system, const rc_result& result, const std::uint8_t* mask, double error, bool at_approach);

}  // namespace rc::flow

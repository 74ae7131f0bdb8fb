// rc_law_slip and rc_law_slip_bounds: table.c's slip, in the caller's struct
#include "law/slip.h"

#include <roughcontact/law.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "abi/guard.h"
#include "abi/sized_struct.h"
#include "law/law.h"

namespace {

using namespace rc;
using SlipState = rc_law_slip_state;

constexpr double most_layers = LAW_SLIP_LAYERS;
static_assert(std::size(SlipState{}.memory) == LAW_SLIP_NUMBERS);

const law_slip_state& memory_of(const SlipState& state) { return *reinterpret_cast<const law_slip_state*>(state.memory); }

// Why a step was refused.
[[noreturn]] void refuse(const Law& law, const SlipState& before, double x, const double* slip) {
  check_slips(law);
  check_friction(before.mu, before.nu, "rc_law_slip_state");
  if (!std::isfinite(x) || !std::isfinite(slip[0]) || !std::isfinite(slip[1]))
    fail(RC_ERR_ARGUMENT, "x = ", x, ", slip = ", slip[0], ", ", slip[1], " must be finite");
  if (const law_slip_state& memory = memory_of(before); memory.layers > 0 && !(memory.x > 0))
    fail(RC_ERR_ARGUMENT, "rc_law_slip_state holds slip before contact, at the overclosure ", memory.x,
         "; begin with RC_LAW_SLIP_STATE_INIT");
  fail(RC_ERR_ARGUMENT, "rc_law_slip_state.memory is none that rc_law_slip has left; begin with RC_LAW_SLIP_STATE_INIT");
}

bool same_size(const SlipState* state) { return state && state->struct_size == sizeof *state; }

rc_status step(const Law& law, const SlipState& before, double x, const double* slip, SlipState& after) {
  double forces[LAW_SLIP_FORCES];
  const int status = roughcontact_law_slip(law.table.data(), before.mu, before.nu, before.memory, x, slip, after.memory, forces);
  if (status < 0) return status;
  after.mu = before.mu, after.nu = before.nu;
  after.p = forces[0];
  after.slope = forces[3];
  std::copy_n(forces + 1, 2, after.shear);
  std::copy_n(forces + 4, 2, after.shear_by_x);
  std::copy_n(forces + 6, 4, after.shear_by_slip);
  after.dissipated = memory_of(after).dissipated;
  after.joined = after.mu * memory_of(after).joined;
  return status;
}

}  // namespace

namespace rc {

void check_slips(const Law& law) {
  if (law.info.hardness > 0)
    fail(RC_ERR_INCOMPATIBLE,
         "the law has a hardness, so unloading is another law, and slip does not follow from this one; make the "
         "law without a hardness");
  if (std::isnan(law.conductance()))
    fail(RC_ERR_INCOMPATIBLE,
         "slip follows from laws of homogeneous half-spaces, and this one is of a layer, or of the caller's own "
         "matrix, product or kernel");
}

void check_friction(double mu, double nu, const char* of) {
  if (!(mu >= 0 && std::isfinite(mu))) fail(RC_ERR_ARGUMENT, of, ".mu = ", mu, " must be >= 0 and finite");
  if (!(nu >= 0 && nu <= 0.5)) fail(RC_ERR_ARGUMENT, of, ".nu = ", nu, " must be 0 .. 0.5");
}

}  // namespace rc

extern "C" {

rc_status rc_law_slip(const rc_law* law, const rc_law_slip_state* before, double x, const double* slip,
                      rc_law_slip_state* after) {
  if (law && slip && same_size(before) && same_size(after)) {
    const rc_status status = step(*law, *before, x, slip, *after);
    if (status >= 0) return status;
  }
  return guard("rc_law_slip", [&]() -> rc_status {
    if (!law || !slip) fail(RC_ERR_ARGUMENT, "law or slip is null");
    const SlipState from = read<SlipState>(before, "rc_law_slip_state", RC_LAW_SLIP_STATE_INIT);
    check_size(after, "rc_law_slip_state");
    SlipState to = RC_LAW_SLIP_STATE_INIT;
    const rc_status status = step(*law, from, x, slip, to);
    if (status < 0) refuse(*law, from, x, slip);
    write(after, to);
    return status;
  });
}

rc_status rc_law_slip_bounds(const rc_law* law, const rc_law_slip_state* state, double* lower, double* upper) {
  if (!law || !same_size(state) || !lower || !upper || !(memory_of(*state).layers <= most_layers))
    return guard("rc_law_slip_bounds", [&]() -> rc_status {
      if (!law || !lower || !upper) fail(RC_ERR_ARGUMENT, "law, lower or upper is null");
      check_size(state, "rc_law_slip_state");
      fail(RC_ERR_ARGUMENT, "rc_law_slip_state is none that rc_law_slip has left");
    });
  roughcontact_law_slip_bounds(law->table.data(), state->mu, state->memory, lower, upper);
  return state->joined > 0 ? RC_UNCERTIFIED : RC_OK;
}

}  // extern "C"

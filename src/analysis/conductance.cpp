#include "analysis/conductance.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string_view>

#include "core/error.h"

namespace rc {

double conductance_per_stiffness(const rc_system& system, const rc_result& answer, double rho1, double rho2) {
  if (system.op != RC_OPERATOR_HALFSPACE)
    fail(RC_ERR_ARGUMENT, "rc_system.op = ", system.op, ": only half-spaces have the contact modulus that the conductance needs");
  if (!(std::isfinite(system.modulus) && system.modulus > 0))
    fail(RC_ERR_ARGUMENT, "rc_system.modulus = ", system.modulus, " must be positive and finite (contact modulus E*)");
  if (!(std::isfinite(rho1) && std::isfinite(rho2) && rho1 >= 0 && rho2 >= 0 && (rho1 > 0 || rho2 > 0)))
    fail(RC_ERR_ARGUMENT, "rho1 = ", rho1, " and rho2 = ", rho2, " must be finite, >= 0 and not both 0");
  if (answer.homogeneous != 1)
    fail(RC_ERR_ARGUMENT, "rc_result.homogeneous = ", answer.homogeneous, ": kernel \"",
         std::string_view(answer.kernel, strnlen(answer.kernel, sizeof answer.kernel)),
         "\" is not that of a homogeneous half-space, so that no conductance follows from the stiffness; a kernel from a plugin "
         "that is sets RC_KERNEL_HOMOGENEOUS");
  // The largest resistivities have a sum beyond double precision.
  const double most = std::max(rho1, rho2);
  return 2 / system.modulus / most / (1 + std::min(rho1, rho2) / most);
}

}  // namespace rc

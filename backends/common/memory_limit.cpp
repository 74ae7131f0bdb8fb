#include "common/memory_limit.h"

#include <algorithm>
#include <string>

#include "platform/memory.h"

namespace rc_common {

namespace {

std::int64_t whole(double bytes) { return static_cast<std::int64_t>(std::min(bytes, 9e18)); }

}  // namespace

MemoryLimit::MemoryLimit(const rc_host* host, const rc_operator_spec& spec, const roughcontact::Component& component,
                         const char* key)
    : component_(component),
      key_(key),
      mebibytes_(roughcontact::option_real(host, spec.options, key)),
      machine_(rc_platform::machine_bytes()),
      limit_(std::min(mebibytes_ * 1048576.0, machine_)),
      grid_(spec.system->op == RC_OPERATOR_HALFSPACE) {}

// Grids are sent to another backend. A caller's matrix has no backend that needs less, so a solver without factors is advised.
void MemoryLimit::require(const char* what, std::int64_t unknowns, double bytes, double held) const {
  if (bytes + held <= limit_) return;
  const bool machine = bytes + held > machine_;
  const char* const elsewhere =
      grid_ ? "use a backend that stores no matrix (\"fft\")" : "use a solver that only multiplies (\"polonsky-keer\")";
  const std::string beside = held > 0.0 ? " beside the " + std::to_string(whole(held)) + " that are held" : "";
  const auto with = [&](const auto&... reason) {
    roughcontact::fail(component_, RC_ERR_MEMORY, what, " of ", unknowns, " unknowns needs ", whole(bytes), " bytes", beside,
                       ", ", reason..., elsewhere);
  };
  if (machine) with("this machine has ", whole(machine_), "; ");
  with("the limit ", key_, " is ", mebibytes_, " MiB; raise it or ");
}

}  // namespace rc_common

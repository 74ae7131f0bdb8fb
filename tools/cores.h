// The processor cores that this process may use.
#pragma once

namespace cli {

// As the affinity of the process allows, and not more than OMP_THREAD_LIMIT; at least 1.
int usable_cores();

}  // namespace cli

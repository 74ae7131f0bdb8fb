// The limit on what grows with the square of the unknowns: the matrix and the factor together.
#pragma once

#include <algorithm>
#include <cstdint>

#include "failure.h"

namespace rc_dense {

class MemoryLimit {
 public:
  explicit MemoryLimit(double mebibytes) : mebibytes_(mebibytes) {}

  // Bytes are doubles: exact where they are allowed, and no product of sizes can overflow before it is compared.
  void require(const char* what, std::int64_t unknowns, double bytes, double held) const {
    if (bytes + held <= mebibytes_ * 1048576.0) return;
    fail(RC_ERR_MEMORY, what, " of ", unknowns, " unknowns needs ", whole(bytes), " bytes (", whole(held),
         " are held already), the limit dense.memory_limit is ", mebibytes_, " MiB; raise it or use a matrix-free backend");
  }

 private:
  static std::int64_t whole(double bytes) { return static_cast<std::int64_t>(std::min(bytes, 9e18)); }

  double mebibytes_;
};

}  // namespace rc_dense

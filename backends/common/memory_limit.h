// The limit on what grows with the square of the unknowns: matrices and factors together.
#pragma once

#include <cstdint>
#include <roughcontact/plugin.hpp>

namespace rc_common {

class MemoryLimit {
 public:
  // The option `key` [MiB] and what the machine has; spec decides what the messages advise.
  MemoryLimit(const rc_host*, const rc_operator_spec&, const roughcontact::Component&, const char* key);

  // Throws unless `bytes` fit beside what is held. Bytes are doubles: exact where they are allowed, and no product of sizes can
  // overflow before it is compared.
  void require(const char* what, std::int64_t unknowns, double bytes, double held = 0.0) const;
  // [bytes]
  double limit() const { return limit_; }

 private:
  const roughcontact::Component& component_;
  const char* key_;
  double mebibytes_, machine_, limit_;
  bool grid_;
};

}  // namespace rc_common

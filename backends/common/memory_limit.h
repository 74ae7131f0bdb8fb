// The limit on what grows with the square of the unknowns: matrices and factors together.
#pragma once

#include <cstdint>
#include <roughcontact/plugin.hpp>

namespace rc_common {

class MemoryLimit {
 public:
  // The smaller of the option `key` [MiB] and the machine's memory. spec decides what the messages advise.
  MemoryLimit(const rc_host*, const rc_operator_spec&, const roughcontact::Component&, const char* key);

  // Throws unless `bytes` fit beside the bytes held. They are doubles, so that no product of sizes overflows before it is
  // compared; sizes below the limit are exact.
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

// The part that operators of stored entries have in common: products and a limit on memory.
#pragma once

#include <cstdint>
#include <roughcontact/plugin.hpp>

#include "common/memory_limit.h"
#include "common/products.h"

namespace rc_common {

class EntryOperator {
 public:
  const rc_host* host() const { return host_; }
  std::int64_t modelled() const { return products_.size(); }
  void field(const double* x, double* y) { products_.field(x, y); }
  double norm() { return products_.norm(); }

 protected:
  // memory_limit_key: the option of the limit [MiB].
  EntryOperator(const rc_host* host, const rc_operator_spec& spec, const roughcontact::Component& component,
                const char* memory_limit_key)
      : host_(host), limit_(host, spec, component, memory_limit_key), products_(host, spec, component) {}

  const rc_host* host_;
  MemoryLimit limit_;
  Products products_;
};

}  // namespace rc_common

// H as the host gives it. Coefficients that several tables need are asked for once.
#pragma once

#include <cstdint>
#include <optional>
#include <roughcontact/plugin.hpp>

#include "common/coefficients.h"
#include "failure.h"
#include "far_field.h"

namespace rc_split {

class Kernel {
 public:
  // Both must outlive it.
  Kernel(const rc_host* host, const rc_operator_spec& spec) : host_(host), spec_(spec), near_(host, spec, component) {}

  const rc_host* host() const { return host_; }
  const rc_operator_spec& spec() const { return spec_; }
  double hx() const { return spec_.system->hx; }
  double hy() const { return spec_.system->hy; }

  const FarField& far() {
    if (!far_) far_.emplace(host_, spec_);
    return *far_;
  }
  // H at offsets 0 <= ix < mx, 0 <= iy < my at least. Valid until the next call.
  const rc_common::Coefficients& near(std::int64_t mx, std::int64_t my) {
    near_.cover(mx, my);
    return near_;
  }

 private:
  const rc_host* host_;
  const rc_operator_spec& spec_;
  std::optional<FarField> far_;
  rc_common::Coefficients near_;
};

}  // namespace rc_split

// The table of the half-space's influence coefficients, which grows with what is asked for.
#pragma once

#include <algorithm>
#include <cstdint>
#include <roughcontact/plugin.hpp>
#include <vector>

namespace rc_common {

class Coefficients {
 public:
  // The host, the system and the kernel's name must outlive it.
  Coefficients(const rc_host* host, const rc_operator_spec& spec) : host_(host), system_(spec.system), kernel_(spec.kernel) {}

  // Afterwards it has at least the offsets 0 <= x < mx, 0 <= y < my.
  void cover(std::int64_t mx, std::int64_t my) {
    if (mx <= mx_ && my <= my_) return;
    mx = std::max(mx, mx_);
    my = std::max(my, my_);
    mx_ = my_ = 0;
    table_ = std::vector<double>();  // freed first, so that old and new do not exist together
    table_.resize(static_cast<std::size_t>(mx) * static_cast<std::size_t>(my));
    roughcontact::check(host_->coefficients(host_, system_, kernel_, mx, my, table_.data()));
    mx_ = mx;
    my_ = my;
  }
  const double* row(std::int64_t y) const { return table_.data() + y * mx_; }
  double operator()(std::int64_t x, std::int64_t y) const { return row(y)[x]; }

 private:
  const rc_host* host_;
  const rc_system* system_;
  const char* kernel_;
  std::int64_t mx_ = 0, my_ = 0;
  std::vector<double> table_;
};

}  // namespace rc_common

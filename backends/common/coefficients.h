// The table of the half-space's influence coefficients, which grows with what is asked for. Contacts with the same system share
// it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <roughcontact/plugin.hpp>
#include <string>
#include <vector>

namespace rc_common {

class Coefficients {
 public:
  // The host, the system, the kernel's name and the component must outlive it.
  Coefficients(const rc_host* host, const rc_operator_spec& spec, const roughcontact::Component& component)
      : host_(host), system_(spec.system), kernel_(spec.kernel), component_(component) {}

  // Afterwards it has at least the offsets 0 <= x < mx, 0 <= y < my. Of a small grid it has them all, so that contacts whose
  // points lie differently share one table.
  void cover(std::int64_t mx, std::int64_t my) {
    if (mx <= mx_ && my <= my_) return;
    const bool small = system_->nx <= small_grid / system_->ny;
    mx = std::max({mx, mx_, small ? system_->nx : 0});
    my = std::max({my, my_, small ? system_->ny : 0});
    mx_ = my_ = 0;
    table_.reset();  // freed first, so that old and new do not exist together
    const std::string key = component_.name + (" coefficients " + std::to_string(mx) + " " + std::to_string(my));
    table_ = roughcontact::shared<const Table>(host_, component_, key, [&] {
      auto table = std::make_unique<Table>(static_cast<std::size_t>(mx) * static_cast<std::size_t>(my));
      roughcontact::check(host_->coefficients(host_, system_, kernel_, mx, my, table->data()));
      return table;
    });
    values_ = table_->data();
    mx_ = mx;
    my_ = my;
  }
  const double* row(std::int64_t y) const { return values_ + y * mx_; }
  double operator()(std::int64_t x, std::int64_t y) const { return row(y)[x]; }

 private:
  using Table = std::vector<double>;
  static constexpr std::int64_t small_grid = 1 << 14;  // points

  const rc_host* host_;
  const rc_system* system_;
  const char* kernel_;
  const roughcontact::Component& component_;
  std::int64_t mx_ = 0, my_ = 0;
  std::shared_ptr<const Table> table_;
  const double* values_ = nullptr;  // of table_
};

}  // namespace rc_common

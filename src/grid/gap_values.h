// The undeformed gap at every point of a grid, in 8 or 4 bytes a point.
#pragma once

#include <roughcontact/roughcontact.h>

#include <cstddef>
#include <span>
#include <vector>

namespace rc {

class GapValues {
 public:
  GapValues() = default;
  GapValues(std::span<const double> values) : in_double_(values.data()), size_(values.size()) {}
  GapValues(std::span<const float> values) : in_single_(values.data()), size_(values.size()) {}
  // Values in memory that this process can read.
  GapValues(const rc_const_array& values, std::size_t size)
      : in_double_(values.type == RC_SINGLE ? nullptr : static_cast<const double*>(values.data)),
        in_single_(values.type == RC_SINGLE ? static_cast<const float*>(values.data) : nullptr),
        size_(size) {}
  GapValues(const std::vector<double>& values) : GapValues(std::span(values)) {}

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  // NOLINTNEXTLINE(clang-analyzer-core.NullDereference): i is below size()
  double operator[](std::size_t i) const { return in_single_ ? static_cast<double>(in_single_[i]) : in_double_[i]; }
  GapValues part(std::size_t first, std::size_t count) const {
    return in_single_ ? GapValues(std::span(in_single_ + first, count)) : GapValues(std::span(in_double_ + first, count));
  }
  // One of them is null.
  const double* in_double() const { return in_double_; }
  const float* in_single() const { return in_single_; }
  rc_const_array array() const {
    if (in_single_) return {in_single_, RC_SINGLE, 0, nullptr};
    return {in_double_, RC_NATIVE, 0, nullptr};
  }
  bool is_array_of(const GapValues& other) const { return in_double_ == other.in_double_ && in_single_ == other.in_single_; }
  // act(pointer to the first value), for loops over many points.
  template <class Act> decltype(auto) visit(Act&& act) const { return in_single_ ? act(in_single_) : act(in_double_); }

 private:
  const double* in_double_ = nullptr;
  const float* in_single_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace rc

// Aligned arrays of doubles.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>

#include "failure.h"
#include "lengths.h"

namespace rc_fft {

// Rows, lines and columns start at multiples of this many doubles, so that every array has the alignment it was planned with.
inline constexpr std::int64_t alignment = 8;

inline std::int64_t aligned(std::int64_t doubles) { return (doubles + alignment - 1) / alignment * alignment; }

class Buffer {
 public:
  // Makes room for a*b doubles; the contents are lost if it has to grow.
  void reserve(std::int64_t a, std::int64_t b, Lengths transform) {
    constexpr std::int64_t limit = PTRDIFF_MAX / static_cast<std::int64_t>(sizeof(double));
    if (a > limit / b)
      fail(RC_ERR_MEMORY, "a ", transform.x, "x", transform.y,
           " transform needs more bytes than a pointer can reach; use a coarser grid");
    if (a * b <= size_) return;
    data_.reset();
    size_ = 0;
    const std::size_t bytes = static_cast<std::size_t>(a * b) * sizeof(double);
    data_.reset(static_cast<double*>(::operator new(bytes, align, std::nothrow)));
    if (!data_)
      fail(RC_ERR_MEMORY, "cannot allocate ", bytes, " bytes for a ", transform.x, "x", transform.y,
           " transform; use a coarser grid or fewer threads");
    size_ = a * b;
  }

  double* data() const { return data_.get(); }

 private:
  static constexpr std::align_val_t align{alignment * sizeof(double)};
  struct Release {
    void operator()(double* p) const { ::operator delete(p, align); }
  };

  std::unique_ptr<double[], Release> data_;
  std::int64_t size_ = 0;
};

}  // namespace rc_fft

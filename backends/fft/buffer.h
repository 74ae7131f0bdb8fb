// Aligned memory without a type, for arrays of either precision.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>

#include "failure.h"
#include "lengths.h"
#include "platform/memory.h"

namespace rc_fft {

// Every array, row and block of columns starts at a multiple of this many bytes: two cache lines.
inline constexpr std::int64_t alignment = 128;

inline constexpr std::int64_t round_up(std::int64_t count, std::int64_t to) { return (count + to - 1) / to * to; }

struct Release {
  std::align_val_t align{alignment};
  void operator()(std::byte* p) const { ::operator delete(p, align); }
};

class Buffer {
 public:
  // Makes room for a*b elements; the contents are lost if it has to grow.
  template <class T> void reserve(std::int64_t a, std::int64_t b, Lengths transform) {
    constexpr std::int64_t limit = PTRDIFF_MAX / static_cast<std::int64_t>(sizeof(T));
    if (a > limit / b)
      fail(RC_ERR_MEMORY, "a ", transform.x, "x", transform.y,
           " transform needs more bytes than a pointer can reach; use a coarser grid");
    const std::size_t bytes = static_cast<std::size_t>(a * b) * sizeof(T);
    if (bytes <= size_) return;
    data_.reset();
    size_ = 0;
    const std::align_val_t align{bytes >= huge_page ? huge_page : std::size_t{alignment}};
    data_.get_deleter().align = align;
    data_.reset(static_cast<std::byte*>(::operator new(bytes, align, std::nothrow)));
    if (!data_)
      fail(RC_ERR_MEMORY, "cannot allocate ", bytes, " bytes for a ", transform.x, "x", transform.y,
           " transform; use a coarser grid or fewer threads");
    size_ = bytes;
    // A block of columns touches every row: with small pages each row costs an address look-up.
    if (bytes >= huge_page) rc_platform::prefer_large_pages(data_.get(), bytes);
  }

  template <class T> T* data() const { return reinterpret_cast<T*>(data_.get()); }
  std::size_t size() const { return size_; }

 private:
  static constexpr std::size_t huge_page = std::size_t{1} << 21;

  std::unique_ptr<std::byte[], Release> data_;
  std::size_t size_ = 0;
};

// Arrays that the transforms of one operator share, whatever their precision: one product runs at a time.
struct Workspace {
  Buffer rows;
  Buffer scratch;  // one part per thread
};

}  // namespace rc_fft

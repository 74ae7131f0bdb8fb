// Arrays that start at a cache line, which also suits vector instructions and FFTW's plans.
#pragma once

#include <cstddef>
#include <cstdint>
#include <new>
#include <vector>

namespace rc_split {

template <class T> struct CacheLineAllocator {
  using value_type = T;
  static constexpr std::align_val_t line{64};

  CacheLineAllocator() = default;
  template <class U> CacheLineAllocator(const CacheLineAllocator<U>&) {}

  T* allocate(std::size_t n) {
    if (n > static_cast<std::size_t>(PTRDIFF_MAX) / sizeof(T)) throw std::bad_alloc();
    return static_cast<T*>(::operator new(n * sizeof(T), line));
  }
  void deallocate(T* p, std::size_t) { ::operator delete(p, line); }
  // resize() leaves new values uninitialised.
  template <class U> void construct(U* p) { ::new (static_cast<void*>(p)) U; }
  template <class U, class... Arguments> void construct(U* p, Arguments&&... arguments) {
    ::new (static_cast<void*>(p)) U(static_cast<Arguments&&>(arguments)...);
  }
  bool operator==(const CacheLineAllocator&) const { return true; }
};

template <class T> using Array = std::vector<T, CacheLineAllocator<T>>;

// Room for n values; their contents do not matter.
template <class T> void make_room(Array<T>& array, std::int64_t n) {
  if (static_cast<std::int64_t>(array.size()) >= n) return;
  array = Array<T>();  // freed first, so that old and new do not exist together
  array.resize(static_cast<std::size_t>(n));
}

}  // namespace rc_split

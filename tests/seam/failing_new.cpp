#include "failing_new.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::int64_t> remaining{0};
std::atomic<bool> failed{false};

void* allocate(std::size_t bytes, std::size_t align) {
  if (remaining.load(std::memory_order_relaxed) > 0 && remaining.fetch_sub(1) == 1) {
    failed = true;
    return nullptr;
  }
  if (bytes > SIZE_MAX - align) return nullptr;
  // aligned_alloc wants a multiple of the alignment, and not 0.
  return std::aligned_alloc(align, std::max((bytes + align - 1) / align, std::size_t{1}) * align);
}

void* allocate_or_throw(std::size_t bytes, std::size_t align) {
  void* const memory = allocate(bytes, align);
  if (!memory) throw std::bad_alloc();
  return memory;
}

constexpr std::size_t default_align = alignof(std::max_align_t);

}  // namespace

namespace seam {

void fail_allocation(std::int64_t countdown) {
  failed = false;
  remaining = countdown;
}

bool allocation_failed() { return failed; }

}  // namespace seam

void* operator new(std::size_t bytes) { return allocate_or_throw(bytes, default_align); }
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept { return allocate(bytes, default_align); }
void* operator new(std::size_t bytes, std::align_val_t align) {
  return allocate_or_throw(bytes, static_cast<std::size_t>(align));
}
void* operator new(std::size_t bytes, std::align_val_t align, const std::nothrow_t&) noexcept {
  return allocate(bytes, static_cast<std::size_t>(align));
}

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

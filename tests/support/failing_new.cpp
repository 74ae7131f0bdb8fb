#include "support/failing_new.h"

#include <cstdlib>
#include <new>

#include "support/system.h"

namespace {

thread_local std::int64_t remaining = 0;
thread_local bool failed = false, every_later = false;
thread_local std::size_t largest = 0;

constexpr std::size_t absurd = std::size_t{1} << (sizeof(std::size_t) > 4 ? 42 : 31);

bool fails_now() {
  if (failed && every_later) return true;
  if (remaining <= 0 || --remaining > 0) return false;
  failed = true;
  return true;
}

void* counted(void* memory, std::size_t bytes) {
  if (memory && bytes > largest) largest = bytes;
  return memory;
}

void* allocated(std::size_t bytes) {
  return bytes > absurd || fails_now() ? nullptr : counted(std::malloc(bytes ? bytes : 1), bytes);
}

void* allocated(std::size_t bytes, std::align_val_t align) {
  const auto unit = static_cast<std::size_t>(align);
  return bytes > absurd || fails_now() ? nullptr
                                       : counted(support::aligned_memory(unit, (bytes + unit - 1) / unit * unit), bytes);
}

void* checked(void* memory) {
  if (!memory) throw std::bad_alloc();
  return memory;
}

}  // namespace

namespace support {

void fail_allocation(std::int64_t countdown, bool forever) {
  failed = false;
  every_later = forever;
  largest = 0;
  remaining = countdown;
}

bool allocation_failed() { return failed; }

std::size_t largest_allocation() { return largest; }

}  // namespace support

void* operator new(std::size_t bytes) { return checked(allocated(bytes)); }
void* operator new[](std::size_t bytes) { return checked(allocated(bytes)); }
void* operator new(std::size_t bytes, std::align_val_t align) { return checked(allocated(bytes, align)); }
void* operator new[](std::size_t bytes, std::align_val_t align) { return checked(allocated(bytes, align)); }
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept { return allocated(bytes); }
void* operator new[](std::size_t bytes, const std::nothrow_t&) noexcept { return allocated(bytes); }
void* operator new(std::size_t bytes, std::align_val_t align, const std::nothrow_t&) noexcept { return allocated(bytes, align); }
void* operator new[](std::size_t bytes, std::align_val_t align, const std::nothrow_t&) noexcept {
  return allocated(bytes, align);
}

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { support::free_aligned(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { support::free_aligned(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { support::free_aligned(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { support::free_aligned(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete[](void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t, const std::nothrow_t&) noexcept { support::free_aligned(memory); }
void operator delete[](void* memory, std::align_val_t, const std::nothrow_t&) noexcept { support::free_aligned(memory); }

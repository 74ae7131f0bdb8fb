#include <SuiteSparse_config.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <new>

#include "allocators.h"

namespace contract {

namespace {

// A block knows its size, for realloc.
constexpr std::size_t head = alignof(std::max_align_t);

void* allocate(std::size_t bytes) {
  char* block = static_cast<char*>(::operator new(bytes + head, std::nothrow));
  if (!block) return nullptr;
  std::memcpy(block, &bytes, sizeof bytes);
  return block + head;
}

void release(void* memory) {
  if (memory) ::operator delete(static_cast<char*>(memory) - head);
}

void* allocate_cleared(std::size_t count, std::size_t size) {
  void* memory = allocate(count * size);
  if (memory) std::memset(memory, 0, count * size);
  return memory;
}

void* reallocate(void* memory, std::size_t bytes) {
  void* larger = allocate(bytes);
  if (!larger || !memory) return larger;
  std::size_t present = 0;
  std::memcpy(&present, static_cast<char*>(memory) - head, sizeof present);
  std::memcpy(larger, memory, std::min(present, bytes));
  release(memory);
  return larger;
}

}  // namespace

void let_dependencies_use_operator_new() {
#if SUITESPARSE_MAIN_VERSION < 6
  SuiteSparse_config.malloc_func = allocate;
  SuiteSparse_config.calloc_func = allocate_cleared;
  SuiteSparse_config.realloc_func = reallocate;
  SuiteSparse_config.free_func = release;
#else
  SuiteSparse_config_malloc_func_set(allocate);
  SuiteSparse_config_calloc_func_set(allocate_cleared);
  SuiteSparse_config_realloc_func_set(reallocate);
  SuiteSparse_config_free_func_set(release);
#endif
}

}  // namespace contract

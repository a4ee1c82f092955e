// Large pages for large arrays.
//
//   std::vector<double, LargePageAllocator<double>> values(count);
//
// A processor remembers where some thousand pages of memory are. A run of a million points passes over more of the usual 4 KiB in each
// step, and would have to look them up again and again. Pages of 2 MiB are fewer; some systems give them only to who asks, and only for
// memory that was not used before: hence not std::aligned_alloc, which may give what another array had. For arrays that are used as a
// whole: the first number written to a page takes all of it.
#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>

namespace slidezone {

constexpr std::size_t large_page = 2 << 20;  // bytes

constexpr std::size_t in_large_pages(std::size_t bytes) { return (bytes + large_page - 1) / large_page * large_page; }

/// Memory from the system that begins with a large page; munmap takes in_large_pages(bytes) of it back.
inline void* map_large_pages(std::size_t bytes) {
  const std::size_t kept = in_large_pages(bytes);
  void* const mapped = mmap(nullptr, kept + large_page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (mapped == MAP_FAILED) throw std::bad_alloc();
  const std::size_t before = -reinterpret_cast<std::uintptr_t>(mapped) % large_page;
  char* const begin = static_cast<char*>(mapped) + before;
  if (before > 0) munmap(mapped, before);
  munmap(begin + kept, large_page - before);
  madvise(begin, bytes / large_page * large_page, MADV_HUGEPAGE);  // a wish: without it a run is slower, and that is all
  return begin;
}

template <class Value>
struct LargePageAllocator {
  using value_type = Value;

  LargePageAllocator() = default;
  template <class Other>
  LargePageAllocator(const LargePageAllocator<Other>&) {}

  Value* allocate(std::size_t count) {
    const std::size_t bytes = count * sizeof(Value);
    void* memory = bytes < large_page ? std::malloc(bytes) : map_large_pages(bytes);
    if (!memory) throw std::bad_alloc();
    return static_cast<Value*>(memory);
  }
  void deallocate(Value* values, std::size_t count) {
    const std::size_t bytes = count * sizeof(Value);
    if (bytes < large_page)
      std::free(values);
    else
      munmap(values, in_large_pages(bytes));
  }

  friend bool operator==(const LargePageAllocator&, const LargePageAllocator&) { return true; }
};

}  // namespace slidezone

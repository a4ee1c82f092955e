// Zeros for a large array of which a run may never reach most: what is not written takes no memory.
//
//   std::vector<double, ZeroedAllocator<double>> values(count);
//
// The system gives pages of zeros when they are first written, and a vector of this allocator does not write its first zeros itself.
// For vectors that keep the size that they are made with: one that shrinks and grows again finds old values there.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>

namespace slidezone {

template <class Value>
struct ZeroedAllocator {
  static_assert(std::is_arithmetic_v<Value>);
  using value_type = Value;

  ZeroedAllocator() = default;
  template <class Other>
  ZeroedAllocator(const ZeroedAllocator<Other>&) {}

  Value* allocate(std::size_t count) {
    void* zeros = std::calloc(count, sizeof(Value));
    if (!zeros) throw std::bad_alloc();
    return static_cast<Value*>(zeros);
  }
  void deallocate(Value* values, std::size_t) { std::free(values); }

  void construct(Value*) {}  // zero already
  template <class... Arguments>
  void construct(Value* where, Arguments&&... arguments) {
    std::construct_at(where, std::forward<Arguments>(arguments)...);
  }

  friend bool operator==(const ZeroedAllocator&, const ZeroedAllocator&) { return true; }
};

}  // namespace slidezone

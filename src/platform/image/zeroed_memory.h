// Memory for pixels that costs nothing where nobody writes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <vector>

namespace rotatebook::image {

/// Allocates numbers that are 0 without writing them: the system lends each page of zeros when it
/// is first written.
template <typename T>
struct ZeroedMemory {
  using value_type = T;

  ZeroedMemory() = default;
  template <typename Other>
  ZeroedMemory(const ZeroedMemory<Other>& /*other*/) {}

  T* allocate(std::size_t count) {
    if (void* memory = std::calloc(count, sizeof(T))) return static_cast<T*>(memory);
    throw std::bad_alloc();
  }
  void deallocate(T* memory, std::size_t /*count*/) { std::free(memory); }

  /// Leaves a number as it was allocated.
  void construct(T* /*number*/) {}
  void construct(T* number, const T& value) { *number = value; }

  friend bool operator==(const ZeroedMemory&, const ZeroedMemory&) { return true; }
};

/// Pixels, zeros at first. Its size is set once: numbers that a smaller size left out would come
/// back as they were.
using ZeroedBytes = std::vector<std::uint8_t, ZeroedMemory<std::uint8_t>>;

}  // namespace rotatebook::image

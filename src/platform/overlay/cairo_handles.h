// Owning handles of Cairo's and Pango's objects. Inside the room only.
#pragma once

#include <memory>
#include <pango/pangocairo.h>

namespace rotatebook::overlay {

template <auto kFunction>
struct Deleter {
  template <typename T>
  void operator()(T* pointer) const {
    kFunction(pointer);
  }
};

using Surface = std::unique_ptr<cairo_surface_t, Deleter<&cairo_surface_destroy>>;
using Cairo = std::unique_ptr<cairo_t, Deleter<&cairo_destroy>>;

}  // namespace rotatebook::overlay

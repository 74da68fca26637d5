#include "body/shape.h"
#include "body/shapes/shapes.h"

namespace rotatebook::body {

std::span<const Shape> allShapes() {
  static const std::vector<Shape> shapes{
#define ROTATEBOOK_SHAPE(function) shapes::function(),
#include "body/shape_list.inc"
#undef ROTATEBOOK_SHAPE
  };
  return shapes;
}

const Shape* findShape(std::string_view name) {
  for (const Shape& shape : allShapes()) {
    if (shape.name == name) return &shape;
  }
  return nullptr;
}

}  // namespace rotatebook::body

// The functions that describe the shapes, one for each row of the list. Inside the room only.
#pragma once

#include "body/shape.h"

namespace rotatebook::body::shapes {

#define ROTATEBOOK_SHAPE(function) Shape function();
#include "body/shape_list.inc"
#undef ROTATEBOOK_SHAPE

}  // namespace rotatebook::body::shapes

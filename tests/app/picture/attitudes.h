// A check that a book is seen whole, however it is turned.
#pragma once

#include "picture/looks.h"
#include "scene/scene.h"

namespace rotatebook::picture::testing {

/// Returns whether any book on `screen` comes within `margin` pixels of its border, in attitudes
/// all round, each with a corner turned toward one of many directions.
bool anyAttitudeTouchesBorder(const scene::Scene& scene, const geometry::Screen& screen,
                              int margin);

}  // namespace rotatebook::picture::testing

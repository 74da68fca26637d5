// The room that the legend of forces takes. Inside the room only.
#pragma once

namespace rotatebook::overlay {

/// The height of the legend of the overlay "forces". [small letters]
inline constexpr double kForcesLegend = 6.4;

}  // namespace rotatebook::overlay

// The room that the legend of forces takes. Inside the room only.
#pragma once

namespace rotatebook::overlay {

/// The height of the legend of the overlay "forces", and of its scale alone. [small letters]
inline constexpr double kForcesLegend = 6.4, kForcesScale = 1.28;

}  // namespace rotatebook::overlay

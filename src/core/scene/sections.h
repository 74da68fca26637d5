// The sections of a scene file, and what is checked of several keys together.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "scene/keys/section.h"
#include "scene/scene.h"
#include "scene/value_reader.h"

namespace rotatebook::scene {

// Longest texts. [letters]
inline constexpr std::size_t kLongestTitle = 200;
inline constexpr std::size_t kLongestCaption = 1000;
inline constexpr std::size_t kLongestLabel = 100;  ///< Of a panel; a part of a file's name.
inline constexpr std::size_t kLongestName = 100;   ///< Of a font or an integrator.
inline constexpr std::size_t kLongestPath = 1000;  ///< Of a texture.

/// Most integration steps from a frame to the next.
inline constexpr int kMaxSubsteps = 1'000'000;
/// Most integration steps that a scene, or its study, takes in all: some hours of computing.
inline constexpr std::int64_t kMaxSteps = 10'000'000'000;

/// Those of a motion, in the order of messages: [body], [simulation], [initial] and, last,
/// [expect]. Left to the caller are the default of time_per_frame, which depends on [clip], its
/// line, as panels share it, and whether there is a spin at all.
std::span<const Section<Motion>> motionSections();
/// Those of how a scene shows its motions. Left to the caller is the default of camera.position,
/// which depends on [body] and [clip].
std::span<const Section<Scene>> pictureSections();

/// The line of simulation.time_per_frame.
std::string timePerFrameLine(const physics::SimulationSettings& settings);

/// Refuses [initial] without a spin.
void requireSpin(const ValueReader& section);
/// Refuses an integrator that the model doesn't have; `section` is [simulation].
void checkIntegrator(const ValueReader& section, const physics::SimulationSettings& settings);
/// Refuses an inertia for a model that has its own; `section` is [body].
void checkInertia(const ValueReader& section, physics::Model model);
/// Refuses an overlay that none of the scene's motions has; `section` is [overlay].
void checkOverlays(const ValueReader& section, const Scene& scene);
/// Refuses moments of motion blur that aren't at the ends of integration steps; `section` is
/// [look].
void checkMotionBlur(const ValueReader& section, const Scene& scene);
/// Refuses a scene, read as a whole, that takes more than kMaxSteps; `file` is its whole, too.
void checkSteps(const ValueReader& file, const Scene& scene);
/// Refuses a complete camera that looks nowhere or has no upper side; `section` is where it came
/// from.
void checkCamera(const ValueReader& section, const CameraSettings& camera);

}  // namespace rotatebook::scene

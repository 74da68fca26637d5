// The sections of a scene file: every key and its limits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

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
inline constexpr int kMostSubsteps = 1'000'000;
/// Most integration steps that a scene, or its study, takes in all: some hours of computing.
inline constexpr std::int64_t kMostSteps = 10'000'000'000;

// Each reads one section over the defaults in its second argument. Throws InputError.

void readBody(const ValueReader& section, physics::Cuboid& body,
              std::optional<Eigen::Matrix3d>& inertia);
/// Leaves the default of time_per_frame, which depends on [clip], to the caller.
void readSimulation(const ValueReader& section, physics::SimulationSettings& settings);
/// Leaves it to the caller whether there is a spin at all.
void readInitial(const ValueReader& section, physics::InitialSpin& spin);
void readExpectations(const ValueReader& section, std::vector<Expectation>& expectations);

void readClip(const ValueReader& section, ClipSettings& clip);
void readVideo(const ValueReader& section, EncodingSettings& video);
/// Leaves the default of position, which depends on [body] and [clip], to the caller.
void readCamera(const ValueReader& section, CameraSettings& camera);
void readBook(const ValueReader& section, BookSettings& book);
void readLook(const ValueReader& section, LookSettings& look);
void readOverlay(const ValueReader& section, OverlaySettings& overlay);

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
/// Refuses a scene, read as a whole, that takes more than kMostSteps; `file` is its whole, too.
void checkSteps(const ValueReader& file, const Scene& scene);
/// Refuses a complete camera that looks nowhere or has no upper side; `section` is where it came
/// from.
void checkCamera(const ValueReader& section, const CameraSettings& camera);

}  // namespace rotatebook::scene

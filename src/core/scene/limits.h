// Limits of what scenes state. Inside the room only.
#pragma once

#include <cstddef>
#include <cstdint>

namespace rotatebook::scene {

// Longest strings. [characters]
inline constexpr std::size_t kLongestTitle = 200;
inline constexpr std::size_t kLongestCaption = 1000;
inline constexpr std::size_t kLongestChapter = 60;
inline constexpr std::size_t kLongestLabel = 100;  ///< Label of a panel; part of a file's name.
inline constexpr std::size_t kLongestName = 100;   ///< Name of a font or an integrator.
inline constexpr std::size_t kLongestPath = 1000;  ///< Path of a texture.

/// Most samples of a motion, which take some 400 MB.
inline constexpr int kMaxFrames = 1'000'000;

inline constexpr std::size_t kMaxCues = 100;

inline constexpr std::size_t kMinPanels = 2;
inline constexpr std::size_t kMaxPanels = 6;
/// Most samples of all books of a grid.
inline constexpr std::int64_t kMaxGridSamples = 6 * kMaxFrames;

/// Most runs of a study, and most quantities that it measures.
inline constexpr std::size_t kMaxRuns = 1000;
inline constexpr std::size_t kMaxMeasures = 3;

/// The time that simulation.substeps divide unless time_per_frame is stated. [s]
inline constexpr double kSubstepped = 1.0 / 60;
/// Most integration steps in it.
inline constexpr int kMaxSubsteps = 1'000'000;
/// Most integration steps that a scene, or its study, takes in all: some hours of computing.
inline constexpr std::int64_t kMaxSteps = 10'000'000'000;
/// Most integration steps in which an event is found that a cue or a speed names: whoever reads a
/// scene, such as `list`, waits for them. The scenes that ship take at most 90'000.
inline constexpr std::int64_t kMaxStepsToEvent = 5'000'000;

}  // namespace rotatebook::scene

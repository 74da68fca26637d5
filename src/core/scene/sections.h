// The sections of a scene file, and the checks that involve several keys. Inside the room only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/document/overrides.h"
#include "base/document/value_reader.h"
#include "scene/body_section.h"
#include "scene/keys/section.h"
#include "scene/limits.h"
#include "scene/names.h"
#include "scene/scene.h"

namespace rotatebook::scene {

/// The keys of which a motion has only one, so that a closer value replaces the others.
inline constexpr std::array<document::Alternatives, 2> kMotionAlternatives{
    {{"initial", kSpinKeys}, {"simulation", kStepKeys}}};

/// Returns the sections of a motion, in the order of messages: [body], [simulation], [initial],
/// [[nudge]] and, last, [expect]. Left to the caller are the default of time_per_frame, which
/// depends on [clip]; its line, as panels share it; and whether there is a spin at all.
std::span<const Section<Motion>> motionSections();
/// Returns the sections about how a scene shows its motions. Left to the caller is the default of
/// camera.position, which depends on [body] and [clip].
std::span<const Section<Spec>> pictureSections();
/// Returns [[cue]], one of these.
Section<Spec> cueSection();

/// Returns the line of simulation.time_per_frame.
std::string timePerFrameLine(const physics::SimulationSettings& settings, const Printed& printed);

/// Reads `panels`, [[panel]], the motions that a clip shows side by side. What a panel leaves out
/// is taken from the sections of `file`, the whole scene file, or else from the defaults. Throws
/// InputError.
std::vector<Panel> readPanels(const ValueReader& panels, const ValueReader& file);

/// Reads `section`, [grid] of `file`. Throws InputError, also if its books have too many samples
/// in `clip`.
GridSettings readGrid(const ValueReader& section, const ValueReader& file,
                      const ClipSettings& clip);
/// Reads the motions of the cells of the grid of `file`, row by row. Throws InputError.
std::vector<Panel> readCells(const ValueReader& file, const Spec& spec);
/// Throws InputError if the scene's grid varies what none of its motions has.
void checkCells(const Scene& scene);
/// Returns [grid] as TOML; empty for a scene without one.
std::string gridText(const Spec& spec, const Printed& printed);

/// Reads `section`, [study] of `file`, of a scene that is read but for it. A section without a
/// measure is of the orders of all the model's integrators. Throws InputError.
StudySettings readStudy(const ValueReader& section, const ValueReader& file, const Spec& spec);
/// Reads the motions of the runs of the study of `file`. Throws InputError.
std::vector<StudyRun> readRuns(const ValueReader& file, const Spec& spec);
/// Throws InputError if the runs of the scene's study don't take what it varies or measures, or
/// have too many samples, or too few.
void checkRuns(const Scene& scene);
/// Returns [study] as TOML; empty for a scene without a study.
std::string studyText(const Spec& spec, const Printed& printed);

/// Reads `section`, [map], of a scene with these motions. Throws InputError.
MapSettings readMap(const ValueReader& section, const std::vector<Panel>& motions);
/// Throws InputError if the scene's motions don't take what its map varies or measures.
void checkMap(const Scene& scene);
/// Returns [map] as TOML; empty for a scene without a map.
std::string mapText(const Spec& spec, const Printed& printed);

/// Throws InputError if `section`, [initial], has no spin.
void requireSpin(const ValueReader& section);
/// Checks across its sections the motion of a scene without panels; `file` has all of them. Throws
/// InputError.
void checkMotion(const ValueReader& file, const physics::SimulationSettings& settings);
/// Throws InputError if a motion of Model::Recorded names no file, or states a start; `motion` has
/// all of its sections, `own` those that it doesn't share with others.
void checkRecorded(const ValueReader& motion, const ValueReader& own,
                   const physics::SimulationSettings& settings);
/// Throws InputError if `section`, [simulation], states an integrator that the model doesn't have.
void checkIntegrator(const ValueReader& section, const physics::SimulationSettings& settings);
/// Throws InputError if `section`, [simulation], states a dissipation that the model or its
/// integrator doesn't take.
void checkDissipation(const ValueReader& section, const physics::SimulationSettings& settings);
/// Throws InputError if an overlay is listed that none of the scene's motions has.
void checkOverlays(const Scene& scene);
/// Throws InputError if the scene takes more than kMaxSteps.
void checkSteps(const Scene& scene);
/// Throws InputError if the camera has no direction of view, or one parallel to `up`.
void checkCamera(const Scene& scene);
/// Throws DocumentError if a cue's move leads the camera to where it has no direction of view, or
/// one parallel to `up`.
void checkMoves(const Scene& scene);

}  // namespace rotatebook::scene

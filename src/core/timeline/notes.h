// Notes on scenes that are valid, but perhaps not meant.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "physics/trajectory.h"
#include "scene/scene.h"

namespace rotatebook::timeline {

/// Returns a sentence for all that reading its body's mesh has changed or left out, and for each
/// setting of `panel` that is likely a slip: a tilt that looks like
/// degrees, a body that looks like centimetres, a spin or flips too fast for the frame rate, and a
/// spin exactly about a principal axis, which never tumbles; about a stable one only without a
/// label, as in a comparison it is one of the cases.
std::vector<std::string> notesOn(const scene::Panel& panel);

/// Returns those on all motions of `scene`, and on nudges and a poster after the clip's end; one of
/// a panel begins with the panel's label.
std::vector<std::string> notesOn(const scene::Scene& scene);

/// Returns a sentence with the time at which the motion's regime first changes, which no free
/// body's does from one nudge to the next; empty if it never does.
std::string regimeNote(const physics::Trajectory& trajectory,
                       std::span<const physics::Nudge> nudges);

}  // namespace rotatebook::timeline

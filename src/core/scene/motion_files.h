// The files that a scene's motions follow from.
#pragma once

#include "scene/read_named_file.h"
#include "scene/scene.h"

namespace rotatebook::scene {

/// Reads the recordings of all motions of Model::Recorded, those of a study's runs, too: sets their
/// motion, checksum and start. Throws InputError at the location of simulation.file: for a file
/// that `readNamedFile` or recording::readRecording() refuses, that has another checksum than
/// stated, that begins at rest, or that is shorter than the clip. Reads the meshes of particles
/// that lack their surface, and throws InputError as placeInMesh() does.
void readMotionFiles(Scene& scene, const ReadNamedFile& readNamedFile);

/// Gives the meshes of the motions their content, which those of a printed scene lack. Throws
/// InputError at the bodies' location as takeMeshFile() does, and if `readNamedFile` refuses a
/// file.
void readMeshFiles(Scene& scene, const ReadNamedFile& readNamedFile);

}  // namespace rotatebook::scene

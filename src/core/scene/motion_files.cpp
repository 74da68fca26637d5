#include "scene/motion_files.h"

#include <filesystem>
#include <memory>
#include <string>

#include "base/checksum.h"
#include "base/document/toml_tree.h"
#include "base/error.h"
#include "base/number_text.h"
#include "base/text.h"
#include "physics/recorded_start.h"
#include "recording/csv_table.h"
#include "recording/read_recording.h"
#include "scene/body_section.h"
#include "scene/placed_particles.h"
#include "scene/solid_numbers.h"
#include "scene/solid_particles.h"
#include "scene/source_locations.h"

namespace rotatebook::scene {
namespace {

void checkChecksum(const physics::RecordedFile& recorded, const std::string& checksum) {
  if (recorded.checksum.empty() || recorded.checksum == checksum) return;
  throw InputError("the file " + quotedText(recorded.file) + " has changed: its checksum is " +
                   checksum + ", not " + recorded.checksum +
                   "; bring the file back, or leave simulation.checksum out");
}

void readRecording(physics::MotionSettings& motion, const std::filesystem::path& folder,
                   const ReadNamedFile& readNamedFile) {
  physics::RecordedFile& recorded = motion.simulation.recorded;
  const std::string bytes = readNamedFile(recorded.file, recording::kLargestRecording);
  const std::string checksum = checksumOf(bytes);
  checkChecksum(recorded, checksum);
  recorded.checksum = checksum;
  const std::string name = oneLine((folder / recorded.file).string());
  takeRecording(motion,
                std::make_shared<recording::RecordedMotion>(recording::readRecording(
                    bytes, name,
                    {recorded.columns, recorded.rates, recorded.timeUnit, recorded.ratesAlong,
                     recorded.from, recorded.to, recorded.bias})),
                name);
}

void checkDuration(const physics::MotionSettings& motion, double length) {
  constexpr double kRounding = 1e-9;
  const double duration = motion.simulation.recorded.motion->duration();
  if (length <= duration * (1 + kRounding)) return;
  throw InputError("the recording " + quotedText(motion.simulation.recorded.file) + " lasts " +
                   roundedText(duration, 6) + " s, but the clip shows " + roundedText(length, 6) +
                   " s of it; lower clip.duration or clip.speed");
}

/// Reads the recording that a motion is taken from, if it is; the clip shows `length` of it. [s]
void readIfRecorded(physics::MotionSettings& motion, const Scene& scene,
                    const std::string& location, double length,
                    const ReadNamedFile& readNamedFile) {
  if (motion.simulation.model != physics::Model::Recorded) return;
  try {
    readRecording(motion, scene.folder, readNamedFile);
    checkDuration(motion, length);
  } catch (const InputError& error) {
    document::failAt(location, error.what());
  }
}

}  // namespace

void readMotionFiles(Scene& scene, const ReadNamedFile& readNamedFile) {
  const double length = timeAt(scene, static_cast<double>(scene.clip.frameCount() - 1));
  const std::string location = locationOf(scene, "simulation.file");
  for (std::size_t i = 0; i < scene.motions.size(); ++i) {
    const bool isOwn = scene.locations.contains(recordingKey(i));
    Panel& motion = scene.motions[i];
    readIfRecorded(motion, scene, isOwn ? locationOf(scene, recordingKey(i)) : location, length,
                   readNamedFile);
    if (lacksSurface(motion)) placeInMesh(motion, readNamedFile);
  }
  for (StudyRun& run : scene.runs) {
    readIfRecorded(run.motion, scene, location, 0, readNamedFile);
  }
}

void readMeshFiles(Scene& scene, const ReadNamedFile& readNamedFile) {
  MeshFiles read;
  for (Panel& panel : scene.motions) {
    MeshFile& mesh = panel.solid.mesh;
    takeContent(read, mesh);
    if (mesh.name.empty() || mesh.content != nullptr) continue;
    atLocationOf(scene, scene.hasPanels() ? "panel" : "body",
                 [&] { takeMeshFile(readNamedFile(mesh.name, kLongestMesh), mesh); });
    read.try_emplace(mesh.name, mesh);
  }
}

}  // namespace rotatebook::scene

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
#include "scene/schedule.h"
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

/// Does `work` for the recording that a motion is taken from, if it is; its problems are at
/// `location`.
template <typename Work>
void ifRecorded(const physics::MotionSettings& motion, const std::string& location,
                const Work& work) {
  if (motion.simulation.model != physics::Model::Recorded) return;
  try {
    work();
  } catch (const InputError& error) {
    document::failAt(location, error.what());
  }
}

/// Returns the location of the file of motion `index`.
std::string locationOfFile(const Scene& scene, std::size_t index) {
  const bool isOwn = scene.locations.byKey.contains(recordingKey(index));
  return locationOf(scene, isOwn ? recordingKey(index) : "simulation.file");
}

}  // namespace

void readMotionFiles(Scene& scene, const ReadNamedFile& readNamedFile) {
  for (std::size_t i = 0; i < scene.motions.size(); ++i) {
    Panel& motion = scene.motions[i];
    ifRecorded(motion, locationOfFile(scene, i),
               [&] { readRecording(motion, scene.folder, readNamedFile); });
    if (lacksSurface(motion)) placeInMesh(motion, readNamedFile);
  }
  for (StudyRun& run : scene.runs) {
    ifRecorded(run.motion, locationOf(scene, "simulation.file"),
               [&] { readRecording(run.motion, scene.folder, readNamedFile); });
  }
  schedule(scene);
  const double length = timeAt(scene, static_cast<double>(scene.clip.frameCount() - 1));
  for (std::size_t i = 0; i < scene.motions.size(); ++i) {
    ifRecorded(scene.motions[i], locationOfFile(scene, i),
               [&] { checkDuration(scene.motions[i], length); });
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

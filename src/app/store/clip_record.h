// What a clip says it was made from and with.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "store/clip_files.h"
#include "timeline/clip_motion.h"
#include "video/clip_reader.h"

namespace rotatebook::store {

/// What a clip was made with. As read from a record, each but `scene` may be empty.
struct Provenance {
  std::string scene{};     ///< Its name.
  std::string program{};   ///< "0.1.0"
  std::string renderer{};  ///< render::Renderer::description()
  std::string ffmpeg{};    ///< "5.1.6"
  std::string motion{};    ///< motionChecksum()
  std::string textures{};  ///< "book.front CHECKSUM, ..." of those that aren't built in.
};

/// That of a clip of `scene`, which moves as `motion`, made here and now with `renderer` of
/// `textures`, as picture::LoadedTextures::checksums has them.
Provenance provenanceOf(const scene::Scene& scene, const timeline::ClipMotion& motion,
                        const std::map<std::string, std::string>& textures,
                        const std::string& renderer);

/// Where tools and textures differ: "the renderer was A, here it is B". The motions aren't
/// compared, nor textures of which there is no record.
std::vector<std::string> differencesOfTools(const Provenance& there, const Provenance& here);

/// The scene with every default explicit, headed by comments that tell `provenance`. It is stored
/// beside the frames and in the videos that can hold it, so that a clip says what it was made from.
std::string sceneRecord(const scene::Scene& scene, const Provenance& provenance);
/// `record` for a clip of some of the frames. A text that isn't a record comes back as it is.
std::string recordOfPart(const std::string& record, FrameRange part);

/// A record that was read.
struct ClipRecord {
  Provenance provenance;
  std::optional<FrameRange> part{};  ///< The clip's frames, if they aren't all. first < end.
  scene::Scene scene;
};

/// Takes the record of `clip`, which names it in messages, apart. The scene's textures are found
/// from `sceneFolder`. Throws InputError for a text that isn't a record, or a damaged one: anybody
/// may have written it.
ClipRecord parseRecord(const std::string& text, const std::filesystem::path& clip,
                       const std::filesystem::path& sceneFolder);

/// Whether `text` is the record of a clip of `scene`, or of a part of one; tools may differ.
bool isRecordOf(const scene::Scene& scene, const std::string& text);

/// The same of the whole clip alone. What is expected of it, and its study, may differ: no picture
/// depends on these.
bool isRecordOfClip(const scene::Scene& scene, const std::string& text);

/// A clip's format and its record.
struct RecordedClip {
  video::VideoFormat format = video::VideoFormat::Mp4;
  ClipRecord record;
};

/// Where the textures of a recorded scene are.
struct TextureLookup {
  std::filesystem::path folder{};  ///< The scene's; empty: the clip's.
  bool allowOutside = false;       ///< scene::Scene::allowOutside
};

/// Reads the record of an MP4 or WebM. Throws InputError as video::readClipMetadata() and
/// parseRecord() do, and for a texture that can't be read, naming --scene-folder where it is
/// missing.
RecordedClip readRecordedClip(const std::filesystem::path& clip, const TextureLookup& textures);

}  // namespace rotatebook::store

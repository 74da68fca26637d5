// Records of clips: the scene and the programs that each was made from, stored in the clip.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "store/clip_files.h"
#include "video/clip_reader.h"

namespace rotatebook::store {

/// The provenance of a clip. When read from a record, every field but `scene` may be empty.
struct Provenance {
  std::string scene{};     ///< The scene's name.
  std::string program{};   ///< "0.1.0"
  std::string renderer{};  ///< render::Renderer::description()
  std::string ffmpeg{};    ///< "5.1.6"; empty of frames alone.
  std::string motion{};    ///< motionChecksum()
  std::string textures{};  ///< "book.front CHECKSUM, ..."; built-in ones are left out.

  /// Returns whether it says that the pictures are a browser's, as the live book saves them.
  bool isOfBrowser() const;
};

/// Returns the provenance of a clip of `scene` that this program makes on this machine: `motionSum`
/// is timeline::motionChecksum(), `textures` are picture::LoadedTextures::checksums, `renderer` is
/// render::Renderer::description(), `ffmpeg` is video::ffmpegVersion() if videos are made.
Provenance provenanceOf(const scene::Scene& scene, const std::string& motionSum,
                        const std::map<std::string, std::string>& textures,
                        const std::string& renderer, const std::string& ffmpeg);

/// Returns the differences in tools and textures: "the renderer was A, here it is B". Motions
/// aren't compared, nor textures that weren't recorded.
std::vector<std::string> differencesOfTools(const Provenance& there, const Provenance& here);

/// Returns the scene's text with every default explicit, below comments that state `provenance`. It
/// is stored beside the frames and in every video whose format has metadata.
std::string sceneRecord(const scene::Scene& scene, const Provenance& provenance);
/// Returns `record` with a line that names the frames of `part`. Text that isn't a record is
/// returned unchanged.
std::string recordOfPart(const std::string& record, FrameRange part);
/// Returns the `record` of frames with the version of the FFmpeg that makes a video of them, unless
/// it has one. Text that isn't a record is returned unchanged.
std::string recordOfVideo(const std::string& record, const std::string& ffmpeg);

/// Returns the record in a video; empty if there is none, or it is no clip.
std::string recordIn(const std::filesystem::path& video);

/// Returns whether `text` begins as every record does.
bool looksLikeRecord(const std::string& text);

/// A record as read from a clip.
struct ClipRecord {
  Provenance provenance;
  std::optional<FrameRange> part{};  ///< The clip's frames, first < end; empty if it has all.
  scene::Scene scene;
};

/// Parses the record `text`. `clip` names the file in messages; the scene's textures are relative
/// to `sceneFolder`. Throws InputError if `text` isn't a record or is damaged: it is untrusted
/// input.
ClipRecord parseRecord(const std::string& text, const std::filesystem::path& clip,
                       const std::filesystem::path& sceneFolder);

/// Returns whether `text`, which `record` was parsed from, is as this version writes it, with
/// nothing else in it; true of other versions' records, whose texts may differ.
bool isPlainRecord(const ClipRecord& record, const std::string& text);

/// Returns whether `text` is the record of a clip of `scene`, whole or in part; tools may differ.
bool isRecordOf(const scene::Scene& scene, const std::string& text);

/// Like isRecordOf(), for the whole clip alone. Expectations and the study may differ, too: no
/// picture depends on them.
bool isRecordOfClip(const scene::Scene& scene, const std::string& text);

/// A clip's format, its record, and its scene's textures.
struct RecordedClip {
  video::VideoFormat format = video::VideoFormat::Mp4;
  ClipRecord record;
  std::map<std::string, std::string> textures{};  ///< picture::TextureFiles
  std::string text{};                             ///< The record's.
};

/// The location of a recorded scene's textures.
struct TextureLookup {
  std::filesystem::path folder{};  ///< The scene's folder; if empty, one near the clip.
  bool allowOutside = false;       ///< scene::Scene::allowOutside
};

/// Reads the record of an MP4 or WebM. Throws InputError where video::readClipMetadata() and
/// parseRecord() do, and for a texture or a recording that can't be read; the message names
/// --scene-folder if one is missing.
RecordedClip readRecordedClip(const std::filesystem::path& clip, const TextureLookup& textures);

}  // namespace rotatebook::store

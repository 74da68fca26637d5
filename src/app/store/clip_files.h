// Names and paths of the files that a clip leaves on the disk.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "video/video_format.h"

namespace rotatebook::store {

/// Frames from `first` up to but not including `end`.
struct FrameRange {
  std::int64_t first = 0;
  std::int64_t end = 0;

  std::int64_t count() const { return end - first; }
  friend bool operator==(const FrameRange&, const FrameRange&) = default;
};

/// Returns "3:5".
std::string rangeText(FrameRange range);
/// Parses "3:5"; returns nothing for other text. The range may be empty or reversed.
std::optional<FrameRange> parseRange(const std::string& text);

/// One of several parts of a clip, which together have each of its frames once.
struct ClipPart {
  std::int64_t number = 1;  ///< 1 to `count`
  std::int64_t count = 1;   ///< 1 to kMaxParts
};
inline constexpr std::int64_t kMaxParts = 999'999;

/// Parses "3/16", the third of 16 parts; returns nothing for other text.
std::optional<ClipPart> parsePart(const std::string& text);
/// Returns the frames of a part of a clip of `frames` frames. Parts differ by at most one frame;
/// some are empty if there are more parts than frames.
FrameRange framesOf(const ClipPart& part, std::int64_t frames);

/// The name of the resolved scene's file, beside the frames.
inline constexpr const char* kSceneCopyName = "scene.toml";

/// The names of the manifest and of the frames' checksums, beside the frames. The manifest isn't
/// .toml, which is for scenes.
inline constexpr const char* kManifestName = "frames.manifest";
inline constexpr const char* kFrameChecksumsName = "frames.xxh128";

/// Returns "frames.PROCESS.xxh128", the checksums of the frames that one process of several drew.
std::string partChecksumsName(const std::string& process);
/// Returns the names in `folder` that partChecksumsName() gives, ascending. Returns none if it
/// can't be read.
std::vector<std::string> partChecksumsIn(const std::filesystem::path& folder);

/// Returns "frame_00042.png".
std::string frameName(std::int64_t index);

/// Returns the index of the frame whose file is named `name`; nothing if it isn't a frame's name.
std::optional<std::int64_t> frameIndex(const std::string& name);

/// Returns the indices of the frames in `folder`, ascending. Throws InputError if it can't be read.
std::vector<std::int64_t> framesIn(const std::filesystem::path& folder);

/// Returns whether `folder` exists and holds frames. Throws InputError if it can't be read.
bool hasFrames(const std::filesystem::path& folder);

/// Endings that a render appends to a clip's name while it runs; no scene's name may end in one.
inline constexpr const char* kPartialEnding = ".partial";
inline constexpr const char* kReplacedEnding = ".replaced";

/// Paths of a scene's outputs, all below one folder.
struct ClipFiles {
  std::filesystem::path frameFolder;         ///< NAME/, which holds the PNGs
  std::filesystem::path partialFrameFolder;  ///< NAME.partial/, while the PNGs are made
  std::filesystem::path replacedFolder;      ///< NAME.replaced/, an earlier NAME/ being replaced
  std::filesystem::path sceneCopy;           ///< NAME/scene.toml, the resolved scene
  std::filesystem::path videoStem;           ///< NAME, to which video() appends an ending
  std::filesystem::path csv;                 ///< NAME.csv, or empty; see csvFiles() for panels
  std::filesystem::path json;                ///< NAME.json, timeline::clipJson(); empty without csv
  std::filesystem::path captions;            ///< NAME.vtt, timeline::webVtt(); empty for a part
  std::filesystem::path poster;              ///< NAME.poster.png; empty for a part
  std::filesystem::path thumbnail;           ///< NAME.thumbnail.png

  /// Returns NAME.mp4, NAME.webm and so on.
  std::filesystem::path video(video::VideoFormat format) const;
  /// Returns NAME.partial.mp4 and so on, the video of an interrupted render.
  std::filesystem::path partialVideo(video::VideoFormat format) const;
};

/// Returns the paths of the clip `name` in `folder`.
ClipFiles clipFiles(const std::filesystem::path& folder, const std::string& name);
/// Like clipFiles() above, for the frames `part` alone, whose videos must not replace the whole
/// clip's: NAME_00010-00020.mp4.
ClipFiles clipFiles(const std::filesystem::path& folder, const std::string& name, FrameRange part);

/// Likewise for a part that leaves frames alone: without a name of a table, either.
ClipFiles clipFiles(const std::filesystem::path& folder, const std::string& name,
                    const ClipPart& part);

/// Returns the paths of the motions' tables, in the order of timeline::writeTable(): `csv` itself,
/// or one for each panel, with its label in a name that no other panel has: NAME_particles.csv. A
/// grid has `csv` alone. None if `csv` is empty.
std::vector<std::filesystem::path> csvFiles(const std::filesystem::path& csv,
                                            const scene::Scene& scene);

/// Returns the files that a render of `scene` leaves beside the frames: the tables, the videos and,
/// of a whole clip, the poster and, if it has cues, the captions.
std::vector<std::filesystem::path> outputFiles(const ClipFiles& files, const scene::Scene& scene,
                                               const std::vector<video::VideoFormat>& formats);

/// Returns whether the program owns the name `name` in a folder of frames: that of a frame, of the
/// record, the manifest or checksums.
bool isNameInFrameFolder(const std::string& name);

}  // namespace rotatebook::store

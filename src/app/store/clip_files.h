// Names and contents of what a clip leaves on the disk.
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

/// "3:5"
std::string rangeText(FrameRange range);
/// The range that `text` is; nothing if it isn't written so. It may be empty or the wrong way
/// round.
std::optional<FrameRange> parseRange(const std::string& text);

/// The resolved scene beside the frames.
inline constexpr const char* kSceneCopyName = "scene.toml";

/// "frame_00042.png"
std::string frameName(std::int64_t index);

/// The frame that a file's name is of, if it is a frame's.
std::optional<std::int64_t> frameIndex(const std::string& name);

/// Indices of the frames in `folder`, ascending. Throws InputError if there is no such folder.
std::vector<std::int64_t> framesIn(const std::filesystem::path& folder);

/// What a render puts after a clip's name while it goes on; no scene's name may end so.
inline constexpr const char* kPartialEnding = ".partial";
inline constexpr const char* kReplacedEnding = ".replaced";

/// Where a scene's outputs go, below one folder.
struct ClipFiles {
  std::filesystem::path frameFolder;         ///< NAME/, with the PNGs
  std::filesystem::path partialFrameFolder;  ///< NAME.partial/, while they are made
  std::filesystem::path replacedFolder;      ///< NAME.replaced/, of an earlier render, for a moment
  std::filesystem::path sceneCopy;           ///< NAME/scene.toml, the resolved scene
  std::filesystem::path videoStem;           ///< NAME, to which video() puts an ending
  std::filesystem::path csv;                 ///< NAME.csv; of panels see csvFiles()
  std::filesystem::path poster;              ///< NAME.poster.png
  std::filesystem::path thumbnail;           ///< NAME.thumbnail.png

  /// NAME.mp4, NAME.webm and so on.
  std::filesystem::path video(video::VideoFormat format) const;
  /// NAME.partial.mp4 and so on, where a run was interrupted.
  std::filesystem::path partialVideo(video::VideoFormat format) const;
};

/// The files of the clip `name` in `folder`.
ClipFiles clipFiles(const std::filesystem::path& folder, const std::string& name);
/// The same for some of its frames, whose videos must not replace the whole clip's:
/// NAME_00010-00020.mp4.
ClipFiles clipFiles(const std::filesystem::path& folder, const std::string& name, FrameRange part);

/// The tables of the scene's motions, in the order of motionsOf(): `csv` itself, or for each panel
/// one that is named after its label, too, each unlike the others: NAME_particles.csv.
std::vector<std::filesystem::path> csvFiles(const std::filesystem::path& csv,
                                            const scene::Scene& scene);

}  // namespace rotatebook::store

// Names that commands write, move or remove.
#pragma once

#include <compare>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <sys/types.h>
#include <vector>

#include "scene/scene.h"
#include "store/clip_files.h"
#include "store/map_files.h"
#include "store/study_files.h"
#include "video/video_format.h"

namespace rotatebook::store {

/// All names that a command writes, moves or removes: none of them may be a file that it reads.
/// Files are told apart by their identity on the disk, not by their paths, which may hold links.
class Footprint {
 public:
  /// Adds a file that is written or removed, whether it exists or not, and the temporary names in
  /// its folder.
  void addFile(const std::filesystem::path& file);
  /// Adds a render of the whole clip of `scene` into `folder`, with or without frames.
  void addClip(const std::filesystem::path& folder, const scene::Scene& scene,
               const std::vector<video::VideoFormat>& formats);
  /// Adds a render of the frames `part` alone, with PNGs if `png`.
  void addPart(const std::filesystem::path& folder, const scene::Scene& scene, FrameRange part,
               const std::vector<video::VideoFormat>& formats, bool png);
  /// Adds a render of some frames of `scene` that leaves nothing else.
  void addFrames(const std::filesystem::path& folder, const scene::Scene& scene);
  /// Adds the files of a study.
  void addStudy(const StudyFiles& files);
  /// Adds the files of a map.
  void addMap(const MapFiles& files);

  /// Adds a folder of which no file need stay where it is.
  void addWholeFolder(const std::filesystem::path& folder);

  /// Returns what becomes of the file at `path`, or of a link on the way to it: "replaced",
  /// "removed" or "moved or removed"; nothing if it stays as it is or doesn't exist.
  std::optional<std::string> fateOf(const std::filesystem::path& path) const;

 private:
  /// The identity of a file or folder on this machine.
  struct Identity {
    dev_t device = 0;
    ino_t number = 0;

    friend auto operator<=>(const Identity&, const Identity&) = default;
  };

  static std::optional<Identity> identityOf(const std::filesystem::path& path);
  void addPartialVideos(const ClipFiles& files, const std::vector<video::VideoFormat>& formats);
  void addFolder(std::set<Identity>& folders, const std::filesystem::path& folder);
  std::optional<std::string> fateOfName(const std::filesystem::path& path) const;

  std::set<Identity> files_;
  std::set<Identity> tidied_;  ///< Folders whose stale temporaries are removed.
  std::set<Identity> frames_;  ///< Folders of frames, with the record, manifest and checksums.
  std::set<Identity> moved_;   ///< Folders of which no file stays where it is.
};

}  // namespace rotatebook::store

// A render as the folder of its clip sees it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "store/manifest.h"

namespace rotatebook::store {

/// The treatment of frames that an earlier render left unfinished. If neither is set, such frames
/// are an error.
struct EarlierFrames {
  /// Keep the frames if their settings are the same; otherwise they are an error, even those of a
  /// finished clip.
  bool resume = false;
  bool overwrite = false;  ///< Discard the frames; with `resume`, only if their settings differ.
};

/// A render and its treatment of earlier frames.
struct ClipSettings {
  const scene::Scene& scene;
  std::string record;      ///< The text of scene.toml.
  Manifest::Entries made;  ///< The fingerprint of the frames.
  /// The files beside the frames that the render will write.
  std::vector<std::filesystem::path> outputs{};
  EarlierFrames earlier{};
  bool part = false;  ///< A range of frames, which go to NAME/ beside others of these settings.
  bool png = true;    ///< PNGs are written; a part without them leaves nothing in NAME/.
  /// Other parts may be drawn on other machines at the same time: this one adds to no file of
  /// theirs.
  bool ownChecksums = false;
};

}  // namespace rotatebook::store

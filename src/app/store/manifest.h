// Manifests of folders of frames: their provenance, from which a later render knows whether it can
// resume.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rotatebook::store {

/// The content of frames.manifest, a TOML file beside the frames.
struct Manifest {
  using Entries = std::map<std::string, std::string>;

  /// The outputs of one render.
  struct Render {
    /// The fingerprint: everything that the frames' bytes depend on, as checksums where it is long.
    /// Frames of equal fingerprints are equal.
    Entries made;
    /// The checksums of the files beside the folder, by file name.
    Entries files;

    friend bool operator==(const Render&, const Render&) = default;
  };

  /// The render whose frames and scene.toml are in the folder.
  Render own;
  /// True if `own` is finished: its clip is complete, and so are its frames if there are any. The
  /// files of a render without PNGs may be complete beside unfinished frames.
  bool finished = false;
  /// Renders with other settings whose files are still beside the folder. Each file belongs to the
  /// render that wrote it last.
  std::vector<Render> others{};

  /// Returns the files of the render with the fingerprint `made`; null if there is none.
  const Entries* filesOf(const Entries& made) const;
  /// Adds `files`, which the render with the fingerprint `made` wrote, and takes them from the
  /// others.
  void add(const Entries& made, const Entries& files);
  /// Makes the render with the fingerprint `made` `own`, with its files if it was among `others`,
  /// to which the former `own` moves if it has files.
  void become(const Entries& made);

  friend bool operator==(const Manifest&, const Manifest&) = default;
};

/// Returns the text that parseManifest() reads.
std::string manifestText(const Manifest& manifest);

/// Parses a manifest; `file` names it in messages. Ignores entries without a meaning. Throws
/// InputError if the text isn't TOML.
Manifest parseManifest(std::string_view text, const std::string& file);

/// Reads the manifest in `folder`; returns nothing if there is none or it can't be parsed. Throws
/// MachineError if the disk fails.
std::optional<Manifest> readManifest(const std::filesystem::path& folder);

/// Replaces the manifest in `folder`. Throws MachineError.
void writeManifest(const std::filesystem::path& folder, const Manifest& manifest);

/// Writes the manifest `next` in the place of `there`, or of none. Returns false if another process
/// has put another there meanwhile: of several that call it at once, also on several machines, one
/// gets true. Throws MachineError.
bool replaceManifest(const std::filesystem::path& folder, const std::optional<Manifest>& there,
                     const Manifest& next);

}  // namespace rotatebook::store

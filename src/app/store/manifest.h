// What a folder's frames were made from and with, so that a render can go on where one stopped.
// Inside the room only.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rotatebook::store {

/// The name of the file; without TOML's ending, as it is no scene.
inline constexpr const char* kManifestName = "frames.manifest";

/// frames.manifest, beside the frames; in TOML.
struct Manifest {
  using Entries = std::map<std::string, std::string>;

  /// What one render made.
  struct Render {
    /// The fingerprint: all that the frames' bytes depend on, checksums where it is long. Frames of
    /// equal fingerprints are equal.
    Entries made;
    /// The checksums of the files beside the folder, by their names.
    Entries files;

    friend bool operator==(const Render&, const Render&) = default;
  };

  /// The render whose frames and scene.toml are in the folder.
  Render own;
  bool finished = false;  ///< Whether that render was: its clip is complete.
  /// Those of other settings that left files beside the folder, each file of the last one that
  /// wrote it.
  std::vector<Render> others{};

  /// The files of the render with this fingerprint; null if there is none.
  const Entries* filesOf(const Entries& made) const;
  /// Adds files that the render with this fingerprint wrote; they are no other's any more.
  void add(const Entries& made, const Entries& files);
  /// Makes the render with this fingerprint `own`, with what is known of its files; the one before
  /// goes to `others`.
  void become(const Entries& made);

  friend bool operator==(const Manifest&, const Manifest&) = default;
};

std::string manifestText(const Manifest& manifest);

/// Of a manifest's text. Throws InputError where it isn't TOML; what has no meaning is let go.
Manifest parseManifest(std::string_view text, const std::string& file);

/// That of `folder`; nothing if there is none, or what is there is no manifest. Throws MachineError
/// if the disk fails.
std::optional<Manifest> readManifest(const std::filesystem::path& folder);

/// Throws MachineError.
void writeManifest(const std::filesystem::path& folder, const Manifest& manifest);

}  // namespace rotatebook::store

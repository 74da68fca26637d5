// What a folder's frames were made from and with, so that a render can go on where one stopped.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace rotatebook::pipeline {

/// The name of the file; without TOML's ending, as it is no scene.
inline constexpr const char* kManifestName = "frames.manifest";

/// frames.manifest, beside the frames; in TOML.
struct Manifest {
  using Entries = std::map<std::string, std::string>;

  /// The fingerprint: all that the frames' bytes depend on, checksums where it is long. Frames of
  /// equal fingerprints are equal.
  Entries made;
  /// The checksums of the files that were made with the frames, by their names in the folder
  /// above: only of a clip that is complete.
  Entries files;

  bool isComplete() const { return !files.empty(); }
};

std::string manifestText(const Manifest& manifest);

/// Of a manifest's text. Throws InputError where it isn't TOML; what has no meaning is let go.
Manifest parseManifest(std::string_view text, const std::string& file);

/// That of `folder`; nothing if there is none, or what is there is no manifest. Throws MachineError
/// if the disk fails.
std::optional<Manifest> readManifest(const std::filesystem::path& folder);

/// Throws MachineError.
void writeManifest(const std::filesystem::path& folder, const Manifest& manifest);

}  // namespace rotatebook::pipeline

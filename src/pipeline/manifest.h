// What a folder's frames were made from and with, so that a render can go on where one stopped.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "scene/scene.h"

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

/// Program, build, renderer, FFmpeg, PNG level, scene and the textures' bytes.
Manifest::Entries fingerprint(const scene::Scene& scene, const std::string& renderer, int pngLevel);

/// That of `folder`; nothing if there is none, or none that can be read.
std::optional<Manifest> readManifest(const std::filesystem::path& folder);

/// Throws MachineError.
void writeManifest(const std::filesystem::path& folder, const Manifest& manifest);

/// For a message: in what `folder`, which has this manifest and a scene.toml, differs from a render
/// of `scene` with the fingerprint `made`. "clip.duration is 8.0 there, 10.0 here"
std::string differences(const std::filesystem::path& folder, const Manifest& there,
                        const Manifest::Entries& made, const scene::Scene& scene);

}  // namespace rotatebook::pipeline

// The fingerprint of a folder's frames: everything that their bytes depend on.
#pragma once

#include <filesystem>
#include <string>

#include "scene/scene.h"
#include "store/manifest.h"

namespace rotatebook::store {

/// Returns program, build, renderer, FFmpeg, the scene's checksum and the drawn `textures`, which
/// are picture::LoadedTextures::checksums.
Manifest::Entries fingerprint(const scene::Scene& scene, const Manifest::Entries& textures,
                              const std::string& renderer);

/// Returns, for a message, how the frames in `folder`, which have the fingerprint `there` and a
/// scene.toml, differ from a render of `scene` with the fingerprint `made`: "clip.duration is 8.0
/// there, 10.0 here". The first few differences, and the number of others.
std::string differences(const std::filesystem::path& folder, const Manifest::Entries& there,
                        const Manifest::Entries& made, const scene::Scene& scene);

/// Returns the checksum of the scene from which `file`, in the folder above `folder`, was made.
/// Empty if the manifest in `folder` doesn't list the file or the file has changed. Throws
/// MachineError.
std::string sceneChecksumOf(const std::filesystem::path& folder, const std::filesystem::path& file);

}  // namespace rotatebook::store

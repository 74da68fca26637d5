// What a folder's frames depend on.
#pragma once

#include <filesystem>
#include <string>

#include "scene/scene.h"
#include "store/manifest.h"

namespace rotatebook::store {

/// Program, build, renderer, FFmpeg, PNG level, scene and the textures that are drawn, as
/// picture::LoadedTextures::checksums has them.
Manifest::Entries fingerprint(const scene::Scene& scene, const Manifest::Entries& textures,
                              const std::string& renderer);

/// For a message: in what `folder`, which has the fingerprint `there` and a scene.toml, differs
/// from a render of `scene` with the fingerprint `made`. "clip.duration is 8.0 there, 10.0 here"
std::string differences(const std::filesystem::path& folder, const Manifest::Entries& there,
                        const Manifest::Entries& made, const scene::Scene& scene);

/// The checksum of the scene from which the file in the folder above `folder` was made, if it is as
/// the manifest in `folder` has it; else empty. Throws MachineError.
std::string sceneChecksumOf(const std::filesystem::path& folder, const std::filesystem::path& file);

}  // namespace rotatebook::store

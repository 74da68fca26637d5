// The fingerprint of a folder's frames: everything that their bytes depend on.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "scene/scene.h"
#include "store/manifest.h"

namespace rotatebook::store {

/// The renderer of the frames.
struct Drawing {
  std::string renderer;   ///< render::Renderer::description()
  std::string testFrame;  ///< picture::testFrame(), as renderers of one description may differ.
};

/// Returns program, build, renderer, test frame, the scene's checksum and the drawn `textures`,
/// which are picture::LoadedTextures::checksums. FFmpeg draws nothing.
Manifest::Entries fingerprint(const scene::Scene& scene, const Manifest::Entries& textures,
                              const Drawing& drawing);

/// Returns the checksum of a whole scene.
std::string sceneChecksum(const scene::Scene& scene);

/// Returns a checksum of what is run and expected by a scene's study: the scene without its texts,
/// looks and expectations.
std::string studySceneChecksum(const scene::Scene& scene);
/// Returns a checksum of all that the values of a scene's map depend on: the scene without its
/// texts, looks and expectations, program and build.
std::string mapFingerprint(const scene::Scene& scene);
/// Returns a checksum of all that the pictures of a map's film depend on.
std::string filmFingerprint(const scene::Scene& scene);
/// Returns the text that the film of a scene's map holds as its comment, by which it is known.
std::string recordOfFilm(const scene::Scene& scene);
/// Returns whether `text` is the record of some map's film.
bool isRecordOfFilm(std::string_view text);

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

#include "picture/looks.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <future>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "base/checksum.h"
#include "base/clip_limits.h"
#include "base/error.h"
#include "image/picture_file.h"
#include "picture/named_file.h"
#include "render/book_textures.h"
#include "render/surface_look.h"
#include "scene/scene_text.h"
#include "scene/solid_numbers.h"
#include "scene/source_locations.h"
#include "timeline/scene_camera.h"

namespace rotatebook::picture {
namespace {

namespace fs = std::filesystem;

/// A side of the book cover that has a picture.
struct Side {
  std::string_view key;  ///< In the scene.
  std::string scene::BookSettings::*file;
  image::Image (*builtin)();
};

/// In a grid, books on pictures up to this high have fewer triangles. [pixels]
constexpr int kLargestSmall = 160;

constexpr Side kFront{"book.front", &scene::BookSettings::front, render::builtinFront};
constexpr Side kSpine{"book.spine", &scene::BookSettings::spine, render::builtinSpine};
constexpr Side kBack{"book.back", &scene::BookSettings::back, render::builtinBack};

bool isBuiltin(const scene::Scene& scene, const Side& side) {
  return scene.book.*side.file == scene::kBuiltin;
}

fs::path fileOf(const scene::Scene& scene, const Side& side) {
  return pathOfNamedFile(scene.folder, scene.book.*side.file, scene.allowOutside);
}

/// A side's picture, and the checksum of its file.
struct LoadedSide {
  image::Image picture;
  std::string checksum;
};

std::string read(const scene::Scene& scene, const Side& side) {
  return scene::atLocationOf(scene, side.key,
                             [&] { return image::readPictureFile(fileOf(scene, side)); });
}

image::Image decoded(const std::string& bytes, const std::string& name) {
  const auto* first = reinterpret_cast<const std::uint8_t*>(bytes.data());
  return image::decodePicture({first, bytes.size()}, name);
}

image::Image decode(const scene::Scene& scene, const Side& side, const std::string& bytes) {
  return scene::atLocationOf(scene, side.key, [&] {
    return decoded(bytes, (scene.folder / (scene.book.*side.file)).string());
  });
}

/// Returns the picture of a side that the scene names no file for.
image::Image builtinPicture(const scene::Scene& scene, const Side& side) {
  return scene.book.colour ? render::plainCloth(*scene.book.colour) : side.builtin();
}

LoadedSide load(const scene::Scene& scene, const Side& side, const TextureFiles& files) {
  if (isBuiltin(scene, side)) return {builtinPicture(scene, side), kBuiltinTexture};
  const auto known = files.find(std::string(side.key));
  const std::string bytes = known == files.end() ? read(scene, side) : known->second;
  return {decode(scene, side, bytes), checksumOf(bytes)};
}

render::BookTextures loadBook(const scene::Scene& scene, const TextureFiles& files,
                              TextureChecksums& checksums) {
  const auto start = [&](const Side& side) {
    return std::async(std::launch::async, [&] { return load(scene, side, files); });
  };
  auto frontLoading = start(kFront), spineLoading = start(kSpine), backLoading = start(kBack);
  LoadedSide front = frontLoading.get(), spine = spineLoading.get(), back = backLoading.get();
  checksums[std::string(kFront.key)] = front.checksum;
  checksums[std::string(kSpine.key)] = spine.checksum;
  checksums[std::string(kBack.key)] = back.checksum;
  return {std::move(front.picture), std::move(spine.picture), std::move(back.picture)};
}

/// A body of a scene, which may have several motions.
struct SceneBody {
  scene::Solid solid;
  Eigen::Vector3d size;  ///< Of the box around it. [m]
  std::string meshKey;   ///< The key that names its mesh; empty if it has none.
};

/// The different bodies of a scene's motions.
struct SceneBodies {
  std::vector<SceneBody> bodies;
  std::vector<std::size_t> bodyOf;  ///< By motion.
};

SceneBodies bodiesOf(const scene::Scene& scene) {
  SceneBodies all;
  const std::vector<scene::Panel>& motions = scene.motions;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const scene::Solid& solid = motions[i].solid;
    const auto same = std::ranges::find(all.bodies, solid, &SceneBody::solid);
    all.bodyOf.push_back(static_cast<std::size_t>(same - all.bodies.begin()));
    if (same != all.bodies.end()) continue;
    const std::string key = scene.hasPanels() ? fmt::format("panel.{}.body.mesh", i) : "body.mesh";
    all.bodies.push_back({solid, motions[i].body.size, solid.mesh.name.empty() ? "" : key});
  }
  return all;
}

bool hasBook(const SceneBodies& all) {
  return std::ranges::any_of(all.bodies, [](const SceneBody& b) { return b.solid.isBook(); });
}

/// Returns what `work` returns. Throws an InputError of it again with the bodies' location.
template <typename Work>
auto atBodies(const scene::Scene& scene, const Work& work) {
  return scene::atLocationOf(scene, scene.hasPanels() ? "panel" : "body", work);
}

/// Returns the look of a body that isn't the book.
std::shared_ptr<const render::SurfaceLook> lookOf(const scene::Scene& scene,
                                                  const SceneBody& body) {
  return atBodies(scene, [&] {
    auto look = std::make_shared<render::SurfaceLook>();
    look->size = body.size;
    look->surface = scene::surfaceOf(body.solid);
    std::int64_t pixels = 0;
    for (const std::string& image : look->surface.images) {
      look->images.push_back(
          decoded(image, fmt::format("{}, picture {}", body.solid.mesh.name, look->images.size())));
      pixels += std::int64_t{look->images.back().width()} * look->images.back().height();
      if (pixels > kMaxPicturePixels)
        throw InputError(
            fmt::format("{}: its pictures have more than {} pixels in all; make them smaller",
                        body.solid.mesh.name, kMaxPicturePixels));
    }
    return look;
  });
}

render::Background backgroundOf(scene::Background background) {
  switch (background) {
    case scene::Background::Stars:
      return render::Background::Stars;
    case scene::Background::Transparent:
      return render::Background::Transparent;
    case scene::Background::Plain:
      return render::Background::Plain;
    case scene::Background::Studio:
      break;
  }
  return render::Background::Studio;
}

}  // namespace

TextureFiles readTextures(const scene::Scene& scene) {
  TextureFiles files;
  const SceneBodies all = bodiesOf(scene);
  for (const Side& side : {kFront, kSpine, kBack}) {
    // Built-in textures are always valid, and loading them takes a tenth of a render's start.
    if (!hasBook(all) || isBuiltin(scene, side)) continue;
    std::string& bytes = files[std::string(side.key)] = read(scene, side);
    decode(scene, side, bytes);
  }
  for (const SceneBody& body : all.bodies) {
    if (!body.meshKey.empty()) lookOf(scene, body);
  }
  return files;
}

TextureChecksums checksumsOf(const scene::Scene& scene, const TextureFiles& files) {
  TextureChecksums sums;
  for (const auto& [key, bytes] : files) sums.emplace(key, checksumOf(bytes));
  for (const SceneBody& body : bodiesOf(scene).bodies) {
    if (!body.meshKey.empty()) sums.emplace(body.meshKey, body.solid.mesh.checksum);
  }
  return sums;
}

LoadedLooks loadLooks(const scene::Scene& scene, const TextureFiles& files) {
  SceneBodies all = bodiesOf(scene);
  LoadedLooks loaded;
  for (const SceneBody& body : all.bodies) {
    if (body.solid.isBook()) {
      loaded.looks.emplace_back(loadBook(scene, files, loaded.checksums));
      continue;
    }
    loaded.looks.emplace_back(lookOf(scene, body));
    if (!body.meshKey.empty()) loaded.checksums[body.meshKey] = body.solid.mesh.checksum;
  }
  loaded.lookOf = std::move(all.bodyOf);
  return loaded;
}

render::Renderer makeRenderer(const scene::Scene& scene, const geometry::Screen& screen,
                              const std::vector<render::BodyLook>& looks,
                              const render::DeviceChoice& device) {
  render::RenderSettings settings;
  settings.width = screen.width;
  settings.height = screen.height;
  settings.bottomRows = screen.bottomRows;
  settings.supersample = scene.look.supersample;
  settings.background = backgroundOf(scene.look.background);
  settings.plainColour = scene.look.plainColour;
  settings.camera = timeline::cameraOf(scene, screen);
  settings.drawsBodies = scene.look.body;
  if (scene.grid &&
      std::min(screen.width, screen.height) * scene.look.supersample <= kLargestSmall) {
    settings.detail = geometry::MeshDetail::Small;
  }
  settings.device = device;
  return {settings, looks};
}

render::Renderer makeRenderer(const scene::Scene& scene) {
  return makeRenderer(scene, {scene.clip.width, scene.clip.height, 0}, loadLooks(scene).looks);
}

}  // namespace rotatebook::picture

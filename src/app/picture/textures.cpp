#include "picture/textures.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <future>
#include <string>
#include <string_view>
#include <utility>

#include "base/checksum.h"
#include "base/error.h"
#include "image/picture_file.h"
#include "picture/named_file.h"
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

image::Image decode(const scene::Scene& scene, const Side& side, const std::string& bytes) {
  return scene::atLocationOf(scene, side.key, [&] {
    const auto* first = reinterpret_cast<const std::uint8_t*>(bytes.data());
    const fs::path file = scene.folder / (scene.book.*side.file);
    return image::decodePicture({first, bytes.size()}, file.string());
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

std::vector<fs::path> textureFiles(const scene::Scene& scene) {
  std::vector<fs::path> files;
  for (const Side& side : {kFront, kSpine, kBack}) {
    if (!isBuiltin(scene, side)) files.push_back(scene.folder / (scene.book.*side.file));
  }
  return files;
}

TextureFiles readTextures(const scene::Scene& scene) {
  scene::requireBook(scene);
  TextureFiles files;
  for (const Side& side : {kFront, kSpine, kBack}) {
    // Built-in textures are always valid, and loading them takes a tenth of a render's start.
    if (isBuiltin(scene, side)) continue;
    std::string& bytes = files[std::string(side.key)] = read(scene, side);
    decode(scene, side, bytes);
  }
  return files;
}

LoadedTextures loadTextures(const scene::Scene& scene, const TextureFiles& files) {
  scene::requireBook(scene);
  const auto start = [&](const Side& side) {
    return std::async(std::launch::async, [&] { return load(scene, side, files); });
  };
  auto frontLoading = start(kFront), spineLoading = start(kSpine), backLoading = start(kBack);
  LoadedSide front = frontLoading.get(), spine = spineLoading.get(), back = backLoading.get();
  return {{std::move(front.picture), std::move(spine.picture), std::move(back.picture)},
          {{std::string(kFront.key), front.checksum},
           {std::string(kSpine.key), spine.checksum},
           {std::string(kBack.key), back.checksum}}};
}

render::Renderer makeRenderer(const scene::Scene& scene, const geometry::Screen& screen,
                              const render::BookTextures& textures,
                              const render::DeviceChoice& device) {
  render::RenderSettings settings;
  settings.width = screen.width;
  settings.height = screen.height;
  settings.bottomRows = screen.bottomRows;
  settings.supersample = scene.look.supersample;
  settings.background = backgroundOf(scene.look.background);
  settings.plainColour = scene.look.plainColour;
  settings.camera = timeline::cameraOf(scene, screen);
  if (scene.grid &&
      std::min(screen.width, screen.height) * scene.look.supersample <= kLargestSmall) {
    settings.detail = geometry::MeshDetail::Small;
  }
  settings.device = device;
  return {settings, textures};
}

render::Renderer makeRenderer(const scene::Scene& scene) {
  return makeRenderer(scene, {scene.clip.width, scene.clip.height, 0},
                      loadTextures(scene).pictures);
}

}  // namespace rotatebook::picture

#include "body/glb_materials.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"

namespace rotatebook::body {
namespace {

using Json = GlbDocument::Json;

/// Returns a number from 0 to 1, `byDefault` if there is none.
float shareOf(const Json& value, float byDefault, const std::string& name) {
  if (value.is_null()) return byDefault;
  const double number = value.is_number() ? value.get<double>() : -1;
  if (!(number >= 0 && number <= 1))
    throw InputError(name + " isn't a number from 0 to 1; export the file again");
  return static_cast<float>(number);
}

/// Reads the pictures of materials, each once.
class Images {
 public:
  Images(const GlbDocument& document, Surface& surface)
      : document_(document),
        images_(surface.images),
        indices_(document.size("bufferViews"), kNoImage) {}

  /// Returns the index of the picture of the texture that `use` names, or kNoImage.
  int indexOf(const Json& use) {
    const auto texture = GlbDocument::count(use, "index");
    if (!texture) return kNoImage;
    const auto source = GlbDocument::count(document_.at("textures", *texture), "source");
    if (!source) return kNoImage;
    const auto view = GlbDocument::count(document_.at("images", *source), "bufferView");
    if (!view) {
      throw InputError("picture " + std::to_string(*source) +
                       " is in another file; export it as one .glb");
    }
    const std::string_view bytes = document_.view(*view);
    int& index = indices_[*view];
    if (index != kNoImage) return index;
    bytes_ += bytes.size();
    if (bytes_ > kMaxBytes) throw InputError("its pictures have more than 256 MiB");
    index = static_cast<int>(images_.size());
    images_.emplace_back(bytes);
    return index;
  }

 private:
  const GlbDocument& document_;
  std::vector<std::string>& images_;
  std::vector<int> indices_;  // By bufferView of the document.
  std::size_t bytes_ = 0;

  static constexpr std::size_t kMaxBytes = std::size_t{1} << 28;
};

Material materialFrom(const Json& json, const std::string& name, Images& images) {
  const Json& model = GlbDocument::member(json, "pbrMetallicRoughness");
  Material material{.baseColour = {1, 1, 1}};
  const Json& colour = GlbDocument::member(model, "baseColorFactor");
  for (std::size_t i = 0; colour.is_array() && i < std::min<std::size_t>(3, colour.size()); ++i) {
    material.baseColour[static_cast<Eigen::Index>(i)] =
        shareOf(colour[i], 1, name + ": baseColorFactor");
  }
  material.metalness =
      shareOf(GlbDocument::member(model, "metallicFactor"), 1, name + ": metallicFactor");
  material.roughness =
      shareOf(GlbDocument::member(model, "roughnessFactor"), 1, name + ": roughnessFactor");
  material.baseColourImage = images.indexOf(GlbDocument::member(model, "baseColorTexture"));
  material.metalRoughnessImage =
      images.indexOf(GlbDocument::member(model, "metallicRoughnessTexture"));
  return material;
}

}  // namespace

void readMaterials(const GlbDocument& document, Surface& surface) {
  constexpr std::size_t kMaxImages = 256;
  const std::size_t count = document.size("materials");
  if (count > kMaxMaterials || document.size("images") > kMaxImages) {
    throw InputError("it has " + std::to_string(count) + " materials and " +
                     std::to_string(document.size("images")) + " pictures; at most " +
                     std::to_string(kMaxMaterials) + " of either are drawn");
  }
  surface.materials.clear();
  Images images(document, surface);
  for (std::size_t i = 0; i < count; ++i) {
    surface.materials.push_back(
        materialFrom(document.at("materials", i), "material " + std::to_string(i), images));
  }
  surface.materials.push_back({});
}

}  // namespace rotatebook::body

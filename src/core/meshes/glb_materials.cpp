#include "meshes/glb_materials.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/elementary.h"
#include "base/error.h"
#include "meshes/glb_extensions.h"

namespace rotatebook::meshes {
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

/// The pictures of a material, by the name of what they are of.
constexpr const char* kColourPicture = "baseColorTexture";
constexpr const char* kMetalPicture = "metallicRoughnessTexture";

/// Returns the number of a texture's picture: of PNG, JPEG or WebP; nothing if it has none.
std::optional<std::size_t> sourceOf(const GlbDocument& document, const Json& use) {
  const auto index = GlbDocument::count(use, "index");
  if (!index) return std::nullopt;
  const Json& texture = document.at("textures", *index);
  if (const auto source = GlbDocument::count(texture, "source")) return source;
  return GlbDocument::count(extensionOf(texture, "EXT_texture_webp"), "source");
}

/// Returns what a sampler says of the axis `name`, in OpenGL's numbers.
body::Wrap wrapOf(const Json& sampler, const char* name) {
  constexpr std::size_t kClamp = 33071, kMirror = 33648;
  const auto mode = GlbDocument::count(sampler, name);
  return mode == kClamp    ? body::Wrap::Clamp
         : mode == kMirror ? body::Wrap::Mirror
                           : body::Wrap::Repeat;
}

/// Returns how a texture's picture is read.
body::Sampling samplingOf(const GlbDocument& document, const Json& texture) {
  constexpr std::size_t kNearest = 9728;
  const auto index = GlbDocument::count(texture, "sampler");
  if (!index) return {};
  const Json& sampler = document.at("samplers", *index);
  return {wrapOf(sampler, "wrapS"), wrapOf(sampler, "wrapT"),
          GlbDocument::count(sampler, "magFilter") == kNearest};
}

/// Reads a pair of numbers, if there is one.
void readPair(const Json& transform, const char* name, Eigen::Vector2d& pair) {
  const Json& list = GlbDocument::member(transform, name);
  if (list.is_null()) return;
  if (!list.is_array() || list.size() != 2 || !list[0].is_number() || !list[1].is_number())
    throw InputError("a texture's " + std::string(name) + " isn't a pair of numbers");
  pair = {list[0].get<double>(), list[1].get<double>()};
}

PictureUse useOf(const Json& texture) {
  PictureUse use{GlbDocument::count(texture, "texCoord").value_or(0)};
  const Json& transform = extensionOf(texture, "KHR_texture_transform");
  if (transform.is_null()) return use;
  use.set = GlbDocument::count(transform, "texCoord").value_or(use.set);
  use.isChanged = true;
  Eigen::Vector2d scale(1, 1);
  readPair(transform, "scale", scale);
  readPair(transform, "offset", use.offset);
  const Json& rotation = GlbDocument::member(transform, "rotation");
  const double angle = rotation.is_number() ? rotation.get<double>() : 0;
  if (!(std::fabs(angle) <= kLargestAngle))
    throw InputError("a texture's rotation is larger than 10^6 radians; export the file again");
  const double c = cosine(angle), s = sine(angle);
  use.turn << c, s, -s, c;  // Counter-clockwise, as v is down
  use.turn = use.turn * scale.asDiagonal();
  return use;
}

/// Reads the pictures of materials, each once for each sampling.
class Images {
 public:
  Images(const GlbDocument& document, body::Surface& surface)
      : document_(document), surface_(surface) {}

  /// Returns the index of the picture of the texture that `use` names, or kNoImage.
  int indexOf(const Json& use) {
    const auto source = sourceOf(document_, use);
    if (!source) return body::kNoImage;
    const Json& texture = document_.at("textures", GlbDocument::count(use, "index").value_or(0));
    const body::Sampling sampling = samplingOf(document_, texture);
    const Json& image = document_.at("images", *source);
    if (const auto view = GlbDocument::count(image, "bufferView"))
      return indexIn(byView_, {*view, sampling},
                     [&] { return std::string(document_.view(*view)); });
    return indexIn(bySource_, {*source, sampling}, [&] {
      auto bytes = dataOfUri(GlbDocument::member(image, "uri"));
      if (bytes) return *bytes;
      throw InputError("picture " + std::to_string(*source) +
                       " is in another file; export it as one .glb");
    });
  }

 private:
  using Indices = std::map<std::pair<std::size_t, body::Sampling>, int>;

  template <typename Read>
  int indexIn(Indices& indices, const Indices::key_type& key, const Read& read) {
    const auto [place, isNew] = indices.emplace(key, static_cast<int>(surface_.images.size()));
    if (!isNew) return place->second;
    surface_.images.push_back(read());
    surface_.samplings.push_back(key.second);
    bytes_ += surface_.images.back().size();
    if (bytes_ > kMaxBytes) throw InputError("its pictures have more than 256 MiB");
    return place->second;
  }

  const GlbDocument& document_;
  body::Surface& surface_;
  Indices byView_, bySource_;  // By bufferView and image of the document.
  std::size_t bytes_ = 0;

  static constexpr std::size_t kMaxBytes = std::size_t{1} << 28;
};

body::Material materialFrom(const Json& json, const std::string& name, Images& images) {
  const Json& model = GlbDocument::member(json, "pbrMetallicRoughness");
  body::Material material{.baseColour = {1, 1, 1}};
  const Json& colour = GlbDocument::member(model, "baseColorFactor");
  for (std::size_t i = 0; colour.is_array() && i < std::min<std::size_t>(3, colour.size()); ++i) {
    material.baseColour[static_cast<Eigen::Index>(i)] =
        shareOf(colour[i], 1, name + ": baseColorFactor");
  }
  material.metalness =
      shareOf(GlbDocument::member(model, "metallicFactor"), 1, name + ": metallicFactor");
  material.roughness =
      shareOf(GlbDocument::member(model, "roughnessFactor"), 1, name + ": roughnessFactor");
  const Json &colours = GlbDocument::member(model, kColourPicture),
             &metals = GlbDocument::member(model, kMetalPicture);
  material.baseColourImage = images.indexOf(colours);
  material.metalRoughnessImage = images.indexOf(metals);
  // A surface has its texture coordinates once
  if (material.baseColourImage != body::kNoImage &&
      material.metalRoughnessImage != body::kNoImage && useOf(colours) != useOf(metals))
    material.metalRoughnessImage = body::kNoImage;
  return material;
}

const Json& modelOf(const GlbDocument& document, std::size_t material) {
  return GlbDocument::member(document.at("materials", material), "pbrMetallicRoughness");
}

}  // namespace

std::string texCoordName(const PictureUse& use) {
  return "TEXCOORD_" + std::to_string(use.set);
}

PictureUse pictureUseOf(const GlbDocument& document, const Json& primitive) {
  const auto material = GlbDocument::count(primitive, "material");
  if (!material) return {};
  const Json& model = modelOf(document, *material);
  const Json& colours = GlbDocument::member(model, kColourPicture);
  return useOf(sourceOf(document, colours) ? colours : GlbDocument::member(model, kMetalPicture));
}

std::string noteOnPictures(const GlbDocument& document, const Json& primitive) {
  const auto material = GlbDocument::count(primitive, "material");
  if (!material) return "";
  try {
    const Json& model = modelOf(document, *material);
    const Json &colours = GlbDocument::member(model, kColourPicture),
               &metals = GlbDocument::member(model, kMetalPicture);
    const bool hasColours = sourceOf(document, colours).has_value();
    const bool hasMetals = sourceOf(document, metals).has_value();
    if ((!hasColours && !colours.is_null()) || (!hasMetals && !metals.is_null()))
      return "a material's picture that is neither PNG, JPEG nor WebP isn't drawn";
    if (hasColours && hasMetals && useOf(colours) != useOf(metals)) {
      return "the picture of a material's metalness and roughness, whose texture coordinates "
             "aren't "
             "those of its colour, isn't drawn";
    }
    const std::string set = texCoordName(pictureUseOf(document, primitive));
    const Json& attributes = GlbDocument::member(primitive, "attributes");
    if ((hasColours || hasMetals) && GlbDocument::member(attributes, set.c_str()).is_null())
      return "a mesh without " + set + " has one colour of its picture";
  } catch (const InputError&) {
    // A picture that is wrong is no matter of the shape, and is refused where it is drawn.
  }
  return "";
}

std::vector<std::string> notesOnMaterial(const GlbDocument& document, const Json& primitive) {
  constexpr const char* kSpecular = "KHR_materials_pbrSpecularGlossiness";
  const auto index = GlbDocument::count(primitive, "material");
  if (!index) return {};
  const Json& material = document.at("materials", *index);
  std::vector<std::string> notes;
  const Json& alpha = GlbDocument::member(material, "alphaMode");
  if (alpha == "BLEND" || alpha == "MASK") notes.emplace_back("its transparency isn't drawn");
  const Json& light = GlbDocument::member(material, "emissiveFactor");
  if (std::ranges::any_of(light, [](const Json& share) { return share.is_number() && share > 0; }))
    notes.emplace_back("the light of its materials isn't drawn");
  if (modelOf(document, *index).is_null() && !extensionOf(material, kSpecular).is_null())
    notes.push_back("colours of " + std::string(kSpecular) + " aren't drawn");
  return notes;
}

void readMaterials(const GlbDocument& document, body::Surface& surface) {
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

}  // namespace rotatebook::meshes

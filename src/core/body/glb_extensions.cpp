#include "body/glb_extensions.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "base/error.h"
#include "base/text.h"

namespace rotatebook::body {
namespace {

/// Extensions that are read, and parts of the names of those that don't change any shape.
constexpr std::string_view kHarmless[] = {
    "KHR_mesh_quantization",
    "KHR_node_visibility",
    "_materials_",
    "_texture_",
    "_lights_",
    "_image_based",
    "_environment_map",
    "_animation_pointer",
    "_audio",
    "_xmp",
    "_metadata",
    "_mesh_features",
    "_instance_features",
    "_mesh_manifold",
    "_primitive_outline",
    "_packing_",
    "_interactivity",
    "_node_selectability",
    "_node_hoverability",
    "_physics_",
    "KHR_implicit_shapes",
    "VRM",
};

bool isHarmless(std::string_view name) {
  return std::ranges::any_of(kHarmless,
                             [&](std::string_view part) { return name.find(part) != name.npos; });
}

bool isCompression(std::string_view name) {
  return name.find("draco") != name.npos || name.find("meshopt") != name.npos ||
         name.find("compression") != name.npos;
}

}  // namespace

const GlbDocument::Json& extensionOf(const GlbDocument::Json& json, const char* name) {
  return GlbDocument::member(GlbDocument::member(json, "extensions"), name);
}

void requireKnownExtensions(const GlbDocument& document) {
  for (const GlbDocument::Json& json : GlbDocument::member(document.root(), "extensionsRequired")) {
    if (!json.is_string()) continue;
    const std::string& name = json.get_ref<const std::string&>();
    if (isHarmless(name)) continue;
    // A node that has copies of its mesh is refused where it is met
    if (name == "EXT_mesh_gpu_instancing") continue;
    throw InputError(
        "it needs the extension " + quotedText(oneLine(name, 60)) +
        (isCompression(name)
             ? ", whose meshes aren't read; export it without compression"
             : ", which isn't known here and may change its shape; export it without"));
  }
}

}  // namespace rotatebook::body

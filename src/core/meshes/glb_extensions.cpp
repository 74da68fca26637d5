#include "meshes/glb_extensions.h"

#include <algorithm>
#include <set>
#include <string>
#include <string_view>

#include "base/error.h"
#include "base/text.h"

namespace rotatebook::meshes {
namespace {

using Json = GlbDocument::Json;

/// Extensions whose numbers aren't those of plain accessors.
constexpr std::string_view kCompressions[] = {
    "EXT_meshopt_compression", "KHR_draco_mesh_compression", "KHR_meshopt_compression",
    "MESHOPT_compression",     "MPEG_primitive_V3C",         "WEB3D_quantized_attributes",
};

/// Extensions of meshes, nodes and their numbers that are read, or leave the shape as it is:
/// Khronos's registry of glTF 2.0 with its drafts, and those of OMI, VRM and Mozilla.
constexpr std::string_view kHarmless[] = {
    "AGI_articulations",
    "AGI_metadata",
    "AGI_stk_metadata",
    "BENTLEY_primitive_restart",  // Its primitives are also there without
    "CESIUM_primitive_outline",
    "CESIUM_tile_edges",
    "DRACO_animation_compression",
    "EXT_3d_metadata",
    "EXT_feature_metadata",
    "EXT_instance_features",
    "EXT_lights_area",
    "EXT_lights_ies",
    "EXT_manifold",
    "EXT_mesh_features",
    "EXT_mesh_gpu_instancing",  // Refused where its node is met
    "EXT_mesh_lod",
    "EXT_mesh_manifold",
    "EXT_mesh_opacity_micromap",
    "EXT_mesh_polygon",  // Its triangles are also there
    "EXT_mesh_primitive_edge_visibility",
    "EXT_mesh_primitive_restart",
    "EXT_node_lod",
    "EXT_pbr_attributes",
    "EXT_structural_metadata",
    "FB_ngon_encoding",
    "GRIFFEL_bim_data",
    "KHR_audio",
    "KHR_audio_emitter",
    "KHR_audio_graph",
    "KHR_collision_shapes",
    "KHR_gaussian_splatting",  // Of points
    "KHR_lights",
    "KHR_lights_area",
    "KHR_lights_ies",
    "KHR_lights_photometric",
    "KHR_lights_punctual",
    "KHR_lights_rect_area",
    "KHR_materials_variants",
    "KHR_mesh_primitive_restart",
    "KHR_mesh_quantization",
    "KHR_node_hoverability",
    "KHR_node_selectability",
    "KHR_node_visibility",
    "KHR_physics_rigid_bodies",
    "KHR_rigid_bodies",
    "KHR_xmp",
    "KHR_xmp_json_ld",
    "MAXAR_collision_geometry",
    "MAXAR_mesh_variants",  // Shows its default
    "MOZ_hubs_components",
    "MPEG_anchor",
    "MPEG_audio_spatial",
    "MPEG_avatar",
    "MPEG_haptic",
    "MPEG_haptics",
    "MPEG_light_punctual",
    "MPEG_node_anchor",
    "MPEG_node_avatar",
    "MPEG_node_interactivity",
    "MSFT_audio_emitter",
    "MSFT_lod",
    "OMI_audio_emitter",
    "OMI_collider",
    "OMI_link",
    "OMI_personality",
    "OMI_physics_body",
    "OMI_physics_gravity",
    "OMI_physics_joint",
    "OMI_seat",
    "OMI_spawn_point",
    "OMI_vehicle_body",
    "OMI_vehicle_hover_thruster",
    "OMI_vehicle_thruster",
    "OMI_vehicle_wheel",
    "VRMC_node_constraint",
    "VRMC_springBone_extended_collider",
};

template <std::size_t kCount>
bool isOneOf(const std::string_view (&names)[kCount], std::string_view name) {
  return std::ranges::find(names, name) != std::end(names);
}

/// Returns the extensions that a document needs and that aren't known.
std::set<std::string_view> unknownIn(const GlbDocument& document) {
  std::set<std::string_view> unknown;
  for (const std::string& name : document.required()) {
    if (!isOneOf(kHarmless, name) && !isOneOf(kCompressions, name)) unknown.insert(name);
  }
  return unknown;
}

/// Refuses what changes a shape in a way that isn't known.
class UnknownExtensions {
 public:
  explicit UnknownExtensions(const GlbDocument& document)
      : document_(document), names_(unknownIn(document)) {}

  void refuseInShapes() const {
    if (names_.empty()) return;
    refuseInEach("nodes", "a node");
    refuseInEach("skins", "a skin");
    refuseInEach("buffers", "a buffer");
    refuseInEach("bufferViews", "a bufferView");
    refuseInEach("accessors", "an accessor");
    refuseInEach("meshes", "a mesh");
    for (const Json& accessor : all("accessors"))
      refuseIn(GlbDocument::member(accessor, "sparse"), "an accessor");
    for (const Json& mesh : all("meshes")) {
      for (const Json& primitive : GlbDocument::member(mesh, "primitives"))
        refuseIn(primitive, "a mesh");
    }
  }

 private:
  const Json& all(const char* list) const { return GlbDocument::member(document_.root(), list); }

  void refuseInEach(const char* list, const char* what) const {
    for (const Json& json : all(list)) refuseIn(json, what);
  }

  void refuseIn(const Json& json, const std::string& what) const {
    const Json& extensions = GlbDocument::member(json, "extensions");
    if (!extensions.is_object()) return;
    for (auto extension = extensions.begin(); extension != extensions.end(); ++extension) {
      if (!names_.contains(extension.key())) continue;
      throw InputError(
          what + " needs the extension " + quotedBeginning(extension.key(), 60) +
          ", which isn't known here and may change its shape; export the file without it");
    }
  }

  const GlbDocument& document_;
  std::set<std::string_view> names_;
};

}  // namespace

const Json& extensionOf(const Json& json, const char* name) {
  return GlbDocument::member(GlbDocument::member(json, "extensions"), name);
}

void requireKnownExtensions(const GlbDocument& document) {
  UnknownExtensions(document).refuseInShapes();
}

void requireUncompressed(const GlbDocument& document, const Json& json, const std::string& what) {
  if (GlbDocument::member(json, "extensions").is_null()) return;
  for (const std::string_view name : kCompressions) {
    if (!document.required().contains(name)) continue;
    if (extensionOf(json, std::string(name).c_str()).is_null()) continue;
    throw InputError(what + " is compressed by the extension " + quotedText(name) +
                     ", which isn't read; export it without compression");
  }
}

}  // namespace rotatebook::meshes

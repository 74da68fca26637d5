// The materials of a .glb file. Inside the room only.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "body/surface.h"
#include "meshes/glb_document.h"

namespace rotatebook::meshes {

/// The texture coordinates by which a picture lies on a surface, and how these are changed.
struct PictureUse {
  std::size_t set = 0;
  bool isChanged = false;
  Eigen::Matrix2d turn = Eigen::Matrix2d::Identity();
  Eigen::Vector2d offset{0, 0};

  Eigen::Vector2d applied(const Eigen::Vector2d& coordinates) const {
    return isChanged ? Eigen::Vector2d(turn * coordinates + offset) : coordinates;
  }
  friend bool operator==(const PictureUse& a, const PictureUse& b) {
    return a.set == b.set && a.turn == b.turn && a.offset == b.offset;
  }
};

/// Returns how the pictures of a primitive's material lie on it. Throws InputError for a transform
/// that isn't numbers.
PictureUse pictureUseOf(const GlbDocument& document, const GlbDocument::Json& primitive);

/// Returns the name of the texture coordinates among a primitive's attributes.
std::string texCoordName(const PictureUse& use);

/// Returns a sentence on a picture of a primitive's material that isn't drawn as the file has it;
/// empty if there is none.
std::string noteOnPictures(const GlbDocument& document, const GlbDocument::Json& primitive);

/// Returns sentences on what of a primitive's material isn't drawn, its pictures aside.
std::vector<std::string> notesOnMaterial(const GlbDocument& document,
                                         const GlbDocument::Json& primitive);

/// Sets the materials of a surface to those of the document, by their numbers, and a neutral one
/// after them; and its images to those that they use. Throws InputError for a picture that isn't in
/// the file, a number that isn't one, or more than kMaxMaterials.
void readMaterials(const GlbDocument& document, body::Surface& surface);

inline constexpr std::size_t kMaxMaterials = 256;

}  // namespace rotatebook::meshes

// The numbers of a .glb file. Inside the room only.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <Eigen/Core>

#include "meshes/glb_document.h"

namespace rotatebook::meshes {

/// The numbers of an accessor, all of which are there, in rows.
class GlbNumbers {
 public:
  /// The form that an accessor must have.
  struct Wanted {
    std::string_view type;               ///< "SCALAR", "VEC3" and so on.
    std::size_t components;              ///< Of that type.
    std::optional<std::size_t> count{};  ///< Rows; any number if it isn't stated.
  };

  /// Throws InputError if the document has no such accessor, or it isn't as it must be.
  GlbNumbers(const GlbDocument& document, std::size_t accessor, const Wanted& wanted);

  std::size_t count() const { return count_; }
  bool areUnsigned32() const { return type_ == kUnsigned32; }

  /// Returns a number as it is meant: normalised ones are from 0 or -1 to 1.
  double at(std::size_t row, std::size_t component) const;
  /// Returns a whole number below 2^32. Throws InputError for other kinds.
  std::uint32_t indexAt(std::size_t row, std::size_t component = 0) const;
  /// Returns the first three numbers of a row.
  Eigen::Vector3d vectorAt(std::size_t row) const { return {at(row, 0), at(row, 1), at(row, 2)}; }

 private:
  static constexpr std::size_t kUnsigned32 = 5125;

  /// Finds `count` rows of the components' size; `what` is for messages.
  static std::string_view rowsIn(const GlbDocument& document, const GlbDocument::Json& json,
                                 std::size_t count, std::size_t element, std::size_t& stride,
                                 const std::string& what);
  void putSparse(const GlbDocument& document, const GlbDocument::Json& sparse, std::size_t element,
                 const std::string& name);

  std::string_view bytes_;
  std::shared_ptr<const std::string> own_;  // What bytes_ are of, where they aren't the file's.
  std::size_t count_ = 0, stride_ = 0, type_ = 0;
  bool isNormalised_ = false;
};

}  // namespace rotatebook::meshes

// The document in a .glb file. Inside the room only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace rotatebook::body {

/// A glTF 2.0 document with its binary data, whose parts are found by number. All members throw
/// InputError, with the remedy, for what isn't there or isn't what it must be.
class GlbDocument {
 public:
  using Json = nlohmann::json;

  /// Takes a file's bytes, which must outlive this.
  explicit GlbDocument(std::string_view bytes);

  /// Returns a member of an object; null if it has none.
  static const Json& member(const Json& json, const char* name);
  /// Returns a whole number below 2^32; `name` is for messages.
  static std::size_t wholeNumber(const Json& value, const std::string& name);
  /// Returns a member that is such a number; nothing if there is none.
  static std::optional<std::size_t> count(const Json& json, const char* name);

  const Json& root() const { return json_; }
  std::size_t size(const char* list) const;
  const Json& at(const char* list, std::size_t index) const;

  /// The bytes of an accessor's numbers.
  struct Numbers {
    std::string_view bytes;
    std::size_t count, stride;
    std::size_t type;  ///< 5121, 5123, 5125 or 5126, of unsigned numbers of 1, 2, 4 bytes, floats
  };
  /// Returns the numbers of an accessor with so many components, all of which are there.
  Numbers numbers(std::size_t accessor, std::string_view type, std::size_t components) const;
  /// Returns the bytes of a view of the binary data.
  std::string_view view(std::size_t index) const;

 private:
  Json json_;
  std::string_view binary_;
};

}  // namespace rotatebook::body

// The document in a .glb file. Inside the room only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace rotatebook::meshes {

/// A glTF 2.0 document with its binary data, whose parts are found by number. All members throw
/// InputError, with the remedy, for what isn't there or isn't what it must be.
class GlbDocument {
 public:
  using Json = nlohmann::json;

  /// Takes a file's bytes, which must outlive this, in time in proportion to them.
  explicit GlbDocument(std::string_view bytes);

  /// Returns a member of an object; null if it has none.
  static const Json& member(const Json& json, const char* name);
  /// Returns a whole number below 2^32; `name` is for messages.
  static std::size_t wholeNumber(const Json& value, const std::string& name);
  /// Returns a member that is such a number; nothing if there is none.
  static std::optional<std::size_t> count(const Json& json, const char* name);

  const Json& root() const { return json_; }
  /// Returns the names of the extensions without which the file can't be read.
  const std::set<std::string, std::less<>>& required() const { return required_; }
  std::size_t size(const char* list) const;
  const Json& at(const char* list, std::size_t index) const;

  /// Returns the bytes of a view of the binary data.
  std::string_view view(std::size_t index) const;

 private:
  std::string_view buffer(std::size_t index) const;

  Json json_;
  std::set<std::string, std::less<>> required_;
  std::string_view binary_;
  std::vector<std::string> decoded_;  // The data of buffers that are in the description, by number.
};

/// Returns the bytes of a data URI in base64; nothing if it is another URI. Throws InputError for a
/// data URI that isn't base64.
std::optional<std::string> dataOfUri(const GlbDocument::Json& uri);

}  // namespace rotatebook::meshes

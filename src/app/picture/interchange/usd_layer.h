// A layer of USD in the making, as text. Inside the room only.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/core.h>

namespace rotatebook::interchange {

/// Text of USD, whose blocks are closed in the order in which they were opened.
class UsdLayer {
 public:
  void line(std::string_view text);
  /// Opens a block by a line that ends in the bracket; without `head` it has that alone.
  void open(std::string_view head, char bracket = '{');
  void close();
  /// Adds `name = [...]`, with what `asText` makes of each item. With a bracket it opens a block.
  template <typename Items, typename AsText>
  void list(std::string_view name, const Items& items, const AsText& asText,
            std::optional<char> bracket = {}) {
    std::string text = fmt::format("{} = [", name);
    const char* comma = "";
    for (const auto& item : items) {
      text += comma + asText(item);
      comma = ", ";
    }
    if (bracket)
      open(text + "]", *bracket);
    else
      line(text + "]");
  }

  const std::string& text() const { return text_; }

 private:
  std::string text_ = "#usda 1.0\n";
  std::string brackets_;
};

/// Returns a text in quotes, on one line.
std::string usdQuoted(std::string_view text);

// Each returns "(x, y)" and so on, of 32-bit numbers as short as they are exact.
std::string usdText(const Eigen::Vector2f& vector);
std::string usdText(const Eigen::Vector3f& vector);
/// The real part comes first.
std::string usdText(const Eigen::Quaterniond& q);

}  // namespace rotatebook::interchange

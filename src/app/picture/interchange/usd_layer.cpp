#include "picture/interchange/usd_layer.h"

namespace rotatebook::interchange {

void UsdLayer::line(std::string_view text) {
  text_.append(4 * brackets_.size(), ' ').append(text).append("\n");
}

void UsdLayer::open(std::string_view head, char bracket) {
  line(std::string(head) + (head.empty() ? "" : " ") + bracket);
  brackets_ += bracket == '{' ? '}' : ')';
}

void UsdLayer::close() {
  const std::string bracket(1, brackets_.back());
  brackets_.pop_back();
  line(bracket);
}

std::string usdQuoted(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '\n')
      quoted += "\\n";
    else if (c == '"' || c == '\\')
      quoted.append("\\").append(1, c);
    else if (c != '\r')
      quoted += c;
  }
  return quoted + '"';
}

std::string usdText(const Eigen::Vector2f& vector) {
  return fmt::format("({}, {})", vector.x(), vector.y());
}

std::string usdText(const Eigen::Vector3f& vector) {
  return fmt::format("({}, {}, {})", vector.x(), vector.y(), vector.z());
}

std::string usdText(const Eigen::Quaterniond& q) {
  const Eigen::Quaternionf f = q.cast<float>();
  return fmt::format("({}, {}, {}, {})", f.w(), f.x(), f.y(), f.z());
}

}  // namespace rotatebook::interchange

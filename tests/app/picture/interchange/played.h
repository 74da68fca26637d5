// What programs show of an animated GLB.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "meshes/glb_document.h"
#include "meshes/glb_numbers.h"
#include "scene/scene_text.h"

namespace rotatebook::interchange::testing {

/// A throw as the starter's, of plain cloth, whose picture needn't be read.
inline scene::Scene sceneOf(const std::string& more = "", const std::string& spin = "5.0") {
  return scene::parseScene(R"(title = "Throw"
book.color = "#2b5d8a"
initial.angular_velocity = [)" +
                               spin + R"(, 0.0, 0.0]
initial.tilt = ["1 deg", "z"]
simulation.model = "exact"
)" + more,
                           "throw.toml");
}

/// Returns the document of a file, of which the reader of meshes leaves out what isn't a mesh's.
inline nlohmann::json documentOf(const std::string& glb) {
  constexpr std::size_t kLengthAt = 12, kDocumentAt = 20;
  std::uint32_t length = 0;
  std::memcpy(&length, glb.data() + kLengthAt, sizeof length);
  return nlohmann::json::parse(glb.substr(kDocumentAt, length));
}

/// The keys of an animation's channel, and what programs show between them.
class Played {
 public:
  Played(const std::string& glb, std::size_t channel) {
    const nlohmann::json json = documentOf(glb);
    const meshes::GlbDocument document(glb);
    const auto& animation = json["animations"][0];
    const auto& sampler = animation["samplers"][channel];
    isCubic_ = sampler["interpolation"] == "CUBICSPLINE";
    const auto& target = animation["channels"][channel]["target"];
    path_ = target["path"].get<std::string>();
    const meshes::GlbNumbers times(document, sampler["input"], {"SCALAR", 1});
    for (std::size_t i = 0; i < times.count(); ++i) times_.push_back(times.at(i, 0));
    const bool isTurning = path_ == "rotation";
    const std::size_t columns = isTurning ? 4 : 3;
    const meshes::GlbNumbers values(document, sampler["output"],
                                    {isTurning ? "VEC4" : "VEC3", columns});
    for (std::size_t i = 0; i < values.count(); ++i) {
      Eigen::Vector4d row = Eigen::Vector4d::Zero();
      for (std::size_t k = 0; k < columns; ++k) row[static_cast<Eigen::Index>(k)] = values.at(i, k);
      rows_.push_back(row);
    }
  }

  const std::string& path() const { return path_; }
  const std::vector<double>& times() const { return times_; }
  /// Returns the value of a key.
  const Eigen::Vector4d& key(std::size_t i) const { return rows_[isCubic_ ? 3 * i + 1 : i]; }

  /// Returns the attitude at a time between the first key and the last, as glTF 2.0 has it
  /// (appendix C).
  Eigen::Quaterniond attitudeAt(double time) const {
    const auto next = std::upper_bound(times_.begin() + 1, times_.end() - 1, time);
    const auto b = static_cast<std::size_t>(next - times_.begin()), a = b - 1;
    const double d = times_[b] - times_[a], t = (time - times_[a]) / d;
    if (!isCubic_) return Eigen::Quaterniond(key(a)).slerp(t, Eigen::Quaterniond(key(b)));
    const double t2 = t * t, t3 = t2 * t;
    return Eigen::Quaterniond(Eigen::Vector4d((2 * t3 - 3 * t2 + 1) * key(a) +
                                              d * (t3 - 2 * t2 + t) * rows_[3 * a + 2] +
                                              (3 * t2 - 2 * t3) * key(b) +
                                              d * (t3 - t2) * rows_[3 * b]))
        .normalized();
  }

 private:
  bool isCubic_ = false;
  std::string path_;
  std::vector<double> times_;
  std::vector<Eigen::Vector4d> rows_;
};

}  // namespace rotatebook::interchange::testing

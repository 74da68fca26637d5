// Motions, pictures and views to draw overlays on.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/LU>

#include "image/image.h"
#include "overlay/motion_overlays.h"
#include "physics/simulate.h"
#include "scene/scene_text.h"

namespace rotatebook::overlay::testing {

/// A scene that tumbles; `overrides` as --set takes them.
inline scene::Scene tumbling(const std::vector<std::string>& overrides = {}) {
  return scene::parseScene(
      "title = \"A title\"\n[initial]\nangular_velocity = [6.3, 0, 0]\ntilt = [0.02, 'z']\n"
      "[simulation]\nintegrator = 'rk4'\n[clip]\nfps = 30\nduration = 6\n",
      "tumbling.toml", overrides);
}

/// A scene whose motion diverges within its clip.
inline scene::Scene diverging(std::vector<std::string> overrides = {}) {
  for (const char* one :
       {"simulation.model=particles", "simulation.integrator=euler", "simulation.normalize=false",
        "simulation.damping=0", "simulation.substeps=8"}) {
    overrides.emplace_back(one);
  }
  return tumbling(overrides);
}

/// The names of all overlays of one motion of particles, as overlay.show takes them.
inline std::string namesOfMotionOverlays() {
  std::string names;
  for (const scene::OverlayRow& row : scene::kOverlayRows) {
    if (row.placement == scene::Placement::WholeClip || row.models == scene::OverlayModels::Rigid)
      continue;
    names += (names.empty() ? "'" : ", '") + std::string(row.name) + "'";
  }
  return names;
}

inline physics::Trajectory motionOf(const scene::Scene& scene) {
  return physics::simulate(scene.motions[0].motion(), scene.clip.frameCount());
}

/// A picture of the clip's size in one grey, 0 to 255.
inline image::Image plainPicture(const scene::Scene& scene, std::uint8_t grey) {
  image::Image picture(scene.clip.width, scene.clip.height, image::PixelFormat::Rgba8);
  for (int y = 0; y < picture.height(); ++y) {
    std::uint8_t* row = picture.row(y);
    for (int x = 0; x < picture.width(); ++x, row += 4) {
      row[0] = row[1] = row[2] = grey;
      row[3] = 255;
    }
  }
  return picture;
}

inline image::Image greyPicture(const scene::Scene& scene) {
  return plainPicture(scene, 96);
}

/// Returns the contrast ratio of WCAG 2.1 between the brightest pixel of a text, on a picture of
/// four channels, and the pixel left of its top left, which is its background.
inline double contrastOf(const Box& text, const image::Image& picture) {
  const auto luminance = [&](int x, int y) {
    const std::uint8_t* pixel = picture.row(y) + static_cast<std::ptrdiff_t>(x) * 4;
    const auto linear = [](double value) {
      return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(pixel[0] / 255.0) + 0.7152 * linear(pixel[1] / 255.0) +
           0.0722 * linear(pixel[2] / 255.0);
  };
  const int left = static_cast<int>(text.x), top = static_cast<int>(text.y);
  double brightest = 0;
  for (int y = top; y < static_cast<int>(text.bottom()); ++y) {
    for (int x = left; x < static_cast<int>(text.right()); ++x) {
      brightest = std::max(brightest, luminance(x, y));
    }
  }
  return (brightest + 0.05) / (luminance(left - 4, top) + 0.05);
}

/// The projection of the scene's camera onto the rows above `bottomRows`.
inline Eigen::Matrix4d clipFromWorld(const scene::Scene& scene, int bottomRows) {
  const scene::CameraSettings& camera = scene.camera;
  const Eigen::Vector3d back = (scene.cameraPosition - camera.target).normalized();
  const Eigen::Vector3d right = camera.up.cross(back).normalized();
  Eigen::Matrix4d view = Eigen::Matrix4d::Identity();
  view.topLeftCorner<3, 3>() << right.transpose(), back.cross(right).transpose(), back.transpose();
  view.topRightCorner<3, 1>() = -view.topLeftCorner<3, 3>() * scene.cameraPosition;
  const double share = 1 - static_cast<double>(bottomRows) / scene.clip.height;
  const double scale = 1 / std::tan(camera.fieldOfViewDeg * 3.14159265358979323846 / 360);
  Eigen::Matrix4d clip = Eigen::Matrix4d::Zero();
  clip(0, 0) = scale * share * scene.clip.height / scene.clip.width;
  clip(1, 1) = -scale * share;
  clip(1, 2) = 1 - share;  // the upper share of the picture
  clip(3, 2) = -1;
  return clip * view;
}

/// Makes the overlays of `scene` for its whole picture, without other text.
inline MotionOverlays overlaysOf(const scene::Scene& scene, const physics::Trajectory& trajectory) {
  return {scene, trajectory, {.width = scene.clip.width, .height = scene.clip.height}};
}

/// Draws `overlays` on a grey picture.
inline image::Image drawn(MotionOverlays& overlays, const scene::Scene& scene, std::int64_t frame) {
  image::Image picture = greyPicture(scene);
  overlays.draw(frame, clipFromWorld(scene, overlays.bottomRows()), picture);
  return picture;
}

/// Draws the overlays of `scene` on a grey picture.
inline image::Image drawn(const scene::Scene& scene, std::int64_t frame) {
  const physics::Trajectory trajectory = motionOf(scene);
  MotionOverlays overlays = overlaysOf(scene, trajectory);
  return drawn(overlays, scene, frame);
}

/// The first pair of boxes that meet, if any.
inline std::string meeting(const std::vector<Box>& boxes) {
  const auto text = [](const Box& box) {
    return "(" + std::to_string(box.x) + ", " + std::to_string(box.y) + ") " +
           std::to_string(box.width) + " x " + std::to_string(box.height);
  };
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (boxes[i].meets(boxes[j])) return text(boxes[i]) + " meets " + text(boxes[j]);
    }
  }
  return "";
}

}  // namespace rotatebook::overlay::testing

// A scene: everything a clip depends on, as a plain value.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/frame_rate.h"
#include "physics/motion_settings.h"
#include "scene/expectation.h"
#include "scene/overlays.h"
#include "scene/reference_frame.h"
#include "scene/study_settings.h"

namespace rotatebook::scene {

/// [clip]: the video's format.
struct ClipSettings {
  int width = 1280;  ///< Even. [pixels]
  int height = 720;  ///< Even. [pixels]
  FrameRate frameRate;
  double duration = 12;  ///< Of video, > 0. [s]
  /// Where in the video the picture is that stands for it, >= 0; its middle by default, and its
  /// end if it ends before. [s]
  std::optional<double> poster{};

  /// Frames of the whole clip, >= 1.
  std::int64_t frameCount() const { return frameRate.framesIn(duration); }

  friend bool operator==(const ClipSettings&, const ClipSettings&) = default;
};

/// [video]: how the MP4 is encoded.
struct EncodingSettings {
  int crf = 18;                 ///< x264's constant rate factor, 1 to 51; smaller is better.
  std::string preset = "book";  ///< "book", made for it, or x264's "ultrafast" to "placebo".
  int threads = 1;  ///< Encoder threads, 1 to 64; a different count gives different bytes.

  friend bool operator==(const EncodingSettings&, const EncodingSettings&) = default;
};

/// [camera]: a perspective camera.
struct CameraSettings {
  Eigen::Vector3d position{0, 0, 1};  ///< [m]
  Eigen::Vector3d target{0, 0, 0};    ///< The point in the middle of the picture. [m]
  Eigen::Vector3d up{0, 1, 0};
  /// From the picture's bottom to its top, 1 to 170; in panels over the shorter side. [degrees]
  double fieldOfViewDeg = 30;
  /// What the camera turns with; its position, target and up are along these axes.
  ReferenceFrame frame = ReferenceFrame::World;

  friend bool operator==(const CameraSettings&, const CameraSettings&) = default;
};

/// [book]: picture files, relative to the scene's folder, or kBuiltin.
struct BookSettings {
  std::string front = "builtin";
  std::string spine = "builtin";
  std::string back = "builtin";

  friend bool operator==(const BookSettings&, const BookSettings&) = default;
};

/// What is seen behind the book.
enum class Background {
  Studio,       ///< A quiet, dark wall.
  Stars,        ///< A night sky.
  Transparent,  ///< Nothing, in pictures that have an alpha channel.
};

/// [look]: what is around the book, and how finely it is drawn.
struct LookSettings {
  Background background = Background::Studio;
  int supersample = 1;  ///< 1, or 2 to draw with twice as many pixels across and down.
  /// Moments, a power of two up to 16, of the half frame after each sample whose pictures are
  /// averaged, as by a shutter that is open half of the time; 1 is a sharp picture.
  int motionBlur = 1;

  friend bool operator==(const LookSettings&, const LookSettings&) = default;
};

/// [overlay]: what is written over the pictures.
struct OverlaySettings {
  std::vector<Overlay> show;     ///< Each at most once.
  std::string font = "builtin";  ///< An installed family, or kBuiltin.

  friend bool operator==(const OverlaySettings&, const OverlaySettings&) = default;
};

/// [body], [simulation], [initial] and [expect]: one motion, and what it must show.
struct Motion : physics::MotionSettings {
  std::vector<Expectation> expectations{};

  /// What it is simulated from.
  const physics::MotionSettings& motion() const { return *this; }
  friend bool operator==(const Motion&, const Motion&) = default;
};

/// [[panel]]: one of several motions that a clip shows side by side, with the scene's timePerFrame.
struct Panel : Motion {
  std::string label{};  ///< Not empty, and unlike the others'.

  friend bool operator==(const Panel&, const Panel&) = default;
};

/// The texture or font that ships with the program.
inline constexpr const char* kBuiltin = "builtin";

/// A scene with every default made explicit. With panels, which have been read over the scene's own
/// motion, of that timePerFrame alone is of use.
struct Scene : Motion {
  std::string name;              ///< The scene file's stem; outputs are named after it.
  std::filesystem::path folder;  ///< Where the scene's file lies; textures are found from here.
  /// Whether textures may lie outside of it. Of whoever reads the scene, never of its file.
  bool allowOutside = false;
  /// Whether its pictures go without words, letters and charts, as thumbnails do. Of whoever draws
  /// the scene, never of its file.
  bool wordless = false;
  std::string title;
  std::string caption;
  ClipSettings clip;
  EncodingSettings video;
  CameraSettings camera;
  BookSettings book;
  LookSettings look;
  OverlaySettings overlay;
  std::vector<Panel> panels;  ///< None, or 2 to 6.
  std::optional<StudySettings> study;
  /// Where texts stand that can prove wrong only when files and fonts are opened, by key, such as
  /// "overlay.font"; those that are stated. See scene/source_locations.h.
  std::map<std::string, std::string, std::less<>> locations;

  friend bool operator==(const Scene&, const Scene&) = default;
};

/// Whether the scene's pictures have an alpha that is to be kept.
bool isTransparent(const Scene& scene);

/// All that moves in a scene: its panels, or the scene itself as the only one, without a label.
std::vector<Panel> motionsOf(const Scene& scene);
/// `scene` as if `motion` were all that moves in it.
Scene withMotion(Scene scene, const Motion& motion);

/// Whether `overlay` is drawn over the pictures of `scene`: where they are wordless, only what is
/// on the book itself.
bool shows(const Scene& scene, Overlay overlay);

/// The camera position from which a body of this size is seen whole in any attitude. [m]
Eigen::Vector3d defaultCameraPosition(const physics::Cuboid& body, double fieldOfViewDeg, int width,
                                      int height);

}  // namespace rotatebook::scene

// A scene: what its file states, and what follows from that.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/document/locations.h"
#include "base/frame_rate.h"
#include "base/layout.h"
#include "base/rgb.h"
#include "physics/motion_settings.h"
#include "scene/expectation.h"
#include "scene/grid_settings.h"
#include "scene/map_settings.h"
#include "scene/moment.h"
#include "scene/overlays.h"
#include "scene/playback_speed.h"
#include "scene/reference_frame.h"
#include "scene/solid.h"
#include "scene/study_settings.h"
#include "scene/words.h"

namespace rotatebook::scene {

/// [clip]: the video's format.
struct ClipSettings {
  int width = 1280;  ///< Even. [pixels]
  int height = 720;  ///< Even. [pixels]
  FrameRate frameRate;
  double duration = 12;  ///< Length of the video, > 0. [s]
  /// Time of the poster, the picture that represents the video, >= 0; the middle by default, and
  /// the end of a video that ends before. [s]
  std::optional<double> poster{};
  /// Speed of the motion, from which SimulationSettings::timePerFrame follows: from a constant one,
  /// or from speed 1. Without it, that time is stated itself.
  std::optional<PlaybackSpeed> speed{};

  /// Returns the number of frames of the whole clip, >= 1.
  std::int64_t frameCount() const { return frameRate.framesIn(duration); }

  friend bool operator==(const ClipSettings&, const ClipSettings&) = default;
};

/// A move of the camera, eased at both ends; what isn't stated stays. Its path goes round the
/// target, and doesn't cross it.
struct CameraMove {
  std::optional<Eigen::Vector3d> position{};  ///< In the end, but for `orbit`. [m]
  std::optional<Eigen::Vector3d> target{};    ///< In the end. [m]
  std::optional<double> fieldOfViewDeg{};     ///< In the end, 1 to 170. [degrees]
  double orbit = 0;  ///< Turn about the target and `up`, to the right as the camera sees it. [rad]
  double over = 2;   ///< Length of the move, > 0. [s] of video

  friend bool operator==(const CameraMove&, const CameraMove&) = default;
};

/// [[cue]]: what a clip says, does or is called from a moment on.
struct Cue {
  Moment at{};
  /// The caption until the next cue with a text; empty for none. Without it, the one before stays.
  std::optional<std::string> text{};
  double hold = 0;                   ///< For so long the motion stands. [s] of video
  std::string chapter{};             ///< Begins one of that name, unless it is empty.
  std::optional<CameraMove> move{};  ///< The camera begins to move so.

  friend bool operator==(const Cue&, const Cue&) = default;
};

/// [video]: how the MP4 is encoded.
struct EncodingSettings {
  int crf = 18;                 ///< x264's constant rate factor, 1 to 51; smaller is better.
  std::string preset = "book";  ///< This program's "book", or x264's "ultrafast" to "placebo".
  int threads = 1;  ///< Encoder threads, 1 to 64; a different count gives different bytes.

  friend bool operator==(const EncodingSettings&, const EncodingSettings&) = default;
};

/// The change of the body that the camera follows.
enum class Follow {
  None,  ///< The camera keeps its distance.
  Size,  ///< It draws back when the body grows; see timeline::CameraDistances.
};

/// The bodies of panels for which the camera has one distance.
enum class Fit {
  All,   ///< All: they are shown in their proportions.
  Each,  ///< Each has its own, in proportion to its size: all are shown equally large.
};

/// [camera]: a perspective camera.
struct CameraSettings {
  /// Without it, Scene::cameraPosition is such that the whole body is seen. [m]
  std::optional<Eigen::Vector3d> position{};
  Eigen::Vector3d target{0, 0, 0};  ///< The point in the middle of the picture. [m]
  Eigen::Vector3d up{0, 1, 0};
  /// Angle of view from the picture's bottom to its top, 1 to 170; in panels, over the shorter
  /// side. [degrees]
  double fieldOfViewDeg = 30;
  /// The reference frame that the camera turns with; position, target and up are along its axes.
  ReferenceFrame frame = ReferenceFrame::World;
  Follow follow = Follow::None;
  Fit fit = Fit::All;

  friend bool operator==(const CameraSettings&, const CameraSettings&) = default;
};

/// [book]: texture files, relative to the scene's folder, or kBuiltin; and the cloth's colour.
struct BookSettings {
  std::string front = "builtin";
  std::string spine = "builtin";
  std::string back = "builtin";
  /// Of plain cloth on the sides that are kBuiltin; without it they have the built-in textures.
  std::optional<Rgb> colour{};

  friend bool operator==(const BookSettings&, const BookSettings&) = default;
};

/// The background behind the book.
enum class Background {
  Studio,       ///< A quiet, dark wall.
  Stars,        ///< A night sky.
  Transparent,  ///< None, in pictures with an alpha channel.
  Plain,        ///< LookSettings::plainColour throughout.
};

/// [look]: the background, and the quality of drawing.
struct LookSettings {
  Background background = Background::Studio;
  int supersample = 1;  ///< 1, or 2 to draw with twice as many pixels across and down.
  /// Number of moments averaged in a picture, a power of two up to 16; they lie in the half frame
  /// after each sample, as for a shutter that is open half of the time. 1 gives a sharp picture.
  int motionBlur = 1;
  Rgb plainColour{};  ///< For Background::Plain.
  bool body = true;   ///< False draws overlays alone.

  friend bool operator==(const LookSettings&, const LookSettings&) = default;
};

/// [overlay]: what is drawn over the pictures, and its font.
struct OverlaySettings {
  std::vector<Overlay> show;     ///< Overlays to draw, each at most once.
  std::string font = "builtin";  ///< An installed family, or kBuiltin.
  double scale = 1;              ///< Size of letters, lines and charts, 0.5 to 3.
  Words words;                   ///< Of the pictures, in one language.
  bool band = true;              ///< False leaves out the dark ground of the text at the bottom.

  friend bool operator==(const OverlaySettings&, const OverlaySettings&) = default;
};

/// [body], [simulation], [initial] and [expect]: one motion, and what it must show.
struct Motion : physics::MotionSettings {
  /// The body that isn't the book; size, mass and inertia above follow from it.
  Solid solid{};
  std::vector<Expectation> expectations{};
  document::Locations locations{};  ///< Of what the scene states for it: "simulation.step".

  /// Returns the settings that the motion is simulated from.
  const physics::MotionSettings& motion() const { return *this; }
  friend bool operator==(const Motion&, const Motion&) = default;
};

/// [[panel]]: one of several motions that a clip shows side by side, with the scene's timePerFrame.
struct Panel : Motion {
  std::string label{};  ///< Not empty; no two panels have the same.
  /// The reference frame in which the camera sees it, in place of CameraSettings::frame.
  std::optional<ReferenceFrame> frame{};

  friend bool operator==(const Panel&, const Panel&) = default;
};

/// A run of a study.
struct StudyRun {
  std::string value;  ///< The label of the value.
  std::string curve;  ///< The label of the curve; empty if there is no second key.
  Motion motion;

  friend bool operator==(const StudyRun&, const StudyRun&) = default;
};

/// The name of the texture or font that ships with the program.
inline constexpr const char* kBuiltin = "builtin";

/// A scene as its file states it, and nothing that follows: the numbers of a body that is a solid,
/// the vector of a spin about an axis, places of particles, and, with clip.speed, timePerFrame keep
/// their defaults.
struct Spec {
  std::string name;              ///< The scene file's stem; outputs are named after it.
  std::filesystem::path folder;  ///< Folder of the scene's file; textures are found from here.
  /// The file that overlay.words names; empty if it names none.
  std::filesystem::path wordsFile;
  std::string title;
  std::string caption;
  std::vector<Cue> cues;  ///< As they are stated.
  ClipSettings clip;
  EncodingSettings video;
  CameraSettings camera;
  BookSettings book;
  LookSettings look;
  OverlaySettings overlay;
  /// The common part of all panels, cells and runs; not complete with panels.
  Motion motion;
  /// The motions side by side: of the panels, 2 to 6, of the grid's cells row by row, or a single
  /// one without a label. Each has taken from `motion` what isn't stated for it alone.
  std::vector<Panel> motions{Panel{}};
  std::optional<GridSettings> grid;
  std::optional<StudySettings> study;
  std::vector<StudyRun> runs;  ///< Of the study, curve by curve, each in the order of the values.
  std::optional<MapSettings> map;
  document::Locations locations;  ///< Of all that the file states.

  /// Returns whether there are several motions, of panels or of a grid.
  bool hasPanels() const { return motions.size() > 1; }
  friend bool operator==(const Spec&, const Spec&) = default;
};

/// A cue at its place in a clip.
struct ShownCue {
  std::size_t cue = 0;     ///< Its index in Spec::cues.
  double time = 0;         ///< Of the motion, >= 0. [s]
  std::int64_t frame = 0;  ///< The first one that shows it; Spec's frameCount() if none does.

  friend bool operator==(const ShownCue&, const ShownCue&) = default;
};

/// A scene whose motions and runs have what follows from its Spec, computed once. All motions have
/// one timePerFrame.
struct Scene : Spec {
  Eigen::Vector3d cameraPosition{0, 0, 1};  ///< [m]
  /// The speeds with the holds of cues and the moments of the motion in their places; none where
  /// clip.speed, or timePerFrame(), says all.
  std::optional<PlaybackSpeed> schedule{};
  std::vector<ShownCue> shownCues;  ///< In the order of their times.
  /// Allows textures outside `folder`. Set by whoever reads the scene.
  bool allowOutside = false;
  /// Draws pictures without text, letters and charts, as thumbnails are. Set by whoever draws it.
  bool textless = false;

  /// Returns the simulated time from a frame to the next, unless the speed changes. [s]
  double timePerFrame() const { return motions.front().simulation.timePerFrame; }
  friend bool operator==(const Scene&, const Scene&) = default;
};

/// Returns whether the scene's pictures have an alpha channel, which is to be kept.
bool isTransparent(const Spec& scene);

/// Returns the simulated time that `frame` of the clip shows, >= 0; of a part of a frame, too. [s]
double timeAt(const Scene& scene, double frame);
/// Returns the stated speed of the motion in `frame`, in simulated time over time of video, >= 0.
double speedAt(const Scene& scene, double frame);
/// Returns all stated speeds of the clip, each >= 0.
std::vector<double> speedsOf(const Scene& scene);
/// Returns the caption that `frame` shows; empty if there is none.
const std::string& captionAt(const Scene& scene, std::int64_t frame);
/// Returns whether the times of the clip's frames are even.
bool hasEvenTimes(const Scene& scene);
/// Has samples taken of `motion` as `study` asks for, by the same steps.
void sampleAsAsked(const StudySettings& study, physics::MotionSettings& motion);
/// Returns the number of samples that `study` takes of a motion, >= 1: one for each frame of the
/// clip, unless it states a duration or an interval.
std::int64_t studiedSamples(const Scene& scene, const StudySettings& study,
                            const physics::MotionSettings& motion);
/// Returns the integration steps that so many samples of a motion in steps take, >= 1.
std::int64_t studiedSteps(const physics::MotionSettings& motion, std::int64_t samples);
/// Returns `scene` with `motion` as its only motion.
Scene withMotion(Scene scene, Panel motion);

/// Returns the reference frame in which the camera sees each of the scene's motions.
std::vector<MotionFrame> referenceFramesOf(const Scene& scene);

/// Returns whether `overlay` is drawn over the pictures of `scene`: on textless pictures, only if
/// it is on the body.
bool shows(const Scene& scene, Overlay overlay);

/// Returns the radius of the largest sphere around the camera's target that a picture of this shape
/// shows whole. [m]
double radiusInView(const Scene& scene, int width, int height);

/// The size of what the default camera shows around a body, in sizes of the body.
inline constexpr double kRoomAround = 1.08;
/// Returns the camera position from which a body of this size is seen whole in any attitude. [m]
Eigen::Vector3d defaultCameraPosition(const body::Cuboid& body, double fieldOfViewDeg, int width,
                                      int height);

extern const std::size_t kSceneSize;  // in the library
namespace {
[[maybe_unused]] const bool kSceneIsSame = noteSize("scene::Scene", kSceneSize, sizeof(Scene));
}  // namespace

}  // namespace rotatebook::scene

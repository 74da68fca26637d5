// [clip], [video], [camera], [book], [look] and [overlay]: how the motion is shown.
#include <algorithm>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <Eigen/Geometry>

#include "base/clip_limits.h"
#include "scene/names.h"
#include "scene/sections.h"

namespace rotatebook::scene {
namespace {

constexpr int kSmallestPicture = 16;
constexpr int kMostFrames = 1'000'000;  // Their trajectory takes some 400 MB.
constexpr int kMostThreads = 64;
constexpr int kMostSupersample = 2;
constexpr unsigned kMostMoments = 16;    // Of motion blur.
constexpr double kLeastDistance = 1e-9;  // [m]
constexpr double kLeastSine = 1e-6;  // Of the angle between two directions that aren't parallel.

constexpr NumberRange kPoints{"three numbers from -1e9 to 1e9", -1e9, 1e9};
constexpr NumberRange kTimes{"a time in the clip, 0 or more seconds", 0, kPositive.max};
constexpr NumberRange kAngles{"an angle from 1 to 170 degrees", 1, 170};

// H.264 with its colour at half the resolution has no odd sizes.
int pictureSide(const ValueReader& value) {
  const int side = value.integer(kSmallestPicture, kMaxPictureSide);
  if (side % 2 != 0) {
    value.fail(value.name() + " must be even, not " + std::to_string(side) +
               "; the nearest even sizes are " + std::to_string(side - 1) + " and " +
               std::to_string(side + 1));
  }
  return side;
}

void readPictureSize(const ValueReader& value, ClipSettings& clip) {
  const auto sides = value.elements(2, "a width and a height, such as [1280, 720]");
  clip.width = pictureSide(sides[0]);
  clip.height = pictureSide(sides[1]);
  const int pixels = clip.width * clip.height;  // Of 16384x16384 they are fewer than 2^31.
  if (pixels > kMaxPicturePixels) {
    value.fail(value.name() + " has " + std::to_string(pixels) + " pixels; the limit is " +
               std::to_string(kMaxPicturePixels) + ", for example [8192, 4352]");
  }
}

FrameRate frameRateFrom(const ValueReader& value) {
  std::string text;
  if (const auto* whole = std::get_if<std::int64_t>(&value.node().value)) {
    text = std::to_string(*whole);
  } else if (const auto* fraction = std::get_if<std::string>(&value.node().value)) {
    text = *fraction;
  }
  const std::optional<FrameRate> rate = parseFrameRate(text);
  if (!rate) {
    value.mismatch(
        "frames a second from 1 to 1000, an integer or a fraction such as \"30000/1001\"");
  }
  return *rate;
}

// A camera is only ever wrong through one of the keys that are there.
[[noreturn]] void failAtFirst(const ValueReader& section,
                              std::initializer_list<std::string_view> keys,
                              const std::string& problem) {
  for (const std::string_view key : keys) {
    if (const auto value = section.find(key)) value->fail(problem);
  }
  section.fail(problem);
}

// Any texture within reach of the scene's folder, so that a clip names no place of the machine it
// was made on.
std::string textureFrom(const ValueReader& value) {
  std::string texture = value.text(kLongestPath);
  if (texture.empty() || std::filesystem::path(texture).is_absolute()) {
    value.mismatch("\"builtin\" or a picture's path from the scene's folder");
  }
  return texture;
}

// A power of two, by which times divide without rounding: blurred or not, the motion is the same.
int momentsFrom(const ValueReader& value) {
  const int moments = value.integer(1, kMostMoments);
  if (!std::has_single_bit(static_cast<unsigned>(moments))) value.mismatch("1, 2, 4, 8 or 16");
  return moments;
}

std::vector<Overlay> overlaysFrom(const ValueReader& value) {
  const auto* array = std::get_if<TomlNode::Array>(&value.node().value);
  if (array == nullptr) value.mismatch("a list of overlays, such as [\"caption\", \"clock\"]");
  std::vector<Overlay> overlays;
  for (const ValueReader& element : value.elements(array->size(), "a list of overlays")) {
    const auto overlay = element.oneOf(kOverlays);
    if (std::ranges::count(overlays, overlay) > 0) {
      element.fail(element.name() + " has " + std::string(nameOf(kOverlays, overlay)) + " twice");
    }
    overlays.push_back(overlay);
  }
  return overlays;
}

/// Why `scene`, none of whose motions has `overlay`, doesn't have it.
std::string absence(Overlay overlay, const Scene& scene) {
  const std::string name(nameOf(kOverlays, overlay));
  if (rowOf(overlay).models == OverlayModels::Particles) {
    return name + " are only of the particles model; " +
           (scene.panels.empty()
                ? "this scene's is " + std::string(nameOf(kModels, scene.simulation.model))
                : "no panel of this scene has it");
  }
  return name + " shows how far a motion is from the exact one, and this scene's is the exact one";
}

}  // namespace

void readClip(const ValueReader& section, ClipSettings& clip) {
  section.readTable({
      {"size", [&](const ValueReader& value) { readPictureSize(value, clip); }},
      {"fps", [&](const ValueReader& value) { clip.frameRate = frameRateFrom(value); }},
      {"duration", [&](const ValueReader& value) { clip.duration = value.number(kPositive); }},
      {"poster", [&](const ValueReader& value) { clip.poster = value.number(kTimes); }},
  });

  // framesIn() counts in 64 bits, which an absurd duration would overflow. The default duration is
  // right at any rate, so that a wrong one is in the file.
  const bool tooMany = clip.duration / clip.frameRate.period() > kMostFrames;
  if (tooMany || clip.frameCount() < 1) {
    section.find("duration")
        ->mismatch("long enough for 1 frame and short enough for " + std::to_string(kMostFrames) +
                   " at " + clip.frameRate.text() + " frames a second");
  }
}

void readVideo(const ValueReader& section, EncodingSettings& video) {
  section.readTable({
      {"crf", [&](const ValueReader& value) { video.crf = value.integer(kBestCrf, kWorstCrf); }},
      {"preset",
       [&](const ValueReader& value) {
         video.preset = kVideoPresets[value.choice(kVideoPresets)];
       }},
      {"threads",
       [&](const ValueReader& value) { video.threads = value.integer(1, kMostThreads); }},
  });
}

void readCamera(const ValueReader& section, CameraSettings& camera) {
  section.readTable({
      {"position", [&](const ValueReader& value) { camera.position = value.vector(kPoints); }},
      {"target", [&](const ValueReader& value) { camera.target = value.vector(kPoints); }},
      {"up", [&](const ValueReader& value) { camera.up = value.direction(); }},
      {"field_of_view_deg",
       [&](const ValueReader& value) { camera.fieldOfViewDeg = value.number(kAngles); }},
      {"frame", [&](const ValueReader& value) { camera.frame = value.oneOf(kFrames); }},
  });
}

void readBook(const ValueReader& section, BookSettings& book) {
  section.readTable({
      {"front", [&](const ValueReader& value) { book.front = textureFrom(value); }},
      {"spine", [&](const ValueReader& value) { book.spine = textureFrom(value); }},
      {"back", [&](const ValueReader& value) { book.back = textureFrom(value); }},
  });
}

void readLook(const ValueReader& section, LookSettings& look) {
  section.readTable({
      {"background",
       [&](const ValueReader& value) { look.background = value.oneOf(kBackgrounds); }},
      {"supersample",
       [&](const ValueReader& value) { look.supersample = value.integer(1, kMostSupersample); }},
      {"motion_blur", [&](const ValueReader& value) { look.motionBlur = momentsFrom(value); }},
  });
}

void checkMotionBlur(const ValueReader& section, const Scene& scene) {
  const int moments = scene.look.motionBlur, least = 2 * moments;
  if (moments == 1) return;
  for (const Panel& panel : motionsOf(scene)) {
    const int substeps = panel.simulation.substeps;
    const bool exact = panel.simulation.model == physics::Model::Exact;
    if (exact || substeps % least == 0) continue;
    section.find("motion_blur")
        ->fail("look.motion_blur = " + std::to_string(moments) +
               " needs simulation.substeps to be a multiple of " + std::to_string(least) +
               ", not " + std::to_string(substeps) + "; the next is " +
               std::to_string((substeps / least + 1) * least));
  }
}

void readOverlay(const ValueReader& section, OverlaySettings& overlay) {
  section.readTable({
      {"show", [&](const ValueReader& value) { overlay.show = overlaysFrom(value); }},
      {"font", [&](const ValueReader& value) { overlay.font = value.text(kLongestName); }},
  });
}

void checkOverlays(const ValueReader& section, const Scene& scene) {
  const std::vector<Overlay>& show = scene.overlay.show;
  const std::vector<Panel> motions = motionsOf(scene);
  for (std::size_t i = 0; i < show.size(); ++i) {
    const auto hasIt = [&](const Panel& panel) { return isFor(panel.simulation.model, show[i]); };
    if (std::ranges::any_of(motions, hasIt)) continue;
    const auto names = section.find("show")->elements(show.size(), "a list of overlays");
    names[i].fail(names[i].name() + ": " + absence(show[i], scene));
  }
}

void checkCamera(const ValueReader& section, const CameraSettings& camera) {
  const Eigen::Vector3d view = camera.target - camera.position;
  if (view.norm() < kLeastDistance) {
    failAtFirst(section, {"position", "target"},
                "camera.position and camera.target must be different points");
  }
  const double sine = view.stableNormalized().cross(camera.up.stableNormalized()).norm();
  if (sine < kLeastSine) {
    failAtFirst(
        section, {"up", "position", "target"},
        "camera.up must not be parallel to the direction from camera.position to camera.target");
  }
}

}  // namespace rotatebook::scene

#include "bridge/bridge.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/checksum.h"
#include "base/document/toml_json.h"
#include "base/error.h"
#include "bridge/body_mesh.h"
#include "bridge/played_scene.h"
#include "bridge/record_search.h"
#include "bridge/recordings.h"
#include "bridge/scene_json.h"
#include "bridge/why_numbers.h"
#include "geometry/book_mesh.h"
#include "scene/scene_text.h"
#include "timeline/motion_checksum.h"
#include "timeline/trajectory_csv.h"

namespace rotatebook::bridge {
namespace {

constexpr std::size_t kBufferSize = 1 << 20;
// The depth that is seen around the body, where the arrows of a spin are: in sizes of the body.
constexpr double kDepthAround = 6;

alignas(16) std::array<char, kBufferSize> buffer;
std::array<std::optional<PlayedScene>, kSlots> slots;
std::map<std::pair<std::int32_t, std::int32_t>, PlayedForces> playedForces;  // by slot and motion
std::string lastMessage;
std::map<std::string, std::string> files;  // by name
RecordSearch search{0};

/// Copies `text` to the buffer as far as there is room; returns its length.
std::int32_t answer(std::string_view text) {
  const std::size_t length = std::min(text.size(), buffer.size());
  std::copy_n(text.begin(), length, buffer.begin());
  return static_cast<std::int32_t>(length);
}

/// Answers with the text that `make` returns, or else with the message of what it throws.
template <typename Make>
std::int32_t answerOf(const Make& make) {
  try {
    return answer(make());
  } catch (const std::exception& error) {
    return -std::max(answer(error.what()), 1);
  }
}

std::string_view given(std::int32_t length) {
  const auto most = static_cast<std::int32_t>(buffer.size());
  return {buffer.data(), static_cast<std::size_t>(std::clamp(length, 0, most))};
}

/// Takes a file from the buffer; see rb_file().
void takeFile(std::int32_t nameLength, std::int32_t length) {
  if (nameLength == 0 && length == 0) return files.clear();
  const auto size = static_cast<std::int64_t>(buffer.size());
  if (nameLength < 0 || length < 0 || std::int64_t{nameLength} + length > size) {
    throw std::out_of_range("a file of " + std::to_string(length) + " bytes doesn't fit in");
  }
  const std::string name(buffer.data(), static_cast<std::size_t>(nameLength));
  if (files.size() == kMaxFiles && !files.contains(name)) {
    throw std::out_of_range("there are " + std::to_string(kMaxFiles) + " files already");
  }
  files[name].assign(buffer.data() + nameLength, static_cast<std::size_t>(length));
}

/// Returns the text of a file that was taken.
std::string takenFile(const std::filesystem::path& file, std::size_t most) {
  const auto found = files.find(file.generic_string());
  if (found == files.end()) throw InputError("can't read " + file.string() + ": it isn't here");
  if (found->second.size() <= most) return found->second;
  throw InputError("can't read " + file.string() + ": it is longer than " + std::to_string(most) +
                   " bytes");
}

/// Reads a scene with the files that were taken, if there are any.
scene::Scene sceneFrom(std::string_view text) {
  if (files.empty()) return scene::parseScene(text, "scene.toml");
  return scene::parseScene(text, "scene.toml", {}, takenFile);
}

std::optional<PlayedScene>& slotAt(std::int32_t slot) {
  if (slot >= 0 && slot < kSlots) return slots[static_cast<std::size_t>(slot)];
  throw std::out_of_range("there is no slot " + std::to_string(slot));
}

PlayedScene& in(std::int32_t slot) {
  std::optional<PlayedScene>& held = slotAt(slot);
  if (!held) throw std::out_of_range("slot " + std::to_string(slot) + " holds no scene");
  return *held;
}

/// Returns what `make` returns, or `otherwise` if it throws.
template <typename Value, typename Make>
Value valueOr(Value otherwise, const Make& make) {
  try {
    return make();
  } catch (const std::exception&) {
    return otherwise;
  }
}

/// Returns a picture's side as whole pixels; 1 of what isn't a number.
int pixels(float side) {
  constexpr float kMaxSide = 65'536;
  return side >= 1 ? static_cast<int>(std::min(side, kMaxSide)) : 1;
}

const timeline::ClipMotion& wholeIn(std::int32_t slot) {
  const timeline::ClipMotion* motion = in(slot).whole();
  if (motion == nullptr) throw std::runtime_error("the motions aren't simulated to their end");
  return *motion;
}

BodyMesh lastBody;  // of rb_body()

/// Returns the JSON of a motion's body, which becomes lastBody.
std::string makeBody(std::int32_t slot, std::int32_t motion) {
  const std::vector<scene::Panel>& motions = in(slot).scene().motions;
  const scene::Panel& panel = motions.at(static_cast<std::size_t>(motion));
  if (panel.solid.isBook()) return "null";
  lastBody = bodyMeshOf(panel, [](const std::string& name) {
    const auto found = files.find(name);
    return found == files.end() ? nullptr : &found->second;
  });
  return lastBody.json;
}

std::array<double, kSampleNumbers> numbersOf(const physics::Sample& sample, bool isHeld) {
  std::array<double, kSampleNumbers> numbers{};
  const auto put = [&](std::size_t first, const auto& values) {
    std::copy_n(values.data(), values.size(), numbers.begin() + static_cast<std::ptrdiff_t>(first));
  };
  numbers[kTime] = sample.time;
  numbers[kAttitude] = sample.attitude.w();
  put(kAttitude + 1, Eigen::Vector3d(sample.attitude.vec()));
  put(kAngularVelocity, sample.angularVelocity);
  put(kAngularMomentum, sample.angularMomentum);
  put(kEnergies, Eigen::Vector3d(sample.kinetic, sample.potential, sample.rotational));
  numbers[kTilt] = sample.tiltDeg;
  numbers[kHalfTurns] = sample.halfTurns;
  numbers[kStretch] = sample.stretchMin;
  numbers[kStretch + 1] = sample.stretchMax;
  numbers[kError] = sample.errorDeg;
  numbers[kRegime] = static_cast<double>(sample.regime);
  numbers[kHeld] = isHeld ? 1 : 0;
  put(kCorners, sample.cage);
  return numbers;
}

/// Returns the sky that a camera sees which turns or moves; 0 of others.
Eigen::Matrix4d skyOf(const PlayedScene& played, std::size_t motion, std::int32_t frame,
                      const geometry::Camera& camera, const geometry::Screen& screen) {
  if (!played.turns()) return Eigen::Matrix4d::Zero();
  const physics::Sample& sample = played.samples(motion)[played.indexOf(motion, frame)];
  return geometry::skyFromPicture(camera, screen,
                                  played.frameOf(motion).fromWorld(sample).transpose());
}

/// Returns the address of the numbers that `make` returns, and how many there are.
template <typename Make>
const double* numbersFor(std::int32_t* count, const Make& make) {
  static std::vector<double> numbers;
  *count = 0;
  return valueOr<const double*>(nullptr, [&]() -> const double* {
    numbers = make();
    *count = static_cast<std::int32_t>(numbers.size());
    return numbers.data();
  });
}

std::vector<double> forcesIn(std::int32_t slot, std::int32_t motion, std::int32_t frame) {
  const PlayedScene& played = in(slot);
  const auto key = std::pair(slot, motion);
  auto found = playedForces.find(key);
  if (found == playedForces.end()) {
    const PlayedForces made(played, static_cast<std::size_t>(motion));
    found = playedForces.emplace(key, made).first;
  }
  return found->second.at(played, frame);
}

}  // namespace
}  // namespace rotatebook::bridge

using namespace rotatebook;
using namespace rotatebook::bridge;

char* rb_buffer() {
  return buffer.data();
}

std::int32_t rb_buffer_size() {
  return static_cast<std::int32_t>(buffer.size());
}

std::int32_t rb_words() {
  return answerOf([] { return jsonText(wordsJson()); });
}

std::int32_t rb_toml_to_json(std::int32_t length) {
  return answerOf(
      [&] { return document::jsonOf(document::parseToml(given(length), "scene.toml")); });
}

std::int32_t rb_json_to_toml(std::int32_t length) {
  return answerOf([&] { return document::documentText(document::nodeOfJson(given(length))); });
}

std::int32_t rb_file(std::int32_t nameLength, std::int32_t length) {
  return answerOf([&] {
    takeFile(nameLength, length);
    return "";
  });
}

const double* rb_flight(const double* readings, std::int32_t readingCount, std::int32_t* count) {
  return numbersFor(count, [&] { return flightNumbers(readings, readingCount); });
}

std::int32_t rb_recording(std::int32_t length) {
  return answerOf([&] {
    const std::string name(given(length));
    return jsonText(recordingJson(takenFile(name, kBufferSize), name));
  });
}

std::int32_t rb_read(std::int32_t slot, std::int32_t length) {
  return answerOf([&] {
    std::optional<PlayedScene>& held = slotAt(slot);
    scene::Scene scene = sceneFrom(given(length));
    const bool keepsMotions = held && held->hasMotionsOf(scene);
    std::optional<PlayedScene> played;
    if (!keepsMotions) played.emplace(scene);
    std::string json = jsonText(sceneJson(scene));
    playedForces.clear();
    if (keepsMotions) {
      held->replace(std::move(scene));
    } else {
      held = std::move(played);
    }
    return json;
  });
}

std::int32_t rb_scene_text(std::int32_t slot) {
  return answerOf([&] { return scene::sceneText(in(slot).scene()); });
}

std::int32_t rb_advance(std::int32_t slot, std::int32_t frame, std::int32_t steps) {
  try {
    return static_cast<std::int32_t>(in(slot).advance(frame, steps));
  } catch (const std::exception& error) {
    lastMessage = error.what();
    return -1;
  }
}

std::int32_t rb_message() {
  return answer(lastMessage);
}

std::int32_t rb_frames(std::int32_t slot) {
  return valueOr(0, [&] { return static_cast<std::int32_t>(in(slot).frameCount()); });
}

const double* rb_sample(std::int32_t slot, std::int32_t motion, std::int32_t frame) {
  static std::array<double, kSampleNumbers> numbers;
  const auto index = static_cast<std::size_t>(motion);
  const auto take = [&]() -> const double* {
    numbers = numbersOf(in(slot).sample(index, frame), in(slot).isHeld(index, frame));
    return numbers.data();
  };
  return valueOr<const double*>(nullptr, take);
}

std::int32_t rb_checksum(std::int32_t slot) {
  return answerOf([&] { return timeline::motionChecksum(wholeIn(slot)); });
}

std::int32_t rb_table_checksum(std::int32_t slot) {
  return answerOf([&] {
    Checksum sum;
    for (const physics::Trajectory& trajectory : wholeIn(slot).trajectories()) {
      sum.add(timeline::trajectoryCsv(trajectory));
    }
    return sum.text();
  });
}

void rb_clip(double size) {
  search = RecordSearch(static_cast<std::uint64_t>(size > 0 ? std::min(size, 0x1p53) : 0));
}

double rb_clip_offset() {
  return static_cast<double>(search.next());
}

std::int32_t rb_record(std::int32_t length) {
  return answerOf([&] { return search.take(given(length)); });
}

const float* rb_mesh_vertices(std::int32_t* count) {
  *count = static_cast<std::int32_t>(bookMesh().vertices.size() / 10);
  return bookMesh().vertices.data();
}

const std::uint16_t* rb_mesh_indices(std::int32_t part, std::int32_t* count) {
  *count = 0;
  if (part < 0 || part >= static_cast<std::int32_t>(geometry::kBookPartCount)) return nullptr;
  const auto& indices = bookMesh().indices[static_cast<std::size_t>(part)];
  *count = static_cast<std::int32_t>(indices.size());
  return indices.data();
}

std::int32_t rb_body(std::int32_t slot, std::int32_t motion) {
  return answerOf([&] { return makeBody(slot, motion); });
}

const float* rb_body_vertices() {
  return lastBody.vertices.data();
}

const std::uint32_t* rb_body_indices() {
  return lastBody.indices.data();
}

std::int32_t rb_camera(std::int32_t slot, std::int32_t motion, std::int32_t frame, float width,
                       float height, const double* orbit, double distance, float* matrix,
                       float* eye, float* sky) {
  const geometry::Screen screen{pixels(width), pixels(height), 0};
  const auto index = static_cast<std::size_t>(motion);
  return valueOr(0, [&] {
    const PlayedScene& played = in(slot);
    const geometry::Camera camera =
        played.camera(index, frame, screen, {orbit[0], orbit[1], distance});
    const body::Cage around = kDepthAround * played.sample(index, frame).cage;
    Eigen::Matrix4d clipFromWorld = geometry::project(camera, around, screen).clipFromWorld;
    clipFromWorld.row(1) *= -1;  // The program's clip y points down.
    Eigen::Map<Eigen::Matrix4f>{matrix} = clipFromWorld.cast<float>();
    Eigen::Map<Eigen::Vector3f>{eye} = camera.position.cast<float>();
    Eigen::Map<Eigen::Matrix4f>{sky} = skyOf(played, index, frame, camera, screen).cast<float>();
    return 1;
  });
}

const double* rb_forces(std::int32_t slot, std::int32_t motion, std::int32_t frame,
                        std::int32_t* count) {
  return numbersFor(count, [&] { return forcesIn(slot, motion, frame); });
}

const double* rb_ladder(std::int32_t slot, std::int32_t motion, std::int32_t frame,
                        std::int32_t* count) {
  return numbersFor(
      count, [&] { return ladderNumbers(in(slot), static_cast<std::size_t>(motion), frame); });
}

const double* rb_poinsot(std::int32_t slot, std::int32_t motion, std::int32_t frame,
                         std::int32_t trail, std::int32_t* count) {
  return numbersFor(count, [&] {
    return poinsotNumbers(in(slot), static_cast<std::size_t>(motion), frame, trail);
  });
}

std::int32_t rb_spin(std::int32_t slot, std::int32_t motion) {
  return answerOf([&] {
    return jsonText(spinJson(in(slot).scene().motions.at(static_cast<std::size_t>(motion))));
  });
}

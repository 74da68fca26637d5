#include "bridge/bridge.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <exception>
#include <string>
#include <vector>

#include "base/checksum.h"
#include "base/document/toml_json.h"
#include "bridge/context.h"
#include "bridge/recordings.h"
#include "bridge/scene_json.h"
#include "geometry/book_mesh.h"
#include "scene/scene_text.h"
#include "timeline/motion_checksum.h"
#include "timeline/trajectory_csv.h"

namespace rotatebook::bridge {
namespace {

// The depth that is seen around the body, where the arrows of a spin are: in sizes of the body.
constexpr double kDepthAround = 6;

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

}  // namespace
}  // namespace rotatebook::bridge

using namespace rotatebook;
using namespace rotatebook::bridge;

rb_context* rb_new(std::int32_t maxFrames, std::int32_t bufferSize) {
  const auto size = static_cast<std::size_t>(bufferSize > 0 ? bufferSize : kBufferSize);
  return valueOr<rb_context*>(
      nullptr, [&] { return new rb_context(maxFrames > 0 ? maxFrames : kMaxFrames, size); });
}

void rb_delete(rb_context* context) {
  delete context;
}

char* rb_buffer(rb_context* context) {
  return context->buffer();
}

std::int32_t rb_buffer_size(rb_context* context) {
  return static_cast<std::int32_t>(context->bufferSize());
}

std::int32_t rb_words(rb_context* context) {
  return context->answerOf([&] { return jsonText(wordsJson()); });
}

std::int32_t rb_toml_to_json(rb_context* context, std::int32_t length) {
  return context->answerOf(
      [&] { return document::jsonOf(document::parseToml(context->given(length), "scene.toml")); });
}

std::int32_t rb_json_to_toml(rb_context* context, std::int32_t length) {
  return context->answerOf(
      [&] { return document::documentText(document::nodeOfJson(context->given(length))); });
}

std::int32_t rb_file(rb_context* context, std::int32_t nameLength, std::int32_t length) {
  return context->answerOf([&] {
    context->takeFile(nameLength, length);
    return "";
  });
}

const double* rb_flight(rb_context* context, const double* readings, std::int32_t readingCount,
                        std::int32_t* count) {
  return context->numbersFor(count, [&] { return flightNumbers(readings, readingCount); });
}

std::int32_t rb_recording(rb_context* context, std::int32_t length) {
  return context->answerOf([&] {
    const std::string name(context->given(length));
    return jsonText(recordingJson(context->takenFile(name, context->bufferSize()), name));
  });
}

std::int32_t rb_read(rb_context* context, std::int32_t slot, std::int32_t length) {
  return context->answerOf([&] { return context->read(slot, context->given(length)); });
}

std::int32_t rb_scene_text(rb_context* context, std::int32_t slot) {
  return context->answerOf([&] { return scene::sceneText(context->in(slot).scene()); });
}

std::int32_t rb_advance(rb_context* context, std::int32_t slot, std::int32_t frame,
                        std::int32_t steps) {
  try {
    return static_cast<std::int32_t>(context->in(slot).advance(frame, steps));
  } catch (const std::exception& error) {
    context->message = error.what();
    return -1;
  }
}

std::int32_t rb_message(rb_context* context) {
  return context->answer(context->message);
}

std::int32_t rb_frames(rb_context* context, std::int32_t slot) {
  return valueOr(0, [&] { return static_cast<std::int32_t>(context->in(slot).frameCount()); });
}

const double* rb_sample(rb_context* context, std::int32_t slot, std::int32_t motion,
                        std::int32_t frame) {
  const auto index = static_cast<std::size_t>(motion);
  const auto take = [&]() -> const double* {
    context->sample =
        numbersOf(context->in(slot).sample(index, frame), context->in(slot).isHeld(index, frame));
    return context->sample.data();
  };
  return valueOr<const double*>(nullptr, take);
}

std::int32_t rb_checksum(rb_context* context, std::int32_t slot) {
  return context->answerOf([&] { return timeline::motionChecksum(context->wholeIn(slot)); });
}

std::int32_t rb_table_checksum(rb_context* context, std::int32_t slot) {
  return context->answerOf([&] {
    Checksum sum;
    for (const physics::Trajectory& trajectory : context->wholeIn(slot).trajectories()) {
      sum.add(timeline::trajectoryCsv(trajectory));
    }
    return sum.text();
  });
}

void rb_clip(rb_context* context, double size) {
  context->search = RecordSearch(static_cast<std::uint64_t>(size > 0 ? std::min(size, 0x1p53) : 0));
}

double rb_clip_offset(rb_context* context) {
  return static_cast<double>(context->search.next());
}

std::int32_t rb_record(rb_context* context, std::int32_t length) {
  return context->answerOf([&] { return context->search.take(context->given(length)); });
}

const float* rb_mesh_vertices(rb_context* /*context*/, std::int32_t* count) {
  *count = static_cast<std::int32_t>(bookMesh().vertices.size() / kVertexFloats);
  return bookMesh().vertices.data();
}

const std::uint16_t* rb_mesh_indices(rb_context* /*context*/, std::int32_t part,
                                     std::int32_t* count) {
  *count = 0;
  if (part < 0 || part >= static_cast<std::int32_t>(geometry::kBookPartCount)) return nullptr;
  const auto& indices = bookMesh().indices[static_cast<std::size_t>(part)];
  *count = static_cast<std::int32_t>(indices.size());
  return indices.data();
}

std::int32_t rb_body(rb_context* context, std::int32_t slot, std::int32_t motion) {
  return context->answerOf([&] { return context->makeBody(slot, motion); });
}

const float* rb_body_vertices(rb_context* context) {
  return context->body.vertices.data();
}

const std::uint32_t* rb_body_indices(rb_context* context) {
  return context->body.indices.data();
}

std::int32_t rb_camera(rb_context* context, std::int32_t slot, std::int32_t motion,
                       std::int32_t frame, float width, float height, const double* orbit,
                       double distance, float* matrix, float* eye, float* sky) {
  const geometry::Screen screen{pixels(width), pixels(height), 0};
  const auto index = static_cast<std::size_t>(motion);
  return valueOr(0, [&] {
    const PlayedScene& played = context->in(slot);
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

const double* rb_forces(rb_context* context, std::int32_t slot, std::int32_t motion,
                        std::int32_t frame, std::int32_t* count) {
  return context->numbersFor(count, [&] { return context->forcesIn(slot, motion, frame); });
}

const double* rb_ladder(rb_context* context, std::int32_t slot, std::int32_t motion,
                        std::int32_t frame, std::int32_t* count) {
  return context->numbersFor(count, [&] {
    return ladderNumbers(context->in(slot), static_cast<std::size_t>(motion), frame);
  });
}

const double* rb_poinsot(rb_context* context, std::int32_t slot, std::int32_t motion,
                         std::int32_t frame, std::int32_t trail, std::int32_t* count) {
  return context->numbersFor(count, [&] {
    return poinsotNumbers(context->in(slot), static_cast<std::size_t>(motion), frame, trail);
  });
}

std::int32_t rb_spin(rb_context* context, std::int32_t slot, std::int32_t motion) {
  return context->answerOf([&] {
    return jsonText(
        spinJson(context->in(slot).scene().motions.at(static_cast<std::size_t>(motion))));
  });
}

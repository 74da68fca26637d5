#include "bridge/context.h"

#include <algorithm>
#include <stdexcept>

#include "base/error.h"
#include "bridge/scene_json.h"
#include "scene/scene_text.h"

using namespace rotatebook;
using namespace rotatebook::bridge;

rb_context::rb_context(std::int64_t maxFrames, std::size_t bufferSize)
    : maxFrames_(maxFrames), blocks_((bufferSize + sizeof(Block) - 1) / sizeof(Block)) {}

std::int32_t rb_context::answer(std::string_view text) {
  const std::size_t length = std::min(text.size(), bufferSize());
  std::copy_n(text.begin(), length, buffer());
  return static_cast<std::int32_t>(length);
}

std::string_view rb_context::given(std::int32_t length) {
  const auto most = static_cast<std::int32_t>(bufferSize());
  return {buffer(), static_cast<std::size_t>(std::clamp(length, 0, most))};
}

void rb_context::takeFile(std::int32_t nameLength, std::int32_t length) {
  if (nameLength == 0 && length == 0) return files_.clear();
  const auto size = static_cast<std::int64_t>(bufferSize());
  if (nameLength < 0 || length < 0 || std::int64_t{nameLength} + length > size) {
    throw std::out_of_range("a file of " + std::to_string(length) + " bytes doesn't fit in");
  }
  const std::string name(buffer(), static_cast<std::size_t>(nameLength));
  if (files_.size() == kMaxFiles && !files_.contains(name)) {
    throw std::out_of_range("there are " + std::to_string(kMaxFiles) + " files already");
  }
  files_[name].assign(buffer() + nameLength, static_cast<std::size_t>(length));
}

const std::string* rb_context::fileOf(const std::string& name) const {
  const auto found = files_.find(name);
  return found == files_.end() ? nullptr : &found->second;
}

std::string rb_context::takenFile(const std::filesystem::path& file, std::size_t most) const {
  const std::string* const bytes = fileOf(file.generic_string());
  if (bytes == nullptr) throw InputError("can't read " + file.string() + ": it isn't here");
  if (bytes->size() <= most) return *bytes;
  throw InputError("can't read " + file.string() + ": it is longer than " + std::to_string(most) +
                   " bytes");
}

/// Reads a scene with the files that were taken, if there are any.
scene::Scene rb_context::sceneFrom(std::string_view text) const {
  if (files_.empty()) return scene::parseScene(text, "scene.toml");
  return scene::parseScene(text, "scene.toml", {},
                           [this](const std::filesystem::path& file, std::size_t most) {
                             return takenFile(file, most);
                           });
}

std::optional<PlayedScene>& rb_context::slotAt(std::int32_t slot) {
  if (slot >= 0 && slot < kSlots) return slots_[static_cast<std::size_t>(slot)];
  throw std::out_of_range("there is no slot " + std::to_string(slot));
}

std::string rb_context::read(std::int32_t slot, std::string_view text) {
  std::optional<PlayedScene>& held = slotAt(slot);
  scene::Scene scene = sceneFrom(text);
  const bool keepsMotions = held && held->hasMotionsOf(scene);
  std::optional<PlayedScene> played;
  if (!keepsMotions) played.emplace(scene, maxFrames_);
  std::string json = jsonText(sceneJson(scene));
  playedForces_.clear();
  if (keepsMotions) {
    held->replace(std::move(scene));
  } else {
    held = std::move(played);
  }
  return json;
}

PlayedScene& rb_context::in(std::int32_t slot) {
  std::optional<PlayedScene>& held = slotAt(slot);
  if (!held) throw std::out_of_range("slot " + std::to_string(slot) + " holds no scene");
  return *held;
}

const timeline::ClipMotion& rb_context::wholeIn(std::int32_t slot) {
  const timeline::ClipMotion* motion = in(slot).whole();
  if (motion == nullptr) throw std::runtime_error("the motions aren't simulated to their end");
  return *motion;
}

std::vector<double> rb_context::forcesIn(std::int32_t slot, std::int32_t motion,
                                         std::int32_t frame) {
  const PlayedScene& played = in(slot);
  const auto key = std::pair(slot, motion);
  auto found = playedForces_.find(key);
  if (found == playedForces_.end()) {
    const PlayedForces made(played, static_cast<std::size_t>(motion));
    found = playedForces_.emplace(key, made).first;
  }
  return found->second.at(played, frame);
}

std::string rb_context::makeBody(std::int32_t slot, std::int32_t motion) {
  const std::vector<scene::Panel>& motions = in(slot).scene().motions;
  const scene::Panel& panel = motions.at(static_cast<std::size_t>(motion));
  if (panel.solid.isBook()) return "null";
  body = bodyMeshOf(panel, [this](const std::string& name) { return fileOf(name); });
  return body.json;
}

// The state that the functions of bridge.h work on. Inside the room only.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bridge/body_mesh.h"
#include "bridge/bridge.h"
#include "bridge/played_scene.h"
#include "bridge/record_search.h"
#include "bridge/why_numbers.h"

/// A buffer, the slots, and what was given and answered last.
struct rb_context {
  rb_context(std::int64_t maxFrames, std::size_t bufferSize);

  char* buffer() { return blocks_.front().bytes.data(); }
  std::size_t bufferSize() const { return blocks_.size() * sizeof(Block); }

  /// Copies `text` to the buffer as far as there is room; returns its length.
  std::int32_t answer(std::string_view text);
  /// Answers with the text that `make` returns, or else with the message of what it throws.
  template <typename Make>
  std::int32_t answerOf(const Make& make) {
    try {
      return answer(make());
    } catch (const std::exception& error) {
      const std::int32_t length = answer(error.what());
      return length > 0 ? -length : -1;
    }
  }
  /// Returns the buffer's first bytes, at most all.
  std::string_view given(std::int32_t length);

  /// Takes a file from the buffer; see rb_file().
  void takeFile(std::int32_t nameLength, std::int32_t length);
  /// Returns the bytes of a file that was taken; null if there is none of this name.
  const std::string* fileOf(const std::string& name) const;
  /// Returns the same. Throws InputError if there is none, or if it has more than `most` bytes.
  std::string takenFile(const std::filesystem::path& file, std::size_t most) const;

  /// Reads a scene into a slot; returns the JSON of rb_read().
  std::string read(std::int32_t slot, std::string_view text);
  /// Returns the scene in a slot. Throws std::out_of_range if there is none.
  rotatebook::bridge::PlayedScene& in(std::int32_t slot);
  /// Returns a slot's motions. Throws std::runtime_error if they aren't simulated to their end.
  const rotatebook::timeline::ClipMotion& wholeIn(std::int32_t slot);
  /// Returns the numbers of rb_forces().
  std::vector<double> forcesIn(std::int32_t slot, std::int32_t motion, std::int32_t frame);
  /// Returns the JSON of a motion's body, which becomes `body`.
  std::string makeBody(std::int32_t slot, std::int32_t motion);
  /// Returns the address of the numbers that `make` returns, and how many there are; null and 0 if
  /// it throws.
  template <typename Make>
  const double* numbersFor(std::int32_t* count, const Make& make) {
    *count = 0;
    try {
      numbers_ = make();
    } catch (const std::exception&) {
      return nullptr;
    }
    *count = static_cast<std::int32_t>(numbers_.size());
    return numbers_.data();
  }

  std::string message;                          ///< Of rb_message().
  std::array<double, kSampleNumbers> sample{};  ///< Of rb_sample().
  rotatebook::bridge::BodyMesh body;            ///< Of rb_body().
  rotatebook::bridge::RecordSearch search{0};   ///< Of rb_record().

 private:
  struct alignas(16) Block {
    std::array<char, 16> bytes{};
  };

  rotatebook::scene::Scene sceneFrom(std::string_view text) const;
  std::optional<rotatebook::bridge::PlayedScene>& slotAt(std::int32_t slot);

  std::int64_t maxFrames_;
  std::vector<Block> blocks_;
  std::array<std::optional<rotatebook::bridge::PlayedScene>, kSlots> slots_;
  std::map<std::pair<std::int32_t, std::int32_t>, rotatebook::bridge::PlayedForces>
      playedForces_;                          // by slot and motion
  std::map<std::string, std::string> files_;  // by name
  std::vector<double> numbers_;               // of numbersFor()
};

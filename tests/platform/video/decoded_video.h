// An MP4 read back with FFmpeg's libraries, for tests.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace rotatebook::video::testing {

/// One decoded picture: planes without padding, colour at half size.
struct DecodedFrame {
  std::int64_t pts = 0;  ///< In the stream's time base.
  std::vector<std::uint8_t> y;
  std::vector<std::uint8_t> u;
  std::vector<std::uint8_t> v;

  friend bool operator==(const DecodedFrame&, const DecodedFrame&) = default;
};

/// Properties that a player learns from the file. Names are FFmpeg's.
struct DecodedVideo {
  int width = 0;
  int height = 0;
  std::string profile;
  std::string pixelFormat;
  std::string primaries;
  std::string transfer;
  std::string matrix;
  std::string range;
  std::string chromaLocation;
  std::string codecTag;
  std::int64_t timeScale = 0;            ///< Ticks of the stream's clock a second.
  std::int64_t startTime = 0;            ///< [ticks]
  std::int64_t duration = 0;             ///< [ticks]
  std::int64_t frameCount = 0;           ///< As the container says.
  std::int64_t containerDurationUs = 0;  ///< [µs]
  std::map<std::string, std::string> metadata;
  std::vector<std::string> chapters;  ///< "0.05 Start": from when on [s], and its name.
  std::vector<DecodedFrame> frames;
};

/// Reads and decodes all of `path`. Throws std::runtime_error where that fails, also for a damaged
/// picture.
DecodedVideo decodeVideo(const std::filesystem::path& path);

/// The file's bytes.
std::string contentOf(const std::filesystem::path& path);

/// A part of an MP4: its type and content.
struct Box {
  std::string type;
  std::string content;
};

/// The boxes that lie one after the other in `content`, for instance in a whole file.
std::vector<Box> boxesIn(const std::string& content);

/// The content of the box at `path`, for instance "moov/mvhd". Throws std::runtime_error if there
/// is none.
std::string boxContent(const std::string& file, const std::string& path);

/// The 32-bit number at `at` of `bytes`.
std::uint32_t bigEndian(const std::string& bytes, std::size_t at);

}  // namespace rotatebook::video::testing

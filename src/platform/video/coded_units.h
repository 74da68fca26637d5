// The units that the program's own encoders code a picture in. Inside the room only.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "video/clip_form.h"

namespace rotatebook::video {

using Bytes = std::span<const std::uint8_t>;

/// A coded picture.
struct CodedPicture {
  bool isKey = false;        ///< True if it needs no other picture.
  std::string difference{};  ///< From how the encoder codes one: "a NAL unit of type 9", or empty.
};

/// Returns the first difference of the parameters of an H.264 stream (an AVCDecoderConfiguration-
/// Record, ISO/IEC 14496-15, 5.3.3) from what libx264 writes for `form` and the pictures of
/// `payload`; empty if there is none.
std::string h264Difference(Bytes parameters, const WrittenForm& form, const Payload& payload);

/// Examines a picture as libx264 codes it in an MP4: one slice, and before the `first` picture's
/// libx264's note of its version and settings, noteSettings() among them or kWebPreset's.
CodedPicture h264Picture(Bytes packet, bool first, const WrittenForm& form);

/// Returns what libx264's note says of a preset, by which presets differ: "subme=8", for example.
std::vector<std::string> presetSettings(std::string_view preset);
/// Returns that, and the rate factor, "crf=19.5".
std::vector<std::string> noteSettings(int crf, std::string_view preset);

/// Follows the numbers by which decoders of H.264 order pictures (8.2.1): those of one whose
/// numbers say otherwise than its time may show another order, or leave pictures out.
class PictureOrder {
 public:
  /// `parameters` are those of the stream, as for h264Difference().
  explicit PictureOrder(Bytes parameters);

  /// Returns whether the next packet has the numbers that libx264 gives to what is shown as
  /// `frame`.
  bool isPlain(Bytes packet, std::int64_t frame);

 private:
  int numberBits_ = 0, orderBits_ = 0;
  std::int64_t needed_ = 0;  // Pictures since the last key frame that others refer to.
  std::int64_t start_ = 0;   // The frame of that one.
};

/// Examines a picture as libvpx codes it: a frame to show, with others before it that later ones
/// refer to.
CodedPicture vp9Picture(Bytes packet, const WrittenForm& form);

}  // namespace rotatebook::video

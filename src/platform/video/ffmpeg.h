// FFmpeg as the room's other files use it: owned handles, and failures as exceptions. Whatever
// differs between FFmpeg 5, 6, 7 and 8 belongs here. Inside the room only.
#pragma once

#include <memory>
#include <string>

#include "video/ffmpeg_functions.h"

namespace rotatebook::video {

struct FfmpegDeleter {
  void operator()(AVCodecContext* context) const noexcept { avcodec_free_context(&context); }
  void operator()(AVFrame* frame) const noexcept { av_frame_free(&frame); }
  void operator()(AVPacket* packet) const noexcept { av_packet_free(&packet); }
  void operator()(SwsContext* context) const noexcept { sws_freeContext(context); }
  /// Closes the file, too; to learn whether that works, close it before.
  void operator()(AVFormatContext* context) const noexcept;
};

template <typename T>
using Handle = std::unique_ptr<T, FfmpegDeleter>;

/// Takes ownership of what an FFmpeg function allocated; throws std::bad_alloc for nullptr.
template <typename T>
Handle<T> owned(T* allocated) {
  if (allocated == nullptr) throw std::bad_alloc();
  return Handle<T>(allocated);
}

/// FFmpeg's dictionary of options or metadata.
class Dictionary {
 public:
  Dictionary() = default;
  Dictionary(const Dictionary&) = delete;
  Dictionary& operator=(const Dictionary&) = delete;
  ~Dictionary() { av_dict_free(&entries_); }

  void set(const char* key, const std::string& value);
  /// Returns the value of `key`, in any case, in `entries`; empty if there is none.
  static std::string valueIn(const AVDictionary* entries, const char* key);
  AVDictionary** address() { return &entries_; }

 private:
  AVDictionary* entries_ = nullptr;
};

/// Stops FFmpeg from printing in this process: check() puts its log into exceptions instead.
void silenceFfmpeg();

/// Returns `result`, an FFmpeg function's return value. If negative, throws MachineError:
/// "`failure`: FFmpeg's name of the error (its log on this thread)".
int check(int result, const std::string& failure);
/// Like check(), for reading a file, which is to blame even for a request of too much memory:
/// throws InputError.
int checkInput(int result, const std::string& failure);

/// Returns the profile, for example "High" or "Profile 0"; empty if the stream states none.
std::string profileName(const AVCodecParameters& stream);

inline constexpr const char* kProgressive = "progressive";
inline constexpr const char* kInterlaced = "interlaced";
/// Returns how lines of the pictures are scanned: kProgressive, also if that isn't stated, or
/// kInterlaced.
std::string scanText(const AVCodecParameters& stream);
/// Returns whether the picture is marked as two fields, which players may interpolate.
bool isInterlaced(const AVFrame& frame);

/// Returns, in FFmpeg's terms, how the container has players change the stream's pictures: "as
/// stored", or for example "Display Matrix -1 0, 0 -1".
std::string displayText(const AVStream& stream);

/// profile_idc of H.264 High; FFmpeg's own name for it depends on the version.
inline constexpr int kProfileHigh = 100;

}  // namespace rotatebook::video

// FFmpeg as the room's other files see it: owned handles, and failures as exceptions. Whatever
// differs between FFmpeg 5, 6, 7 and 8 belongs here. Inside the room only.
#pragma once

#include <memory>
#include <string>

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libswscale/swscale.h>
}

namespace rotatebook::video {

struct FfmpegDeleter {
  void operator()(AVCodecContext* context) const noexcept { avcodec_free_context(&context); }
  void operator()(AVFrame* frame) const noexcept { av_frame_free(&frame); }
  void operator()(AVPacket* packet) const noexcept { av_packet_free(&packet); }
  void operator()(SwsContext* context) const noexcept { sws_freeContext(context); }
  /// Closes the file too; whoever wants to know whether that worked closes it before.
  void operator()(AVFormatContext* context) const noexcept;
};

template <typename T>
using Handle = std::unique_ptr<T, FfmpegDeleter>;

/// Takes what an FFmpeg function allocated; throws std::bad_alloc for nullptr.
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
  /// The value of `key`, of whatever case, in `entries`; empty if there is none.
  static std::string valueIn(const AVDictionary* entries, const char* key);
  AVDictionary** address() { return &entries_; }

 private:
  AVDictionary* entries_ = nullptr;
};

/// From here on FFmpeg prints nothing in this process: check() puts its words into the exceptions.
void silenceFfmpeg();

/// Returns `result`, an FFmpeg function's return value. If negative, throws MachineError:
/// "`failure`: FFmpeg's name of the error (the words it logged on this thread)".
int check(int result, const std::string& failure);
/// The same of a file that is read, which is to blame, also for asking for too much memory: throws
/// InputError.
int checkInput(int result, const std::string& failure);

/// "High", "Profile 0"; empty if the stream doesn't tell.
std::string profileName(const AVCodecParameters& stream);

/// What the container has players do with the stream's pictures, in FFmpeg's words: "as stored", or
/// for example "Display Matrix -1 0, 0 -1".
std::string displayText(const AVStream& stream);

/// profile_idc of H.264 High; FFmpeg's own name for it changed.
inline constexpr int kProfileHigh = 100;

}  // namespace rotatebook::video

#include "video/ffmpeg.h"

#include <array>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <new>
#include <span>

#include "base/error.h"
#include "base/number_text.h"
#include "system/file_descriptor.h"

namespace rotatebook::video {
namespace {

// FFmpeg's log since the last check() on this thread. Plain memory, as its callback must not throw.
thread_local std::array<char, 512> loggedText{};

void keepErrors(void*, int level, const char* format, std::va_list arguments) {
  if (level > AV_LOG_ERROR) return;
  const std::size_t used = std::strlen(loggedText.data());
  std::vsnprintf(loggedText.data() + used, loggedText.size() - used, format, arguments);
}

// Takes the log, its lines joined by semicolons.
std::string takeLoggedText() {
  std::string logged(loggedText.data());
  loggedText.front() = '\0';
  while (!logged.empty() && logged.back() == '\n') logged.pop_back();
  for (auto end = logged.find('\n'); end != std::string::npos; end = logged.find('\n', end)) {
    logged.replace(end, 1, "; ");
  }
  return logged;
}

std::string nameOfError(int error) {
  std::array<char, AV_ERROR_MAX_STRING_SIZE> name{};
  av_strerror(error, name.data(), name.size());
  return name.data();
}

/// Returns "`failure`: FFmpeg's name of the error (`logged`)".
std::string failureText(int error, const std::string& failure, const std::string& logged) {
  return failure + ": " + nameOfError(error) + (logged.empty() ? "" : " (" + logged + ")");
}

/// Returns what the container states beside the stream's data.
std::span<const AVPacketSideData> sideDataOf(const AVStream& stream) {
#if LIBAVCODEC_VERSION_INT >= AV_VERSION_INT(60, 31, 0)
  const AVCodecParameters& codec = *stream.codecpar;
  return {codec.coded_side_data, static_cast<std::size_t>(codec.nb_coded_side_data)};
#else
  return {stream.side_data, static_cast<std::size_t>(stream.nb_side_data)};
#endif
}

/// Returns where a display matrix maps a picture's right and down.
std::string matrixText(const AVPacketSideData& data) {
  std::array<std::int32_t, 9> matrix{};
  if (data.size < sizeof matrix) return "";
  std::memcpy(matrix.data(), data.data, sizeof matrix);
  const auto value = [&](std::size_t i) { return " " + roundedText(matrix[i] / 0x1p16, 6); };
  return value(0) + value(1) + "," + value(3) + value(4);
}

}  // namespace

void FfmpegDeleter::operator()(AVFormatContext* context) const noexcept {
  avio_closep(&context->pb);
  avformat_free_context(context);
}

void Dictionary::set(const char* key, const std::string& value) {
  if (av_dict_set(&entries_, key, value.c_str(), 0) < 0) throw std::bad_alloc();
}

std::string Dictionary::valueIn(const AVDictionary* entries, const char* key) {
  const AVDictionaryEntry* entry = av_dict_get(entries, key, nullptr, 0);
  return entry == nullptr ? "" : entry->value;
}

void silenceFfmpeg() {
  av_log_set_callback(keepErrors);
}

int check(int result, const std::string& failure) {
  const std::string logged = takeLoggedText();
  if (result >= 0) return result;
  throw MachineError(failureText(result, failure, logged), system::kindOfError(AVUNERROR(result)));
}

int checkInput(int result, const std::string& failure) {
  const std::string logged = takeLoggedText();
  if (result >= 0) return result;
  throw InputError(failureText(result, failure, logged));
}

std::string profileName(const AVCodecParameters& stream) {
  const char* name = avcodec_profile_name(stream.codec_id, stream.profile);
  return name == nullptr ? "" : name;
}

std::string scanText(const AVCodecParameters& stream) {
  const bool known = stream.field_order != AV_FIELD_UNKNOWN;
  return known && stream.field_order != AV_FIELD_PROGRESSIVE ? kInterlaced : kProgressive;
}

bool isInterlaced(const AVFrame& frame) {
#if LIBAVUTIL_VERSION_INT >= AV_VERSION_INT(58, 7, 100)
  return (frame.flags & AV_FRAME_FLAG_INTERLACED) != 0;
#else
  return frame.interlaced_frame != 0;
#endif
}

std::string displayText(const AVStream& stream) {
  std::string text;
  for (const AVPacketSideData& data : sideDataOf(stream)) {
    // The encoder's buffer size doesn't affect what players show.
    if (data.type == AV_PKT_DATA_CPB_PROPERTIES) continue;
    const char* name = av_packet_side_data_name(data.type);
    text += (text.empty() ? "" : "; ") + std::string(name == nullptr ? "unknown" : name);
    if (data.type == AV_PKT_DATA_DISPLAYMATRIX) text += matrixText(data);
  }
  return text.empty() ? "as stored" : text;
}

}  // namespace rotatebook::video

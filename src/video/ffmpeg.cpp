#include "video/ffmpeg.h"

#include <array>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <new>

extern "C" {
#include <libavutil/log.h>
}

#include "base/error.h"

namespace rotatebook::video {
namespace {

// What FFmpeg logged since the last check() on this thread. Plain memory: its callback must not
// throw.
thread_local std::array<char, 512> loggedWords{};

void keepErrors(void*, int level, const char* format, std::va_list arguments) {
  if (level > AV_LOG_ERROR) return;
  const std::size_t used = std::strlen(loggedWords.data());
  std::vsnprintf(loggedWords.data() + used, loggedWords.size() - used, format, arguments);
}

// Takes the words, each line of them joined to the next by a semicolon.
std::string takeLoggedWords() {
  std::string words(loggedWords.data());
  loggedWords.front() = '\0';
  while (!words.empty() && words.back() == '\n') words.pop_back();
  for (auto end = words.find('\n'); end != std::string::npos; end = words.find('\n', end)) {
    words.replace(end, 1, "; ");
  }
  return words;
}

std::string nameOfError(int error) {
  std::array<char, AV_ERROR_MAX_STRING_SIZE> name{};
  av_strerror(error, name.data(), name.size());
  return name.data();
}

/// "`failure`: FFmpeg's name of the error (`words`)"
std::string failureText(int error, const std::string& failure, const std::string& words) {
  return failure + ": " + nameOfError(error) + (words.empty() ? "" : " (" + words + ")");
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
  const std::string words = takeLoggedWords();
  if (result >= 0) return result;
  throw MachineError(failureText(result, failure, words));
}

int checkInput(int result, const std::string& failure) {
  const std::string words = takeLoggedWords();
  if (result >= 0) return result;
  throw InputError(failureText(result, failure, words));
}

std::string profileName(const AVCodecParameters& stream) {
  const char* name = avcodec_profile_name(stream.codec_id, stream.profile);
  return name == nullptr ? "" : name;
}

}  // namespace rotatebook::video

#include "video/clip_input.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <new>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "base/clip_parts.h"
#include "base/error.h"
#include "system/read_file.h"
#include "video/layout.h"

namespace rotatebook::video {
namespace {

constexpr std::size_t kBufferSize = 65'536;
/// FFmpeg's largest allocation. A table of a million frames takes 40 MB, the largest picture 54.
/// [bytes]
constexpr std::size_t kMaxAllocation = 256'000'000;

/// Returns whether FFmpeg may have failed because the file is in none of our formats.
bool isOfNoFormat(int result) {
  return result == AVERROR(EINVAL) || result == AVERROR_INVALIDDATA || result == AVERROR_EOF;
}

bool isNamed(const AVInputFormat& demuxer, std::string_view name) {
  return fmt::format(",{},", demuxer.name).find(fmt::format(",{},", name)) != std::string::npos;
}

}  // namespace

ClipInput::ClipInput(const std::filesystem::path& path, bool FormatRow::*wanted)
    : name_(path.string()) {
  try {
    system::openFile(path);
  } catch (const InputError& error) {
    throw InputError(fmt::format("can't read {}: {}", name_, error.what()));
  }
  // FFmpeg would take "a:b.mp4" for a protocol named a.
  open(nullptr, "file:" + name_, wanted);
}

ClipInput::ClipInput(std::span<const std::uint8_t> bytes, std::string name)
    : name_(std::move(name)), memory_{bytes, 0} {
  auto* buffer = static_cast<unsigned char*>(av_malloc(kBufferSize));
  if (buffer == nullptr) throw std::bad_alloc();
  io_.reset(avio_alloc_context(buffer, kBufferSize, 0, &memory_, readMemory, nullptr, seekMemory));
  if (!io_) {
    av_free(buffer);
    throw std::bad_alloc();
  }
  AVFormatContext* context = avformat_alloc_context();
  if (context == nullptr) throw std::bad_alloc();
  context->pb = io_.get();
  open(context, "", &FormatRow::holdsRecord);
}

void ClipInput::IoDeleter::operator()(AVIOContext* io) const noexcept {
  // FFmpeg may have replaced the buffer that it was given.
  av_freep(&io->buffer);
  avio_context_free(&io);
}

int ClipInput::readMemory(void* memory, std::uint8_t* buffer, int size) {
  auto& [bytes, at] = *static_cast<Memory*>(memory);
  const std::size_t count = std::min(bytes.size() - at, static_cast<std::size_t>(size));
  if (count == 0) return AVERROR_EOF;
  std::memcpy(buffer, bytes.data() + at, count);
  at += count;
  return static_cast<int>(count);
}

std::int64_t ClipInput::seekMemory(void* memory, std::int64_t offset, int whence) {
  auto& [bytes, at] = *static_cast<Memory*>(memory);
  const auto size = static_cast<std::int64_t>(bytes.size());
  if ((whence & AVSEEK_SIZE) != 0) return size;
  const std::int64_t from = whence == SEEK_CUR   ? static_cast<std::int64_t>(at)
                            : whence == SEEK_END ? size
                                                 : 0;
  if (offset < -from || offset > size - from) return AVERROR(EINVAL);
  at = static_cast<std::size_t>(from + offset);
  return from + offset;
}

bool ClipInput::beginsAsClip() const {
  const auto bytes = memory_.bytes.first(std::min(memory_.bytes.size(), kMaxHead));
  std::string head(bytes.begin(), bytes.end());
  if (!io_) {
    std::ifstream file(name_, std::ios::binary);
    head = bytesAt(file, 0, kMaxHead);
  }
  return beginsAsMp4(head) || beginsAsWebm(head);
}

void ClipInput::open(AVFormatContext* context, const std::string& url, bool FormatRow::*wanted) {
  silenceFfmpeg();
  // A file of a few bytes may ask for tables of gigabytes. The limit holds for the whole process.
  av_max_alloc(kMaxAllocation);
  Dictionary options;
  options.set("format_whitelist", demuxers());
  options.set("codec_whitelist", decoders());
  options.set("protocol_whitelist", "file");
  // Frees `context` if it fails.
  const int result = avformat_open_input(&context, url.c_str(), nullptr, options.address());
  if (isOfNoFormat(result) && !beginsAsClip()) {
    throw InputError(
        fmt::format("{} isn't an {}", name_, listFormats(&FormatRow::title, "or", wanted)));
  }
  checkInput(result, "can't read " + name_);
  context_.reset(context);
}

VideoFormat ClipInput::format() const {
  const std::string codec =
      context_->nb_streams == 1 ? avcodec_get_name(context_->streams[0]->codecpar->codec_id) : "";
  const auto reads = [this](const FormatRow& row) {
    return isNamed(*context_->iformat, row.demuxer);
  };
  const auto isIt = [&](const FormatRow& row) { return reads(row) && row.codec == codec; };
  const auto found = std::ranges::find_if(kFormatRows, isIt);
  return found != kFormatRows.end() ? found->format
                                    : std::ranges::find_if(kFormatRows, reads)->format;
}

AVStream& ClipInput::stream() const {
  const bool one = context_->nb_streams == 1;
  if (one && context_->streams[0]->codecpar->codec_type == AVMEDIA_TYPE_VIDEO) {
    return *context_->streams[0];
  }
  throw InputError(
      fmt::format("{} has {}; a clip has exactly one stream, of video", name_,
                  one ? "no video stream" : fmt::format("{} streams", context_->nb_streams)));
}

void ClipInput::probe() {
  Dictionary options;
  options.set("max_pixels", std::to_string(kMaxDecodedPixels));
  options.set("codec_whitelist", decoders());
  stream();  // Exactly one stream, so one set of options is enough.
  checkInput(avformat_find_stream_info(context_.get(), options.address()),
             "can't read the pictures of " + name_);
}

}  // namespace rotatebook::video

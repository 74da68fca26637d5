#include "video/decoded_video.h"

#include <fstream>
#include <iomanip>
#include <iterator>
#include <sstream>
#include <stdexcept>

extern "C" {
#include <libavutil/pixdesc.h>
}

#include "video/ffmpeg.h"
#include "video/input_file.h"

namespace rotatebook::video::testing {
namespace {

std::string textOf(const char* text) {
  return text == nullptr ? "" : text;
}

DecodedVideo describe(const AVFormatContext& file) {
  const AVStream& stream = *file.streams[0];
  const AVCodecParameters& codec = *stream.codecpar;
  DecodedVideo video;
  video.width = codec.width;
  video.height = codec.height;
  video.profile = textOf(avcodec_profile_name(codec.codec_id, codec.profile));
  video.pixelFormat = textOf(av_get_pix_fmt_name(static_cast<AVPixelFormat>(codec.format)));
  video.primaries = textOf(av_color_primaries_name(codec.color_primaries));
  video.transfer = textOf(av_color_transfer_name(codec.color_trc));
  video.matrix = textOf(av_color_space_name(codec.color_space));
  video.range = textOf(av_color_range_name(codec.color_range));
  video.chromaLocation = textOf(av_chroma_location_name(codec.chroma_location));
  for (int shift = 0; shift < 32; shift += 8) {
    video.codecTag += static_cast<char>(codec.codec_tag >> shift & 0xff);
  }
  if (stream.time_base.num != 1) throw std::runtime_error("time base isn't 1/n");
  video.timeScale = stream.time_base.den;
  video.startTime = stream.start_time;
  video.duration = stream.duration;
  video.frameCount = stream.nb_frames;
  video.containerDurationUs = file.duration;
  const AVDictionaryEntry* entry = nullptr;
  while ((entry = av_dict_get(file.metadata, "", entry, AV_DICT_IGNORE_SUFFIX)) != nullptr) {
    video.metadata[entry->key] = entry->value;
  }
  for (unsigned i = 0; i < file.nb_chapters; ++i) {
    const AVChapter& chapter = *file.chapters[i];
    std::ostringstream text;
    text << std::fixed << std::setprecision(2)
         << static_cast<double>(chapter.start) * av_q2d(chapter.time_base) << ' '
         << textOf(av_dict_get(chapter.metadata, "title", nullptr, 0)->value);
    video.chapters.push_back(text.str());
  }
  return video;
}

std::vector<std::uint8_t> planeOf(const AVFrame& frame, int plane, int width, int height) {
  std::vector<std::uint8_t> bytes;
  for (int y = 0; y < height; ++y) {
    const std::uint8_t* row =
        frame.data[plane] + static_cast<std::ptrdiff_t>(y) * frame.linesize[plane];
    bytes.insert(bytes.end(), row, row + width);
  }
  return bytes;
}

DecodedFrame decodedFrame(const AVFrame& frame) {
  DecodedFrame decoded;
  decoded.pts = frame.pts;
  decoded.y = planeOf(frame, 0, frame.width, frame.height);
  decoded.u = planeOf(frame, 1, frame.width / 2, frame.height / 2);
  decoded.v = planeOf(frame, 2, frame.width / 2, frame.height / 2);
  return decoded;
}

}  // namespace

DecodedVideo decodeVideo(const std::filesystem::path& path) {
  silenceFfmpeg();
  const InputFile file = openFile(path);
  DecodedVideo video = describe(*file);
  decode(
      file, [](const AVPacket&) {},
      [&](const AVFrame& frame) { video.frames.push_back(decodedFrame(frame)); });
  return video;
}

std::string contentOf(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<Box> boxesIn(const std::string& content) {
  constexpr std::size_t kHead = 8;  // size and type
  std::vector<Box> boxes;
  std::size_t at = 0;
  while (at + kHead <= content.size()) {
    const std::size_t size = bigEndian(content, at);
    if (size < kHead || at + size > content.size()) throw std::runtime_error("a box is cut off");
    boxes.push_back({content.substr(at + 4, 4), content.substr(at + kHead, size - kHead)});
    at += size;
  }
  return boxes;
}

std::string boxContent(const std::string& file, const std::string& path) {
  const std::string type = path.substr(0, 4);
  for (const Box& box : boxesIn(file)) {
    if (box.type != type) continue;
    return path.size() == 4 ? box.content : boxContent(box.content, path.substr(5));
  }
  throw std::runtime_error("no box " + path);
}

std::uint32_t bigEndian(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value = value << 8 | static_cast<std::uint8_t>(bytes.at(at + i));
  return value;
}

}  // namespace rotatebook::video::testing

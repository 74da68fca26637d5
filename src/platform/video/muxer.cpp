#include "video/muxer.h"

#include <cstring>
#include <new>

#include "video/mp4_chapters.h"

namespace rotatebook::video {
namespace {

// FFmpeg would take "a:b.mp4" for a protocol named a.
std::string urlOf(const std::filesystem::path& path) {
  return "file:" + path.string();
}

Handle<AVFormatContext> makeContext(const std::filesystem::path& path, VideoFormat format) {
  AVFormatContext* context = nullptr;
  const std::string url = urlOf(path);
  const std::string container(rowOf(format).muxer);
  check(avformat_alloc_output_context2(&context, nullptr, container.c_str(), url.c_str()),
        "FFmpeg's libavformat can't write " + container);
  return Handle<AVFormatContext>(context);
}

void addStream(AVFormatContext& context, const AVCodecContext& encoder) {
  AVStream* stream = avformat_new_stream(&context, nullptr);
  if (stream == nullptr) throw std::bad_alloc();
  check(avcodec_parameters_from_context(stream->codecpar, &encoder), "can't describe the video");
  stream->time_base = encoder.time_base;
  stream->avg_frame_rate = encoder.framerate;
}

void addMetadata(AVFormatContext& context, VideoFormat format, const VideoSettings& settings) {
  Dictionary metadata;
  if (!settings.title.empty()) metadata.set("title", settings.title);
  const bool hasComment = !settings.comment.empty() && rowOf(format).holdsRecord;
  if (hasComment) metadata.set("comment", settings.comment);
  std::swap(context.metadata, *metadata.address());
}

template <typename Content>
Content* zeroed(std::size_t count) {
  void* memory = av_malloc(count * sizeof(Content));
  if (memory == nullptr) throw std::bad_alloc();
  std::memset(memory, 0, count * sizeof(Content));
  return static_cast<Content*>(memory);
}

/// Gives a WebM of so many pictures its chapters, which libavformat writes at its end and frees.
void addChapters(AVFormatContext& context, const std::vector<Chapter>& chapters, FrameRate rate,
                 std::int64_t frames) {
  if (chapters.empty()) return;
  context.chapters = zeroed<AVChapter*>(chapters.size());
  for (std::size_t i = 0; i < chapters.size(); ++i) {
    AVChapter* chapter = context.chapters[context.nb_chapters++] = zeroed<AVChapter>(1);
    chapter->id = static_cast<std::int64_t>(i) + 1;
    chapter->time_base = {rate.denominator, rate.numerator};
    chapter->start = chapters[i].frame;
    chapter->end = i + 1 < chapters.size() ? chapters[i + 1].frame : frames;
    check(av_dict_set(&chapter->metadata, "title", chapters[i].name.c_str(), 0),
          "can't name a chapter");
  }
}

}  // namespace

Muxer::Muxer(const std::filesystem::path& path, VideoFormat format, const Stages& stages,
             const VideoSettings& settings)
    : path_(path.string()),
      encoderTimeBase_(stages.encoder.context().time_base),
      format_(format),
      context_(makeContext(path, format)),
      chapters_(settings.chapters),
      frameRate_(settings.frameRate) {
  context_->flags |= AVFMT_FLAG_BITEXACT;
  addStream(*context_, stages.encoder.context());
  addMetadata(*context_, format, settings);
  checkFile(avio_open(&context_->pb, context_->url, AVIO_FLAG_WRITE));
  Dictionary options;
  for (const auto& [name, value] : stages.containerOptions) options.set(name, value);
  checkFile(avformat_write_header(context_.get(), options.address()));
}

void Muxer::write(AVPacket& packet) {
  ++frames_;
  av_packet_rescale_ts(&packet, encoderTimeBase_, context_->streams[0]->time_base);
  packet.stream_index = 0;
  checkFile(av_interleaved_write_frame(context_.get(), &packet));
}

void Muxer::finish() {
  if (format_ == VideoFormat::WebM) addChapters(*context_, chapters_, frameRate_, frames_);
  checkFile(av_write_trailer(context_.get()));
  checkFile(avio_closep(&context_->pb));
  if (format_ == VideoFormat::Mp4) addChapters(path_, chapters_, frameRate_);
}

int Muxer::checkFile(int result) const {
  return check(result, "can't write " + path_);
}

}  // namespace rotatebook::video

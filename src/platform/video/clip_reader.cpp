#include "video/clip_reader.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "base/error.h"
#include "video/clip_input.h"
#include "video/quantiser.h"
#include "video/whole_file.h"

namespace rotatebook::video {
namespace {

ClipMetadata metadataOf(const ClipInput& input) {
  const VideoFormat format = input.format();
  if (!rowOf(format).holdsRecord) {
    throw InputError(fmt::format(
        "{} is in the format {}, which holds no record of the scene; {} do", input.name(),
        nameOf(format), listFormats(&FormatRow::title, "and", &FormatRow::holdsRecord)));
  }
  input.stream();
  const AVDictionary* entries = input.context().metadata;
  return {format, Dictionary::valueIn(entries, "title"), Dictionary::valueIn(entries, "comment")};
}

std::string textOf(const char* text) {
  return text == nullptr ? "unknown" : text;
}

ColourTags coloursOf(AVColorPrimaries primaries, AVColorTransferCharacteristic transfer,
                     AVColorSpace matrix, AVColorRange range) {
  return {.primaries = textOf(av_color_primaries_name(primaries)),
          .transfer = textOf(av_color_transfer_name(transfer)),
          .matrix = textOf(av_color_space_name(matrix)),
          .range = textOf(av_color_range_name(range))};
}

ColourTags coloursOf(const ClipInput& input) {
  const AVCodecParameters& codec = *input.stream().codecpar;
  return coloursOf(codec.color_primaries, codec.color_trc, codec.color_space, codec.color_range);
}

/// Returns the pixel aspect ratio; players show pixels without one as squares.
std::string shapeText(AVRational shape) {
  if (shape.num == 0) return "1:1";
  return fmt::format("{}:{}", shape.num, shape.den);
}

/// Returns FFmpeg's names of what the stream says beside a picture, but for notes of the encoder.
std::string messagesOf(const AVFrame& frame) {
  std::string text;
  for (int i = 0; i < frame.nb_side_data; ++i) {
    const AVFrameSideDataType type = frame.side_data[i]->type;
    if (type == AV_FRAME_DATA_VIDEO_ENC_PARAMS || type == AV_FRAME_DATA_SEI_UNREGISTERED) continue;
    const char* name = av_frame_side_data_name(type);
    text += (text.empty() ? "" : "; ") + std::string(name == nullptr ? "unknown" : name);
  }
  return text;
}

PictureFacts factsOf(const AVFrame& frame) {
  const auto pixels = [](std::size_t count) { return static_cast<std::int64_t>(count); };
  return {.isKey = frame.pict_type == AV_PICTURE_TYPE_I,
          .interlaced = isInterlaced(frame),
          .alpha = frame.format == AV_PIX_FMT_YUVA420P,
          .colours = coloursOf(frame.color_primaries, frame.color_trc, frame.colorspace,
                               frame.color_range),
          .pixelShape = shapeText(frame.sample_aspect_ratio),
          .crop = {pixels(frame.crop_left), pixels(frame.crop_top), pixels(frame.crop_right),
                   pixels(frame.crop_bottom)},
          .messages = messagesOf(frame),
          .quantiser = quantiserOf(frame),
          .coarsestQuantiser = coarsestQuantiserOf(frame)};
}

/// Throws InputError if the codec is none of a clip's.
void requireCodecOfClips(const ClipInput& input) {
  const std::string codec = avcodec_get_name(input.stream().codecpar->codec_id);
  const auto has = [&](const FormatRow& row) { return row.holdsRecord && row.codec == codec; };
  if (std::ranges::any_of(kFormatRows, has)) return;
  throw InputError(fmt::format("the codec of {} is {}; a clip's is {}", input.name(), codec,
                               listFormats(&FormatRow::codec, "or", &FormatRow::holdsRecord)));
}

/// Reads the container's colours before it probes the stream, as FFmpeg keeps only one of the two.
ClipFacts factsOf(ClipInput& input) {
  ClipFacts facts;
  facts.containerColours = coloursOf(input);
  requireCodecOfClips(input);
  const std::string containerScan = scanText(*input.stream().codecpar);
  input.probe();
  const AVStream& stream = input.stream();
  const AVCodecParameters& codec = *stream.codecpar;
  if (codec.format == AV_PIX_FMT_NONE) {
    throw InputError(fmt::format("{} is damaged: its first pictures can't be decoded{}",
                                 input.name(), kCopyRemedy));
  }
  facts.format = input.format();
  facts.title = Dictionary::valueIn(input.context().metadata, "title");
  facts.width = codec.width;
  facts.height = codec.height;
  facts.codec = avcodec_get_name(codec.codec_id);
  facts.profile = profileName(codec);
  facts.pixelFormat = textOf(av_get_pix_fmt_name(static_cast<AVPixelFormat>(codec.format)));
  facts.colours = coloursOf(input);
  facts.pixelShape = shapeText(codec.sample_aspect_ratio);
  facts.containerShape = shapeText(stream.sample_aspect_ratio);
  facts.display = displayText(stream);
  facts.scan = containerScan == kProgressive ? scanText(codec) : containerScan;
  const std::int64_t duration = input.context().duration;
  if (duration > 0) facts.duration = static_cast<double>(duration) / AV_TIME_BASE;
  return facts;
}

bool statesAlpha(const ClipInput& input) {
  return Dictionary::valueIn(input.stream().metadata, "alpha_mode") == "1";
}

/// Finds the decoder of a format that holds a record, if `alpha` one that decodes alpha, too.
/// Throws MachineError if there is none.
const AVCodec& decoderFor(const ClipInput& input, bool alpha) {
  const AVCodecID codec = input.stream().codecpar->codec_id;
  const AVCodec* decoder = nullptr;
  // FFmpeg's own VP9 decoder ignores alpha.
  if (alpha && codec == AV_CODEC_ID_VP9) decoder = avcodec_find_decoder_by_name("libvpx-vp9");
  if (decoder == nullptr) decoder = avcodec_find_decoder(codec);
  if (decoder == nullptr)
    throw MachineError(
        fmt::format("FFmpeg's libavcodec has no decoder for {}", avcodec_get_name(codec)));
  return *decoder;
}

Handle<AVCodecContext> openDecoder(const ClipInput& input, bool alpha) {
  Handle<AVCodecContext> context = owned(avcodec_alloc_context3(&decoderFor(input, alpha)));
  const std::string failure = "can't decode " + input.name();
  checkInput(avcodec_parameters_to_context(context.get(), input.stream().codecpar), failure);
  context->err_recognition = AV_EF_EXPLODE;
  context->max_pixels = kMaxDecodedPixels;
  context->export_side_data |= AV_CODEC_EXPORT_DATA_VIDEO_ENC_PARAMS;
  context->apply_cropping = 0;  // ClipReader::next() does, after it has read what is cut off.
  checkInput(avcodec_open2(context.get(), nullptr, nullptr), failure);
  return context;
}

/// Returns whether a WebM's packet holds alpha beside its picture.
bool hasAdditions(const AVPacket& packet) {
  return av_packet_get_side_data(&packet, AV_PKT_DATA_MATROSKA_BLOCKADDITIONAL, nullptr) != nullptr;
}

bool haveSameColours(const AVFrame& a, const AVFrame& b) {
  if (a.width != b.width || a.height != b.height) return false;
  for (int plane = 0; plane < 3; ++plane) {
    const int width = plane == 0 ? a.width : (a.width + 1) / 2;
    const int height = plane == 0 ? a.height : (a.height + 1) / 2;
    for (int y = 0; y < height; ++y) {
      const auto row = [&](const AVFrame& frame) {
        return frame.data[plane] + static_cast<std::ptrdiff_t>(y) * frame.linesize[plane];
      };
      if (!std::equal(row(a), row(a) + width, row(b))) return false;
    }
  }
  return true;
}

}  // namespace

ClipMetadata readClipMetadata(const std::filesystem::path& path) {
  return metadataOf(ClipInput(path));
}

ClipMetadata readClipMetadata(std::span<const std::uint8_t> bytes, const std::string& name) {
  return metadataOf(ClipInput(bytes, name));
}

PictureSize readPictureSize(const std::filesystem::path& path) {
  const ClipInput input(path, nullptr);
  const AVCodecParameters& codec = *input.stream().codecpar;
  return {codec.width, codec.height};
}

struct ClipReader::Parts {
  explicit Parts(const std::filesystem::path& path)
      : input(path), packet(owned(av_packet_alloc())), frame(owned(av_frame_alloc())) {
    facts = factsOf(input);
    hasAlpha = statesAlpha(input);
    decoder = openDecoder(input, hasAlpha);
    if (&decoderFor(input, true) != &decoderFor(input, false)) {
      otherDecoder = openDecoder(input, !hasAlpha);
    }
  }

  std::string failure() const {
    return fmt::format("{} is damaged: can't decode picture {}", input.name(), count);
  }

  /// Returns whether the decoder had a picture ready.
  bool receive() {
    const int result = avcodec_receive_frame(decoder.get(), frame.get());
    if (result == AVERROR(EAGAIN) || result == AVERROR_EOF) return false;
    checkInput(result, failure());
    picture = factsOf(*frame);
    picture.alpha = picture.alpha || hasAlpha;
    if (otherDecoder) compareWithOther();
    return true;
  }

  /// Bytes after a frame are another one to libvpx, and nothing to FFmpeg's own decoder.
  void compareWithOther() {
    const bool isThere = avcodec_receive_frame(otherDecoder.get(), other.get()) == 0;
    if (isThere && hasAlpha) {
      picture.quantiser = quantiserOf(*other);
      picture.coarsestQuantiser = coarsestQuantiserOf(*other);
    }
    if (isThere && haveSameColours(*frame, *other)) return;
    picture.messages += picture.messages.empty() ? "" : "; ";
    picture.messages += "another picture for another decoder";
  }

  /// Sends the decoder the next packet, or once reports that there are no more.
  void send() {
    const int result = av_read_frame(&input.context(), packet.get());
    ended = result == AVERROR_EOF;
    if (!ended) checkInput(result, failure());
    const AVPacket* next = ended ? nullptr : packet.get();
    if (!ended && hasAdditions(*packet)) hasAlpha = true;
    checkInput(avcodec_send_packet(decoder.get(), next), failure());
    if (otherDecoder) checkInput(avcodec_send_packet(otherDecoder.get(), next), failure());
    av_packet_unref(packet.get());
  }

  ClipInput input;
  ClipFacts facts;
  Handle<AVCodecContext> decoder;
  /// Of the same pictures, where there are two; libvpx decodes alpha, the other reports quantisers.
  Handle<AVCodecContext> otherDecoder;
  bool hasAlpha = false;  // As stated, or found so far.
  Handle<AVPacket> packet;
  Handle<AVFrame> frame;
  Handle<AVFrame> other = owned(av_frame_alloc());  // of `otherDecoder`
  PictureFacts picture;                             // of `frame`
  std::int64_t count = 0;                           // pictures decoded so far
  bool ended = false;
};

ClipReader::ClipReader(const std::filesystem::path& path) : parts_(std::make_unique<Parts>(path)) {}
ClipReader::ClipReader(ClipReader&&) noexcept = default;
ClipReader& ClipReader::operator=(ClipReader&&) noexcept = default;
ClipReader::~ClipReader() = default;

const ClipFacts& ClipReader::facts() const {
  return parts_->facts;
}

bool ClipReader::next() {
  while (!parts_->receive()) {
    if (parts_->ended) return false;
    parts_->send();
  }
  AVFrame& frame = *parts_->frame;
  checkInput(av_frame_apply_cropping(&frame, AV_FRAME_CROP_UNALIGNED), parts_->failure());
  if (frame.width != parts_->facts.width || frame.height != parts_->facts.height) {
    throw InputError(fmt::format("picture {} of {} isn't of the clip's size", parts_->count,
                                 parts_->input.name()));
  }
  ++parts_->count;
  return true;
}

const PictureFacts& ClipReader::pictureFacts() const {
  return parts_->picture;
}

double ClipReader::time() const {
  const std::int64_t ticks = parts_->frame->pts;
  if (ticks == AV_NOPTS_VALUE) return std::numeric_limits<double>::quiet_NaN();
  const AVRational unit = parts_->input.stream().time_base;
  // Rounds once: if n / rate is a multiple of the clock's unit, this is the double nearest to it.
  return static_cast<double>(ticks) * unit.num / unit.den;
}

Planes ClipReader::picture() const {
  const AVFrame& frame = *parts_->frame;
  const bool hasAlpha = frame.format == AV_PIX_FMT_YUVA420P;
  const bool isEven = frame.width % 2 == 0 && frame.height % 2 == 0;
  if (!isEven || (frame.format != AV_PIX_FMT_YUV420P && !hasAlpha)) {
    throw InputError("the pictures of " + parts_->input.name() + " aren't yuv420p of an even size");
  }
  return planesOf(frame);
}

}  // namespace rotatebook::video

#include "video/written_form.h"

#include <fstream>

#include <fmt/core.h>

#include "video/clip_input.h"
#include "video/coded_units.h"
#include "video/mp4_layout.h"
#include "video/webm_layout.h"

namespace rotatebook::video {
namespace {

/// Examines a packet's alpha, which a WebM holds beside its picture after a number of eight bytes.
std::string alphaDifference(const AVPacket& packet, const WrittenForm& form) {
  constexpr std::size_t kNumber = 8;
  std::size_t size = 0;
  const std::uint8_t* data =
      av_packet_get_side_data(&packet, AV_PKT_DATA_MATROSKA_BLOCKADDITIONAL, &size);
  if (data == nullptr) return form.transparent ? "no alpha" : "";
  return vp9Picture(Bytes(data, size).subspan(std::min(size, kNumber)), form).difference;
}

Bytes parametersOf(const ClipInput& input) {
  const AVCodecParameters& codec = *input.stream().codecpar;
  return {codec.extradata, static_cast<std::size_t>(codec.extradata_size)};
}

CodedPicture h264PictureOf(Bytes packet, const WrittenForm& form, bool first, std::int64_t frame,
                           PictureOrder& order) {
  CodedPicture picture = h264Picture(packet, first, form);
  if (!order.isPlain(packet, frame) && picture.difference.empty())
    picture.difference = "the numbers of another order";
  return picture;
}

CodedPicture vp9PictureOf(const AVPacket& packet, const WrittenForm& form) {
  const Bytes bytes(packet.data, static_cast<std::size_t>(packet.size));
  CodedPicture picture = vp9Picture(bytes, form);
  if (picture.difference.empty()) picture.difference = alphaDifference(packet, form);
  return picture;
}

/// Reads all packets; sets `difference` to the first, if there is one.
Payload readPayload(const ClipInput& input, const WrittenForm& form, std::string& difference) {
  const AVDictionary* texts = input.context().metadata;
  Payload payload{.title = Dictionary::valueIn(texts, "title"),
                  .comment = Dictionary::valueIn(texts, "comment")};
  const AVRational frame{form.frameRate.denominator, form.frameRate.numerator};
  const AVRational tick = input.stream().time_base;
  PictureOrder order(parametersOf(input));
  const Handle<AVPacket> packet = owned(av_packet_alloc());
  for (; av_read_frame(&input.context(), packet.get()) >= 0; av_packet_unref(packet.get())) {
    const Bytes bytes(packet->data, static_cast<std::size_t>(packet->size));
    const CodedPicture picture = input.format() == VideoFormat::WebM
                                     ? vp9PictureOf(*packet, form)
                                     : h264PictureOf(bytes, form, payload.sizes.empty(),
                                                     av_rescale_q(packet->pts, tick, frame), order);
    if (difference.empty() && !picture.difference.empty()) {
      difference =
          fmt::format("picture {}, as coded, holds {}", payload.sizes.size(), picture.difference);
    }
    const std::int64_t delay = packet->pts - packet->dts;
    if (payload.sizes.empty()) payload.delay = av_rescale_q(delay, input.stream().time_base, frame);
    if (picture.isKey) payload.keys.push_back(payload.sizes.size());
    payload.sizes.push_back(bytes.size());
    payload.delays.push_back(static_cast<std::uint64_t>(delay));
  }
  return payload;
}

}  // namespace

FormDifferences differencesFromWritten(const std::filesystem::path& clip, const WrittenForm& form) {
  const ClipInput input(clip);
  FormDifferences found;
  const Payload payload = readPayload(input, form, found.stream);
  std::ifstream file(clip, std::ios::binary);
  if (input.format() == VideoFormat::WebM) {
    found.container = webmDifference(file, form, payload);
    return found;
  }
  const std::string difference = h264Difference(parametersOf(input), form, payload);
  if (!difference.empty()) found.stream = difference;
  found.container = mp4Difference(file, form, payload);
  return found;
}

}  // namespace rotatebook::video

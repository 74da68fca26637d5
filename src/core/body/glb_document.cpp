#include "body/glb_document.h"

#include <string>

#include "base/error.h"
#include "base/text.h"
#include "body/mesh_words.h"
#include "body/polygon.h"

namespace rotatebook::body {
namespace {

constexpr std::uint32_t kMagic = 0x46546C67, kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;
constexpr std::size_t kMaxJson = 1 << 24;  // [bytes]
constexpr int kMaxNesting = 64;            // of lists and objects in each other

/// The chunks of a file.
struct Chunks {
  std::string_view json, binary;
};

Chunks chunksOf(std::string_view bytes) {
  MeshBytes file(bytes);
  if (bytes.size() < 12 || file.next<std::uint32_t>() != kMagic)
    throw InputError("it doesn't begin with \"glTF\": not a .glb file");
  const auto version = file.next<std::uint32_t>();
  if (version != 2) {
    throw InputError("it is of glTF " + std::to_string(version) + "; export it as glTF 2.0");
  }
  if (const auto length = file.next<std::uint32_t>(); length != bytes.size()) {
    throw InputError("it says that it has " + std::to_string(length) + " bytes, but has " +
                     std::to_string(bytes.size()) + "; is it whole?");
  }
  Chunks chunks;
  while (file.left() >= 8) {
    const auto length = file.next<std::uint32_t>();
    const auto kind = file.next<std::uint32_t>();
    const std::string_view chunk = file.take(length);
    if (kind == kJsonChunk && chunks.json.empty()) chunks.json = chunk;
    if (kind == kBinaryChunk && chunks.binary.empty()) chunks.binary = chunk;
  }
  if (chunks.json.empty() || chunks.json.size() > kMaxJson)
    throw InputError("it has no description in JSON, or one of more than 16 MiB");
  return chunks;
}

std::size_t sizeOfType(std::size_t type) {
  switch (type) {
    case 5121:
      return 1;
    case 5123:
      return 2;
    case 5125:
      return 4;
    case 5126:
      return 4;
    default:
      throw InputError("numbers of the type " + std::to_string(type) + " aren't read");
  }
}

}  // namespace

GlbDocument::GlbDocument(std::string_view bytes) {
  const Chunks chunks = chunksOf(bytes);
  binary_ = chunks.binary;
  const auto refuseDeep = [](int depth, Json::parse_event_t, const Json&) {
    if (depth <= kMaxNesting) return true;
    throw InputError("its description is nested deeper than " + std::to_string(kMaxNesting));
  };
  json_ = Json::parse(chunks.json, refuseDeep, false);
  if (!json_.is_object()) throw InputError("its description isn't JSON; export it again");
  const Json& required = member(json_, "extensionsRequired");
  if (required.is_array() && !required.empty() && required[0].is_string()) {
    throw InputError("it needs the extension " +
                     quotedText(oneLine(required[0].get<std::string>(), 60)) +
                     ", which isn't read; export it without compression");
  }
}

const GlbDocument::Json& GlbDocument::member(const Json& json, const char* name) {
  static const Json kNull;
  const auto found = json.is_object() ? json.find(name) : json.end();
  return json.is_object() && found != json.end() ? *found : kNull;
}

std::optional<std::size_t> GlbDocument::count(const Json& json, const char* name) {
  const Json& value = member(json, name);
  if (value.is_null()) return std::nullopt;
  return wholeNumber(value, name);
}

std::size_t GlbDocument::wholeNumber(const Json& value, const std::string& name) {
  constexpr std::uint64_t kLargest = 0xffffffff;  // as long as a .glb can be
  const auto number = value.is_number_unsigned() ? value.get<std::uint64_t>() : kLargest + 1;
  if (number <= kLargest) return static_cast<std::size_t>(number);
  throw InputError(name + " isn't a whole number below 2^32; export the file again");
}

std::size_t GlbDocument::size(const char* list) const {
  const Json& all = member(json_, list);
  return all.is_array() ? all.size() : 0;
}

const GlbDocument::Json& GlbDocument::at(const char* list, std::size_t index) const {
  if (index >= size(list)) {
    throw InputError(std::string(list) + " has no number " + std::to_string(index) +
                     ", which is used; export the file again");
  }
  return member(json_, list)[index];
}

std::string_view GlbDocument::view(std::size_t index) const {
  const Json& json = at("bufferViews", index);
  const Json& buffer = at("buffers", count(json, "buffer").value_or(0));
  if (!member(buffer, "uri").is_null())
    throw InputError("its data is in another file; export it as one .glb");
  const std::size_t begin = count(json, "byteOffset").value_or(0);
  const std::size_t size = count(json, "byteLength").value_or(0);
  if (begin > binary_.size() || size > binary_.size() - begin) {
    throw InputError("bufferView " + std::to_string(index) +
                     " reaches beyond the file's data; is the file whole?");
  }
  return binary_.substr(begin, size);
}

GlbDocument::Numbers GlbDocument::numbers(std::size_t index, std::string_view type,
                                          std::size_t components) const {
  const Json& accessor = at("accessors", index);
  const std::string name = "accessor " + std::to_string(index);
  const Json& kind = member(accessor, "type");
  if (!kind.is_string() || kind.get<std::string>() != type)
    throw InputError(name + " isn't of the type " + std::string(type));
  const auto viewIndex = count(accessor, "bufferView");
  if (!member(accessor, "sparse").is_null() || !viewIndex)
    throw InputError(name + " is sparse, which isn't read; export the file without morphs");

  Numbers numbers{{}, count(accessor, "count").value_or(0), 0, 0};
  numbers.type = count(accessor, "componentType").value_or(0);
  const std::size_t element = components * sizeOfType(numbers.type);
  const std::string_view bytes = view(*viewIndex);
  numbers.stride = count(at("bufferViews", *viewIndex), "byteStride").value_or(element);
  const std::size_t begin = count(accessor, "byteOffset").value_or(0);
  requireFewTriangles(numbers.count / 3);
  const bool isInView = begin <= bytes.size() && numbers.stride >= element &&
                        numbers.stride <= 252 + element &&
                        (numbers.count == 0 ||
                         (element <= bytes.size() - begin &&
                          numbers.count - 1 <= (bytes.size() - begin - element) / numbers.stride));
  if (!isInView) throw InputError(name + " reaches beyond the file's data; is the file whole?");
  numbers.bytes = bytes.substr(begin);
  return numbers;
}

}  // namespace rotatebook::body

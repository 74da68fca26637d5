#include "meshes/glb_document.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/text.h"
#include "meshes/mesh_words.h"
#include "meshes/polygon.h"

namespace rotatebook::meshes {
namespace {

constexpr std::uint32_t kMagic = 0x46546C67, kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;
constexpr std::size_t kMaxJson = 1 << 24;       // [bytes]
constexpr int kMaxNesting = 64;                 // of lists and objects in each other
constexpr std::size_t kMaxObjects = 2'000'000;  // lists and objects; they take 0.4 s

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
    throw InputError(
        "it says that it has " + std::to_string(length) + " bytes, but has " +
        std::to_string(bytes.size()) +
        (length > bytes.size() ? "; is it whole?" : ": others follow its end; export it again"));
  }
  Chunks chunks;
  while (file.left() >= 8) {
    const auto length = file.next<std::uint32_t>();
    const auto kind = file.next<std::uint32_t>();
    const std::string_view chunk = file.take(length);
    if (kind == kJsonChunk && chunks.json.empty()) chunks.json = chunk;
    if (kind == kBinaryChunk && chunks.binary.empty()) chunks.binary = chunk;
  }
  if (chunks.json.empty()) throw InputError("it has no description in JSON; export it again");
  if (chunks.json.size() > kMaxJson) {
    throw InputError("its description has more than 16 MiB; export it with its meshes joined");
  }
  return chunks;
}

/// Members of the document that are read; of the others there may be millions.
constexpr std::array<std::string_view, 13> kRead{
    "accessors", "bufferViews", "buffers", "extensionsRequired", "images",
    "materials", "meshes",      "nodes",   "samplers",           "scene",
    "scenes",    "skins",       "textures"};

/// Members of any object that aren't read, either.
constexpr std::array<std::string_view, 4> kLeftOut{"extras", "max", "min", "name"};

/// Makes a document of a description, without what isn't read.
class Builder : public nlohmann::json_sax<GlbDocument::Json> {
 public:
  using Json = GlbDocument::Json;

  Json take() { return std::move(document_); }

  bool null() override { return put(nullptr); }
  bool boolean(bool value) override { return put(value); }
  bool number_integer(number_integer_t value) override { return put(value); }
  bool number_unsigned(number_unsigned_t value) override { return put(value); }
  bool number_float(number_float_t value, const string_t&) override { return put(value); }
  bool string(string_t& value) override { return put(std::move(value)); }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return enter(Json::value_t::object); }
  bool start_array(std::size_t) override { return enter(Json::value_t::array); }
  bool end_object() override { return leave(); }
  bool end_array() override { return leave(); }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override {
    document_ = nullptr;
    return false;
  }
  bool key(string_t& name) override {
    name_ = std::move(name);
    return true;
  }

 private:
  bool isLeftOut() const {
    if (left_ > 0) return true;
    if (open_.empty() || !open_.back()->is_object()) return false;
    return std::ranges::count(kLeftOut, name_) > 0 ||
           (open_.size() == 1 && std::ranges::count(kRead, name_) == 0);
  }

  /// Returns where a value is then, which isn't left out.
  Json& added(Json&& value) {
    if (open_.empty()) return document_ = std::move(value);
    Json& parent = *open_.back();
    if (parent.is_object()) return parent[name_] = std::move(value);
    parent.push_back(std::move(value));
    return parent.back();
  }

  bool put(Json value) {
    if (!isLeftOut()) added(std::move(value));
    return true;
  }

  bool enter(Json::value_t type) {
    if (isLeftOut()) {
      ++left_;
      return true;
    }
    if (++count_ > kMaxObjects) {
      throw InputError("it has more than " + std::to_string(kMaxObjects) +
                       " lists and objects; export it with its meshes joined");
    }
    open_.push_back(&added(type));
    return true;
  }

  bool leave() {
    if (left_ > 0) {
      --left_;
    } else {
      open_.pop_back();
    }
    return true;
  }

  Json document_;
  std::vector<Json*> open_;  // From the document to the innermost list or object.
  std::string name_;         // Of the next member.
  std::size_t left_ = 0;     // Lists and objects that are left out, in each other.
  std::size_t count_ = 0;
};

/// Throws InputError if lists and objects are nested too deep to be read with a function's calls.
void requireShallow(std::string_view json) {
  int depth = 0;
  bool isText = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char letter = json[i];
    if (isText && letter == '\\') ++i;
    if (letter == '"') isText = !isText;
    if (isText) continue;
    depth += letter == '{' || letter == '[' ? 1 : letter == '}' || letter == ']' ? -1 : 0;
    if (depth > kMaxNesting) {
      throw InputError("its description is nested deeper than " + std::to_string(kMaxNesting) +
                       "; export the file again");
    }
  }
}

/// Returns the six bits of a letter of base64; nothing if it is none.
std::optional<std::uint32_t> sixBitsOf(char letter) {
  constexpr std::string_view kLetters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::size_t found = kLetters.find(letter);
  if (found == kLetters.npos) return std::nullopt;
  return static_cast<std::uint32_t>(found);
}

}  // namespace

std::optional<std::string> dataOfUri(const GlbDocument::Json& uri) {
  constexpr std::string_view kBase64 = ";base64,";
  if (!uri.is_string()) return std::nullopt;
  std::string_view text = uri.get_ref<const std::string&>();
  if (!text.starts_with("data:")) return std::nullopt;
  const std::size_t begin = text.find(kBase64);
  if (begin == text.npos) throw InputError("it has data that isn't base64; export it again");
  text.remove_prefix(begin + kBase64.size());
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char letter : text.substr(0, text.find('='))) {
    const auto six = sixBitsOf(letter);
    if (!six) throw InputError("it has data that isn't base64; export it again");
    bits = bits << 6 | *six;
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 0xff);
  }
  return bytes;
}

GlbDocument::GlbDocument(std::string_view bytes) {
  Chunks chunks = chunksOf(bytes);
  chunks.json = withoutPadding(chunks.json);
  binary_ = chunks.binary;
  requireShallow(chunks.json);
  Builder builder;
  Json::sax_parse(chunks.json, &builder);
  json_ = builder.take();
  if (!json_.is_object()) throw InputError("its description isn't JSON; export it again");
  for (const Json& name : member(json_, "extensionsRequired"))
    if (name.is_string()) required_.insert(name.get<std::string>());
  for (std::size_t i = 0; i < size("buffers"); ++i)
    decoded_.push_back(dataOfUri(member(at("buffers", i), "uri")).value_or(""));
}

const GlbDocument::Json& GlbDocument::member(const Json& json, const char* name) {
  static const Json kNull;
  const auto found = json.is_object() ? json.find(name) : json.end();
  return json.is_object() && found != json.end() ? *found : kNull;
}

std::optional<std::size_t> GlbDocument::count(const Json& json, const char* name) {
  const Json& value = member(json, name);
  if (value.is_null()) return std::nullopt;
  return wholeNumber(value, "its " + quotedText(name));
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
    throw InputError("number " + std::to_string(index) + " of " + list +
                     " is used but isn't there; export the file again");
  }
  return member(json_, list)[index];
}

std::string_view GlbDocument::buffer(std::size_t index) const {
  const Json& uri = member(at("buffers", index), "uri");
  if (!decoded_[index].empty()) return decoded_[index];
  if (!uri.is_null()) throw InputError("its data is in another file; export it as one .glb");
  // The file's own data is the first buffer
  return index == 0 ? binary_ : std::string_view();
}

std::string_view GlbDocument::view(std::size_t index) const {
  const Json& json = at("bufferViews", index);
  const std::string_view bytes = buffer(count(json, "buffer").value_or(0));
  const std::size_t begin = count(json, "byteOffset").value_or(0);
  const std::size_t size = count(json, "byteLength").value_or(0);
  if (begin > bytes.size() || size > bytes.size() - begin) {
    throw InputError("bufferView " + std::to_string(index) +
                     " reaches beyond the file's data; is the file whole?");
  }
  return bytes.substr(begin, size);
}

}  // namespace rotatebook::meshes

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/file_text.h"
#include "base/number_text.h"
#include "base/text.h"
#include "meshes/mesh_readers.h"
#include "meshes/mesh_words.h"
#include "meshes/polygon.h"

namespace rotatebook::meshes {
namespace {

constexpr std::int64_t kMaxCorners = 10'000;              // of a polygon
constexpr std::int64_t kMaxList = std::int64_t{1} << 31;  // of others, which must be there
constexpr std::size_t kMaxProperties = 100;               // of an element, as deep as its lines go

/// The kinds of numbers, in two spellings.
enum class Type { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };
constexpr std::string_view kTypeNames[][2] = {
    {"char", "int8"}, {"uchar", "uint8"}, {"short", "int16"},   {"ushort", "uint16"},
    {"int", "int32"}, {"uint", "uint32"}, {"float", "float32"}, {"double", "float64"}};

struct Property {
  std::string_view name;
  Type type{};
  std::optional<Type> count{};  ///< The type of a list's length.
};

struct Element {
  std::string_view name;
  std::int64_t count = 0;
  std::vector<Property> properties{};
};

enum class Encoding { Text, LittleEndian, BigEndian };

struct Header {
  Encoding encoding = Encoding::Text;
  std::vector<Element> elements{};
};

Type typeOf(std::string_view name, const MeshWords& words) {
  for (std::size_t i = 0; i < std::size(kTypeNames); ++i) {
    if (name == kTypeNames[i][0] || name == kTypeNames[i][1]) return static_cast<Type>(i);
  }
  words.fail("unknown type " + quotedBeginning(name, 40) +
             "; write one of PLY's, such as float or int");
}

Encoding encodingOf(std::string_view name, const MeshWords& words) {
  if (name == "ascii") return Encoding::Text;
  if (name == "binary_little_endian") return Encoding::LittleEndian;
  if (name == "binary_big_endian") return Encoding::BigEndian;
  words.fail("unknown format " + quotedBeginning(name, 40) +
             "; ascii, binary_little_endian or binary_big_endian");
}

Property readProperty(MeshWords& words) {
  Property property;
  std::string_view type = words.word();
  if (type == "list") {
    property.count = typeOf(words.word(), words);
    type = words.word();
  }
  property.type = typeOf(type, words);
  property.name = words.word();
  return property;
}

/// Reads a line of the header; returns false at its end.
bool readHeaderLine(MeshWords& words, Header& header) {
  const std::string_view kind = words.word();
  if (kind == "end_header") return false;
  if (kind == "format") {
    header.encoding = encodingOf(words.word(), words);
  } else if (kind == "element") {
    const std::string_view name = words.word();
    const std::int64_t count = words.integer("the number of elements");
    if (count < 0) words.fail("there can't be " + std::to_string(count) + " elements");
    if (header.elements.size() >= kMaxProperties) {
      words.fail("more than " + std::to_string(kMaxProperties) +
                 " kinds of elements; leave out what is neither vertex nor face");
    }
    header.elements.push_back({name, count});
  } else if (kind == "property") {
    if (header.elements.empty())
      words.fail("a property comes before any element that could have it");
    if (header.elements.back().properties.size() >= kMaxProperties)
      words.fail("more than " + std::to_string(kMaxProperties) +
                 " properties; leave out what is neither x, y, z nor vertex_indices");
    header.elements.back().properties.push_back(readProperty(words));
  } else if (kind != "ply" && kind != "comment" && kind != "obj_info" && !kind.empty()) {
    words.fail("not a line of a PLY header: " + quotedBeginning(kind, 40));
  }
  return true;
}

/// The numbers of a file's data, in either encoding.
class Numbers {
 public:
  /// Takes the data of a file, after a header of so many bytes and lines.
  Numbers(std::string_view data, Encoding encoding, std::size_t headerBytes,
          std::size_t headerLines)
      : isText_(encoding == Encoding::Text),
        headerLines_(headerLines),
        words_(isText_ ? withoutPadding(data) : ""),
        bytes_(data, headerBytes, encoding == Encoding::BigEndian) {}

  double next(Type type) {
    if (isText_) return textNumber();
    switch (type) {
      case Type::Int8:
        return bytes_.next<std::int8_t>();
      case Type::Uint8:
        return bytes_.next<std::uint8_t>();
      case Type::Int16:
        return bytes_.next<std::int16_t>();
      case Type::Uint16:
        return bytes_.next<std::uint16_t>();
      case Type::Int32:
        return bytes_.next<std::int32_t>();
      case Type::Uint32:
        return bytes_.next<std::uint32_t>();
      case Type::Float32:
        return static_cast<double>(bytes_.next<float>());
      case Type::Float64:
        return bytes_.next<double>();
    }
    return 0;
  }

  /// Throws InputError if there is more than blanks and comments after the last number.
  void requireEnd() {
    const std::size_t left = isText_ ? wordAfterComments().size() : bytes_.left();
    if (left == 0 || (!isText_ && trimmed(bytes_.take(left)).empty())) return;
    fail("the file goes on after its data; are the header's numbers of elements right?");
  }

  [[noreturn]] void fail(const std::string& message) const {
    throw InputError((isText_ ? "line " + std::to_string(headerLines_ + words_.line())
                              : "byte " + std::to_string(bytes_.at())) +
                     ": " + message);
  }

 private:
  std::string_view wordAfterComments() {
    std::string_view word = words_.wordOnAnyLine();
    while (word == "comment") {
      words_.restOfLine();
      word = words_.wordOnAnyLine();
    }
    return word;
  }

  double textNumber() {
    const std::string_view word = wordAfterComments();
    if (word.empty()) fail("the file ends within its data; is it whole?");
    const auto number = numberIn(word);
    if (!number) fail("this" + noNumber(word));
    return *number;
  }

  bool isText_;
  std::size_t headerLines_;
  MeshWords words_;
  MeshBytes bytes_;
};

std::int64_t lengthOf(const Property& property, Numbers& numbers, std::int64_t most = kMaxList) {
  if (!property.count) return 1;
  const double length = numbers.next(*property.count);
  if (!(length >= 0 && length <= static_cast<double>(most) && length == std::floor(length)))
    numbers.fail("a list has " + shortestText(length) + " numbers, and must have 0 to " +
                 std::to_string(most) +
                 (length > static_cast<double>(most) ? "; export triangles" : "; export it again"));
  return static_cast<std::int64_t>(length);
}

void skip(const Property& property, Numbers& numbers) {
  const std::int64_t length = lengthOf(property, numbers);
  for (std::int64_t i = 0; i < length; ++i) numbers.next(property.type);
}

bool isAxis(std::string_view name) {
  return name == "x" || name == "y" || name == "z";
}

bool hasCorners(const Property& property) {
  return property.count && (property.name == "vertex_indices" || property.name == "vertex_index");
}

/// Makes a mesh of a file's elements, in whichever order they are.
class MeshBuilder {
 public:
  MeshBuilder(const std::vector<Element>& elements, Numbers& numbers) : numbers_(numbers) {
    for (const Element& element : elements) {
      if (element.name == "vertex") vertices_ += std::min(element.count, kMaxList);
    }
  }

  void readElement(const Element& element) {
    if (element.name == "vertex") {
      readVertex(element);
    } else if (element.name == "face" || element.name == "tristrips") {
      readFaces(element);
    } else {
      for (const Property& property : element.properties) skip(property, numbers_);
    }
  }

  body::TriangleMesh finish() {
    std::span<const std::uint32_t> corners = corners_;
    for (const std::size_t length : lengths_) {
      addPolygon(corners.first(length), mesh_);
      corners = corners.subspan(length);
    }
    return std::move(mesh_);
  }

 private:
  void readVertex(const Element& element) {
    Eigen::Vector3d point(0, 0, 0);
    for (const Property& property : element.properties) {
      if (isAxis(property.name) && !property.count) {
        point[property.name[0] - 'x'] = numbers_.next(property.type);
      } else {
        skip(property, numbers_);
      }
    }
    requireFewPoints(mesh_.points.size() + 1);
    mesh_.points.push_back(point);
  }

  /// Reads a face, or strips of triangles.
  void readFaces(const Element& element) {
    for (const Property& property : element.properties) {
      if (!hasCorners(property)) {
        skip(property, numbers_);
      } else if (element.name == "face") {
        readPolygon(property);
      } else {
        readStrips(property);
      }
    }
  }

  void readPolygon(const Property& property) {
    std::vector<std::uint32_t> corners;
    const std::int64_t length = lengthOf(property, numbers_, kMaxCorners);
    for (std::int64_t i = 0; i < length; ++i)
      corners.push_back(vertexOf(numbers_.next(property.type)));
    if (corners.size() < 3) {
      numbers_.fail("a face has " + countText(std::ssize(corners), "corner") +
                    "; it must have three or more: take it away");
    }
    if (static_cast<std::int64_t>(mesh_.points.size()) == vertices_) {
      addPolygon(corners, mesh_);
      return;
    }
    requireFewTriangles((corners_.size() + corners.size()) / 3);
    corners_.insert(corners_.end(), corners.begin(), corners.end());
    lengths_.push_back(corners.size());
  }

  /// Reads strips, in which each vertex makes a triangle with the two before it; -1 begins the
  /// next. Every second triangle runs backward.
  void readStrips(const Property& property) {
    const std::int64_t length = lengthOf(property, numbers_);
    std::array<std::uint32_t, 2> last{};
    std::size_t count = 0;
    for (std::int64_t i = 0; i < length; ++i) {
      const double number = numbers_.next(property.type);
      if (number == -1) {
        count = 0;
        continue;
      }
      const std::uint32_t vertex = vertexOf(number);
      if (++count > 2) {
        requireFewTriangles(mesh_.triangles.size() + 1);
        const bool isForward = count % 2 == 1;
        mesh_.triangles.push_back({last[isForward ? 0 : 1], last[isForward ? 1 : 0], vertex});
      }
      last = {last[1], vertex};
    }
  }

  std::uint32_t vertexOf(double number) const {
    const bool isVertex = number >= 0 && number < static_cast<double>(vertices_);
    if (!isVertex || number != std::floor(number)) {
      numbers_.fail("a face names a vertex that doesn't exist; there are " +
                    std::to_string(vertices_) + ": export it again");
    }
    requireFewPoints(static_cast<std::size_t>(number));
    return static_cast<std::uint32_t>(number);
  }

  Numbers& numbers_;
  std::int64_t vertices_ = 0;  // As many as the header says.
  body::TriangleMesh mesh_;
  std::vector<std::uint32_t> corners_;  // Of faces before their vertices,
  std::vector<std::size_t> lengths_;    // and how many each has.
};

/// An element without properties takes no bytes, so that its number would be free to claim.
void requireProperties(const Element& element) {
  if (!element.properties.empty() || element.count == 0) return;
  throw InputError("the element " + quotedBeginning(element.name, 40) + " has no properties");
}

/// Throws InputError if the header has faces without corners, or vertices without coordinates.
void requireNames(const Header& header) {
  for (const Element& element : header.elements) {
    if (element.count == 0) continue;
    const auto has = [&](const auto& isWanted) {
      return std::ranges::any_of(element.properties, isWanted);
    };
    if (element.name == "face" && !has(hasCorners))
      throw InputError("its faces have no list \"vertex_indices\"; name that of their corners so");
    for (const std::string_view axis : {"x", "y", "z"}) {
      if (element.name != "vertex" || has([&](const Property& p) { return p.name == axis; }))
        continue;
      throw InputError("its vertices have no property " + quotedText(axis) +
                       "; name their coordinates x, y and z");
    }
  }
}

/// Returns what follows the header's last line, which ends as its first line does: a carriage
/// return may be the end, or be followed by a line feed.
std::string_view dataAfter(std::string_view rest, std::string_view file) {
  const std::size_t first = file.find_first_of("\r\n");
  const bool isReturn =
      first != file.npos && file[first] == '\r' && file.substr(first, 2) != "\r\n";
  const std::size_t end = rest.find(isReturn ? '\r' : '\n');
  return end == rest.npos ? "" : rest.substr(end + 1);
}

}  // namespace

body::TriangleMesh readPly(std::string_view bytes) {
  std::string decoded;
  const std::string_view file = textOfFile(bytes, decoded);
  refuseUtf16(file);
  MeshWords words(file);
  if (words.word() != "ply") throw InputError("it doesn't begin with \"ply\": not a PLY file");
  Header header;
  while (readHeaderLine(words, header)) {
    if (!words.nextLine()) words.fail("the header has no end_header; is the file whole?");
  }
  const std::string_view data = dataAfter(words.everything(), file);
  Numbers numbers(data, header.encoding, bytes.size() - data.size(), words.line());
  MeshBuilder builder(header.elements, numbers);
  for (const Element& element : header.elements) {
    requireProperties(element);
    for (std::int64_t i = 0; i < element.count; ++i) builder.readElement(element);
  }
  numbers.requireEnd();
  requireNames(header);
  return builder.finish();
}

}  // namespace rotatebook::meshes

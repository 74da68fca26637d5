#include <cmath>
#include <optional>
#include <vector>

#include "base/error.h"
#include "base/text.h"
#include "body/mesh_readers.h"
#include "body/mesh_words.h"
#include "body/polygon.h"

namespace rotatebook::body {
namespace {

constexpr std::int64_t kMaxCorners = 10'000;  // of a polygon
constexpr std::size_t kMaxProperties = 100;   // of an element, as deep as its lines go

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
  words.fail("unknown type " + quotedText(oneLine(name, 40)) +
             "; \"float\" or \"int\", for example");
}

Encoding encodingOf(std::string_view name, const MeshWords& words) {
  if (name == "ascii") return Encoding::Text;
  if (name == "binary_little_endian") return Encoding::LittleEndian;
  if (name == "binary_big_endian") return Encoding::BigEndian;
  words.fail("unknown format " + quotedText(oneLine(name, 40)) +
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
    if (count < 0 || header.elements.size() >= kMaxProperties) words.fail("not a PLY header");
    header.elements.push_back({name, count});
  } else if (kind == "property") {
    if (header.elements.empty()) words.fail("a property before the first element");
    if (header.elements.back().properties.size() >= kMaxProperties)
      words.fail("more than " + std::to_string(kMaxProperties) + " properties");
    header.elements.back().properties.push_back(readProperty(words));
  } else if (kind != "ply" && kind != "comment" && kind != "obj_info" && !kind.empty()) {
    words.fail("not a line of a PLY header: " + quotedText(oneLine(kind, 40)));
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
        words_(isText_ ? data : ""),
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

  /// Throws InputError if there is more than blanks after the last number.
  void requireEnd() {
    const std::size_t left = isText_ ? words_.wordOnAnyLine().size() : bytes_.left();
    if (left == 0 || (!isText_ && trimmed(bytes_.take(left)).empty())) return;
    fail("the file goes on after its data; are the header's numbers of elements right?");
  }

  [[noreturn]] void fail(const std::string& message) const {
    throw InputError((isText_ ? "line " + std::to_string(headerLines_ + words_.line())
                              : "byte " + std::to_string(bytes_.at())) +
                     ": " + message);
  }

 private:
  double textNumber() {
    const std::string_view word = words_.wordOnAnyLine();
    if (word.empty()) fail("the file ends within its data; is it whole?");
    const auto number = numberIn(word);
    if (!number) fail("a number is expected here, not " + quotedText(oneLine(word, 40)));
    return *number;
  }

  bool isText_;
  std::size_t headerLines_;
  MeshWords words_;
  MeshBytes bytes_;
};

std::int64_t lengthOf(const Property& list, Numbers& numbers) {
  const double length = numbers.next(*list.count);
  if (!(length >= 0 && length <= static_cast<double>(kMaxCorners) && length == std::floor(length)))
    numbers.fail("a list must have 0 to " + std::to_string(kMaxCorners) + " numbers");
  return static_cast<std::int64_t>(length);
}

void readVertex(const Element& element, Numbers& numbers, TriangleMesh& mesh) {
  Eigen::Vector3d point(0, 0, 0);
  for (const Property& property : element.properties) {
    const std::int64_t length = property.count ? lengthOf(property, numbers) : 1;
    for (std::int64_t i = 0; i < length; ++i) {
      const double number = numbers.next(property.type);
      const std::size_t axis = std::string_view("xyz").find(property.name);
      if (property.name.size() == 1 && axis < 3) point[static_cast<Eigen::Index>(axis)] = number;
    }
  }
  requireFewPoints(mesh.points.size() + 1);
  mesh.points.push_back(point);
}

void readPlyFace(const Element& element, Numbers& numbers, TriangleMesh& mesh) {
  for (const Property& property : element.properties) {
    const bool isCorners =
        property.count && (property.name == "vertex_indices" || property.name == "vertex_index");
    std::vector<std::uint32_t> corners;
    const std::int64_t length = property.count ? lengthOf(property, numbers) : 1;
    for (std::int64_t i = 0; i < length; ++i) {
      const double number = numbers.next(property.type);
      if (!isCorners) continue;
      const bool isVertex = number >= 0 && number < static_cast<double>(mesh.points.size());
      if (!isVertex || number != std::floor(number)) {
        numbers.fail("a face names a vertex that doesn't exist; there are " +
                     std::to_string(mesh.points.size()));
      }
      corners.push_back(static_cast<std::uint32_t>(number));
    }
    if (isCorners && corners.size() < 3) numbers.fail("a face must have three corners or more");
    addPolygon(corners, mesh);
  }
}

void skip(const Element& element, Numbers& numbers) {
  for (const Property& property : element.properties) {
    const std::int64_t length = property.count ? lengthOf(property, numbers) : 1;
    for (std::int64_t i = 0; i < length; ++i) numbers.next(property.type);
  }
}

/// An element without properties takes no bytes, so that its number would be free to claim.
void requireProperties(const Element& element) {
  if (!element.properties.empty() || element.count == 0) return;
  throw InputError("the element " + quotedText(oneLine(element.name, 40)) + " has no properties");
}

}  // namespace

TriangleMesh readPly(std::string_view bytes) {
  MeshWords words(bytes);
  if (words.word() != "ply") throw InputError("it doesn't begin with \"ply\": not a PLY file");
  Header header;
  while (readHeaderLine(words, header)) {
    if (!words.nextLine()) words.fail("the header has no end_header; is the file whole?");
  }
  const std::size_t headerLines = words.line();
  if (!words.nextLine()) return {};
  const std::string_view data = words.everything();
  Numbers numbers(data, header.encoding, bytes.size() - data.size(), headerLines);
  TriangleMesh mesh;
  for (const Element& element : header.elements) {
    requireProperties(element);
    for (std::int64_t i = 0; i < element.count; ++i) {
      if (element.name == "vertex") {
        readVertex(element, numbers, mesh);
      } else if (element.name == "face") {
        readPlyFace(element, numbers, mesh);
      } else {
        skip(element, numbers);
      }
    }
  }
  numbers.requireEnd();
  return mesh;
}

}  // namespace rotatebook::body

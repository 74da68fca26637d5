#include "meshes/glb_numbers.h"

#include <algorithm>

#include "base/error.h"
#include "base/text.h"
#include "meshes/glb_extensions.h"
#include "meshes/mesh_words.h"
#include "meshes/polygon.h"

namespace rotatebook::meshes {
namespace {

using Json = GlbDocument::Json;

constexpr std::size_t kMaxSparse = std::size_t{1} << 28;  // [bytes]

/// Returns the bytes of a component of a type, by the numbers of OpenGL.
std::size_t sizeOfType(std::size_t type) {
  switch (type) {
    case 5120:  // signed, then unsigned, of 1 byte
    case 5121:
      return 1;
    case 5122:  // of 2 bytes
    case 5123:
      return 2;
    case 5125:  // unsigned, of 4 bytes
    case 5126:  // a float
      return 4;
    default:
      throw InputError("numbers of the type " + std::to_string(type) +
                       " aren't read; export the file again");
  }
}

template <typename Number>
Number numberAt(std::string_view bytes) {
  return MeshBytes(bytes).next<Number>();
}

}  // namespace

std::string_view GlbNumbers::rowsIn(const GlbDocument& document, const Json& json,
                                    std::size_t count, std::size_t element, std::size_t& stride,
                                    const std::string& what) {
  const std::size_t index = GlbDocument::count(json, "bufferView").value_or(0);
  requireUncompressed(document, document.at("bufferViews", index), what);
  const std::string_view bytes = document.view(index);
  stride = GlbDocument::count(document.at("bufferViews", index), "byteStride").value_or(element);
  const std::size_t begin = GlbDocument::count(json, "byteOffset").value_or(0);
  if (stride < element || stride > 252 + element) {
    throw InputError(what + " has rows of " + std::to_string(element) + " bytes that are " +
                     std::to_string(stride) + " apart; export the file again");
  }
  const bool isInView = begin <= bytes.size() &&
                        (count == 0 || (element <= bytes.size() - begin &&
                                        count - 1 <= (bytes.size() - begin - element) / stride));
  if (!isInView) throw InputError(what + " reaches beyond the file's data; is the file whole?");
  return bytes.substr(begin);
}

GlbNumbers::GlbNumbers(const GlbDocument& document, std::size_t index, const Wanted& wanted) {
  const Json& accessor = document.at("accessors", index);
  const std::string name = "accessor " + std::to_string(index);
  requireUncompressed(document, accessor, name);
  const Json& kind = GlbDocument::member(accessor, "type");
  if (!kind.is_string() || kind.get_ref<const std::string&>() != wanted.type) {
    throw InputError(name + " isn't of the type " + std::string(wanted.type) +
                     "; export the file again");
  }
  count_ = GlbDocument::count(accessor, "count").value_or(0);
  type_ = GlbDocument::count(accessor, "componentType").value_or(0);
  isNormalised_ = GlbDocument::member(accessor, "normalized") == true;
  requireFewTriangles(count_ / 3);
  if (wanted.count && count_ != *wanted.count) {
    throw InputError(name + " has " + std::to_string(count_) + " rows, but its mesh has " +
                     std::to_string(*wanted.count));
  }
  const std::size_t element = wanted.components * sizeOfType(type_);
  const Json& sparse = GlbDocument::member(accessor, "sparse");
  if (!sparse.is_null() && count_ > kMaxSparse / element)
    throw InputError(name + " is sparse, and has more than 256 MiB; export it again");
  if (GlbDocument::member(accessor, "bufferView").is_null()) {
    if (sparse.is_null()) {
      throw InputError(name +
                       " has no bufferView, and isn't sparse: its numbers aren't in the file, or "
                       "are compressed; export it again, without compression");
    }
    own_ = std::make_shared<const std::string>(count_ * element, '\0');
    bytes_ = *own_;
    stride_ = element;
  } else {
    bytes_ = rowsIn(document, accessor, count_, element, stride_, name);
  }
  if (!sparse.is_null()) putSparse(document, sparse, element, name);
}

/// Puts the rows that a sparse accessor states in place of those of its view.
void GlbNumbers::putSparse(const GlbDocument& document, const Json& sparse, std::size_t element,
                           const std::string& name) {
  std::string dense(count_ * element, '\0');
  for (std::size_t row = 0; row < count_; ++row)
    bytes_.copy(dense.data() + row * element, element, row * stride_);
  const std::size_t changed = GlbDocument::count(sparse, "count").value_or(0);
  requireFewTriangles(changed / 3);
  const Json& places = GlbDocument::member(sparse, "indices");
  GlbNumbers rows = *this;  // of the indices
  rows.type_ = GlbDocument::count(places, "componentType").value_or(0);
  rows.bytes_ = rowsIn(document, places, changed, sizeOfType(rows.type_), rows.stride_, name);
  std::size_t stride = 0;
  const std::string_view values =
      rowsIn(document, GlbDocument::member(sparse, "values"), changed, element, stride, name);
  for (std::size_t i = 0; i < changed; ++i) {
    const std::size_t row = rows.indexAt(i);
    if (row >= count_)
      throw InputError(name + " changes a row that it doesn't have; export the file again");
    values.copy(dense.data() + row * element, element, i * stride);
  }
  own_ = std::make_shared<const std::string>(std::move(dense));
  bytes_ = *own_;
  stride_ = element;
}

double GlbNumbers::at(std::size_t row, std::size_t component) const {
  const std::string_view bytes = bytes_.substr(row * stride_ + component * sizeOfType(type_));
  const auto from = [&](auto number, double largest) {
    return isNormalised_ ? std::max(number / largest, -1.0) : static_cast<double>(number);
  };
  switch (type_) {
    case 5120:
      return from(numberAt<std::int8_t>(bytes), 127);
    case 5121:
      return from(numberAt<std::uint8_t>(bytes), 255);
    case 5122:
      return from(numberAt<std::int16_t>(bytes), 32767);
    case 5123:
      return from(numberAt<std::uint16_t>(bytes), 65535);
    case 5125:
      return static_cast<double>(numberAt<std::uint32_t>(bytes));
    default:
      return static_cast<double>(numberAt<float>(bytes));
  }
}

std::uint32_t GlbNumbers::indexAt(std::size_t row, std::size_t component) const {
  if (type_ != 5121 && type_ != 5123 && type_ != 5125) {
    throw InputError("indices are of the type " + std::to_string(type_) +
                     "; they must be whole numbers from 0 on");
  }
  const std::string_view bytes = bytes_.substr(row * stride_ + component * sizeOfType(type_));
  return type_ == 5121   ? numberAt<std::uint8_t>(bytes)
         : type_ == 5123 ? numberAt<std::uint16_t>(bytes)
                         : numberAt<std::uint32_t>(bytes);
}

}  // namespace rotatebook::meshes

#include "system/program_mark.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <stdexcept>
#include <string_view>

#include "base/error.h"
#include "system/atomic_file.h"

namespace rotatebook::system {
namespace {

using std::string_view_literals::operator""sv;

/// The end of a format's files, and the mark before it.
struct MarkedEnd {
  std::string_view mark, end;
};

// A chunk is its length, its name, its content and their checksum.
constexpr std::array<MarkedEnd, 4> kMarkedEnds{
    {{"\0\0\0\x13tEXtSoftware\0rotatebook\x64\x3b\x67\x07"sv, "\0\0\0\0IEND\xae\x42\x60\x82"sv},
     {"\x21\xfe\x0arotatebook\0"sv, "\x3b"sv},
     {"<!-- rotatebook -->\n"sv, "</svg>\n"sv},
     {"%rotatebook\n"sv, "%%EOF\n"sv}}};

constexpr std::string_view kMarkBox =
    "\0\0\0\x12"
    "freerotatebook"sv;

const MarkedEnd& endOf(std::string_view bytes) {
  const auto format = std::ranges::find_if(
      kMarkedEnds, [&](const MarkedEnd& one) { return bytes.ends_with(one.end); });
  if (format == kMarkedEnds.end()) throw std::logic_error("a mark needs a complete picture");
  return *format;
}

/// Returns the last bytes of a file; empty if it can't be read.
std::string tailOf(const std::filesystem::path& file) {
  constexpr std::streamoff kTail = 64;
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  const std::streamoff size = stream.tellg();
  if (!stream || size <= 0) return {};
  std::string tail(static_cast<std::size_t>(std::min(size, kTail)), '\0');
  stream.seekg(-std::ssize(tail), std::ios::end);
  stream.read(tail.data(), std::ssize(tail));
  return stream ? tail : std::string();
}

}  // namespace

void addProgramMark(std::string& bytes) {
  const MarkedEnd& format = endOf(bytes);
  bytes.insert(bytes.size() - format.end.size(), format.mark);
}

void addProgramMark(const std::filesystem::path& file) {
  std::string marked = tailOf(file);
  const std::streamoff unmarked = std::ssize(marked);
  if (!marked.empty()) addProgramMark(marked);
  std::fstream stream(file, std::ios::binary | std::ios::in | std::ios::out);
  stream.seekp(-unmarked, std::ios::end);
  stream.write(marked.data(), std::ssize(marked));
  stream.close();
  if (!stream || marked.empty()) throw MachineError("can't write " + file.string());
}

void addProgramBox(const std::filesystem::path& file) {
  std::ofstream stream(file, std::ios::binary | std::ios::app);
  stream << kMarkBox;
  stream.close();
  if (!stream) throw MachineError("can't write " + file.string());
}

void writeMarked(const std::filesystem::path& file, std::string bytes) {
  addProgramMark(bytes);
  writeFileAtomically(file, bytes);
}

bool hasProgramMark(const std::filesystem::path& file) {
  const std::string tail = tailOf(file);
  if (tail.ends_with(kMarkBox)) return true;
  return std::ranges::any_of(kMarkedEnds, [&](const MarkedEnd& format) {
    return tail.find(std::string(format.mark) + std::string(format.end)) != tail.npos;
  });
}

}  // namespace rotatebook::system

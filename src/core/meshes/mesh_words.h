// Words and numbers of text meshes, and numbers of binary ones. Inside the room only.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>

namespace rotatebook::meshes {

static_assert(std::endian::native == std::endian::little, "meshes' bytes are read as they are");

/// The words of a text, separated by spaces, with the line that they are on. A line ends with a
/// line feed, a carriage return, or both.
class MeshWords {
 public:
  /// Of Wavefront: "#" begins a comment, and "\\" at its end joins a line to the next.
  enum class Syntax { Plain, Wavefront };

  explicit MeshWords(std::string_view text, Syntax syntax = Syntax::Plain)
      : rest_(text), isWavefront_(syntax == Syntax::Wavefront) {}

  /// Returns the next word of the line; empty at its end.
  std::string_view word();
  /// Returns what is left of the line, without spaces at its ends.
  std::string_view restOfLine();
  /// Returns what is left of the text.
  std::string_view everything() const { return rest_; }
  /// Goes to the next line; returns false if there is none.
  bool nextLine();
  /// Returns the next word, on whichever line; empty at the end of the text.
  std::string_view wordOnAnyLine();

  /// Return the next word of the line as a number. Throw InputError if it is none.
  double number(const char* what);
  std::int64_t integer(const char* what);

  /// The current line, from 1 on.
  std::size_t line() const { return line_; }
  /// Throws InputError with the line before the message.
  [[noreturn]] void fail(const std::string& message) const;

 private:
  void skipBlanks();
  void takeLineEnd();

  std::string_view rest_;
  bool isWavefront_;
  std::size_t line_ = 1;
};

/// Bytes that some programs write behind the end of a file.
inline constexpr std::string_view kPadding("\0 \t\r\n\x1a", 6);

/// Returns a text without the zeros and ends of file that are kPadding at its end.
std::string_view withoutPadding(std::string_view text);

/// Throws InputError if a text begins as UTF-16 does, but for its mark; with it, textOfFile() reads
/// it.
void refuseUtf16(std::string_view text);

/// Returns what is wrong with a word that should be a number, behind what it is: " must be a
/// number, not "3,5"; write decimal points".
std::string noNumber(std::string_view word);

std::optional<double> numberIn(std::string_view word);
std::optional<std::int64_t> integerIn(std::string_view word);

/// Bytes that are read as numbers, one after the other.
class MeshBytes {
 public:
  /// Takes the last bytes of a file, after the `before` first ones.
  explicit MeshBytes(std::string_view bytes, std::size_t before = 0, bool isBigEndian = false)
      : bytes_(bytes), before_(before), isBigEndian_(isBigEndian) {}

  /// Returns the next number. Throws InputError at the end.
  template <typename Number>
  Number next() {
    char bytes[sizeof(Number)];
    std::memcpy(bytes, take(sizeof(Number)).data(), sizeof(Number));
    if (isBigEndian_) {
      for (std::size_t i = 0; i < sizeof(Number) / 2; ++i)
        std::swap(bytes[i], bytes[sizeof(Number) - 1 - i]);
    }
    return std::bit_cast<Number>(bytes);
  }
  /// Returns the next bytes. Throws InputError if there are fewer.
  std::string_view take(std::size_t count);
  std::size_t left() const { return bytes_.size() - at_; }
  /// Returns the place of the next byte in the file.
  std::size_t at() const { return before_ + at_; }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0, before_;
  bool isBigEndian_;
};

}  // namespace rotatebook::meshes

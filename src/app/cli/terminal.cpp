#include "cli/terminal.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <sys/ioctl.h>
#include <unistd.h>
#include <utility>

#include "base/error.h"
#include "base/text.h"
#include "cli/text_width.h"

namespace rotatebook::cli {
namespace {

constexpr std::size_t kUsualColumns = 80;
constexpr std::size_t kFewestColumns = 20;
constexpr std::size_t kLeastRoom = 16;      // Of an indented line. [letters]
constexpr std::size_t kParagraphLine = 60;  // [letters]
constexpr std::string_view kErase = "\r\x1b[K";

struct Colour {
  std::string_view word, code;
};

constexpr std::array kColours{
    Colour{"not met ", "\x1b[1;31m"},     // bold red
    Colour{"met ", "\x1b[32m"},           // green
    Colour{"note:", "\x1b[33m"},          // yellow
    Colour{"rotatebook:", "\x1b[1;31m"},  // bold red
};
constexpr std::string_view kPlain = "\x1b[m";

std::size_t indentOf(std::string_view line) {
  return std::min(line.find_first_not_of(' '), line.size());
}

/// Returns where further lines of `line` begin.
std::size_t hangOf(std::string_view line, std::size_t columns) {
  const std::size_t indent = indentOf(line);
  const std::size_t gap = line.find("  ", indent);
  const std::size_t second = gap == line.npos ? gap : line.find_first_not_of(' ', gap);
  const bool isRow = second != line.npos;
  for (const std::size_t column :
       {isRow ? columnsOf(line.substr(0, second)) : columns,
        isRow || (indent > 0 && indent < kFewestColumns) ? indent + 2 : indent})
    if (column + kLeastRoom <= columns) return column;
  return 0;
}

/// Returns the bytes of `text` that fit in `columns`, up to the end of a word, which is the first
/// if that doesn't fit.
std::size_t fittingBytes(std::string_view text, std::size_t columns) {
  if (columnsOf(text) <= columns) return text.size();
  const std::size_t limit = firstColumns(text, columns + 1).size();
  const std::size_t words = std::min(text.find_first_not_of(' '), text.size());
  const std::size_t space = text.rfind(' ', limit - 1);
  if (space != text.npos && space > words) return space;
  return std::min(text.find(' ', words), text.size());
}

bool wantsColour() {
  const char* refused = std::getenv("NO_COLOR");
  const char* kind = std::getenv("TERM");
  return (refused == nullptr || *refused == '\0') &&
         (kind == nullptr || std::string_view(kind) != "dumb");
}

}  // namespace

std::size_t terminalColumns(int descriptor) {
  if (isatty(descriptor) != 1) return 0;
  winsize size{};
  const bool known = ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 1;
  return known ? size.ws_col : kUsualColumns;
}

void refuseTerminal(std::string_view option) {
  if (terminalColumns(STDOUT_FILENO) == 0) return;
  throw InputError(std::string(option) +
                   ": the standard output is a terminal, which shows no pictures; add | and the "
                   "program that takes them, or > and a file");
}

std::string wrapped(std::string_view line, std::size_t columns) {
  if (columns < kFewestColumns || columnsOf(line) <= columns) return std::string(line);
  const std::string hang(hangOf(line, columns), ' ');
  std::string lines;
  for (std::string_view rest = line; !rest.empty();) {
    const std::size_t room = columns - (lines.empty() ? 0 : hang.size());
    const std::size_t bytes = fittingBytes(rest, room);
    const std::string_view piece = rest.substr(0, bytes);
    lines += lines.empty() ? "" : "\n" + hang;
    lines += piece.substr(0, piece.find_last_not_of(' ') + 1);
    rest.remove_prefix(bytes);
    rest.remove_prefix(indentOf(rest));
  }
  return lines;
}

std::string coloured(const std::string& line) {
  const std::size_t indent = indentOf(line);
  for (const auto& [word, code] : kColours) {
    if (!std::string_view(line).substr(indent).starts_with(word)) continue;
    const std::string shown(trimmed(word));
    return line.substr(0, indent) + std::string(code) + shown + std::string(kPlain) +
           line.substr(indent + shown.size());
  }
  return line;
}

std::string withWholeParagraphs(std::string_view text) {
  std::string joined;
  bool goesOn = false;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    const bool isProse = !line.empty() && line.front() != ' ';
    if (goesOn) joined += isProse ? ' ' : '\n';
    joined += line;
    goesOn = isProse && characterCount(line) >= kParagraphLine && end != text.npos;
    if (!goesOn && end != text.npos) joined += '\n';
    text.remove_prefix(end == text.npos ? text.size() : end + 1);
  }
  return goesOn ? joined + '\n' : joined;
}

TerminalText::TerminalText(std::ostream& stream, int descriptor)
    : stream_(stream),
      descriptor_(descriptor),
      columns_(terminalColumns(descriptor)),
      isColoured_(columns_ > 0 && wantsColour()) {
  if (columns_ > 0) target_ = stream.rdbuf(this);
}

void TerminalText::leave() {
  if (target_ == nullptr) return;
  printPending();
  stream_.rdbuf(std::exchange(target_, nullptr));
}

bool TerminalText::print(std::string_view text) {
  const auto size = static_cast<std::streamsize>(text.size());
  return target_->sputn(text.data(), size) == size;
}

bool TerminalText::printLine(std::string line) {
  std::string_view start;
  if (line.starts_with(kErase)) start = kErase;
  std::string text = line.substr(start.size());
  if (!text.starts_with('\r')) {
    text = wrapped(text, terminalColumns(descriptor_));
    if (isColoured_) text = coloured(text);
  }
  return print(std::string(start) + text + '\n');
}

bool TerminalText::printPending() {
  return print(std::exchange(pending_, ""));
}

std::streamsize TerminalText::xsputn(const char* text, std::streamsize size) {
  const std::scoped_lock lock(mutex_);
  std::string_view rest(text, static_cast<std::size_t>(size));
  for (std::size_t end = 0; (end = rest.find('\n')) != rest.npos; rest.remove_prefix(end + 1)) {
    pending_ += rest.substr(0, end);
    if (!printLine(std::exchange(pending_, ""))) return 0;
  }
  pending_ += rest;
  return size;
}

int TerminalText::overflow(int letter) {
  if (letter == traits_type::eof()) return 0;
  const char one = static_cast<char>(letter);
  return xsputn(&one, 1) == 1 ? letter : traits_type::eof();
}

int TerminalText::sync() {
  const std::scoped_lock lock(mutex_);
  if (pending_.starts_with('\r') && !printPending()) return -1;
  return target_->pubsync();
}

}  // namespace rotatebook::cli

// Text as a terminal shows it: wrapped at its width between words, what matters in colour. Inside
// the room only.
#pragma once

#include <cstddef>
#include <mutex>
#include <ostream>
#include <streambuf>
#include <string>
#include <string_view>

namespace rotatebook::cli {

/// Returns the columns of the terminal that `descriptor` is: 80 if it doesn't say; 0 if it is none.
std::size_t terminalColumns(int descriptor);

/// Throws InputError if the standard output, which `option` chose for pictures, is a terminal.
void refuseTerminal(std::string_view option);

/// Returns a line of text as lines of at most `columns`, broken between words. Those after
/// the first are indented: below the second column of a table's row, else two letters more than the
/// line, or not at all if it isn't indented. A longer word stays whole. Below 20 columns, the line.
std::string wrapped(std::string_view line, std::size_t columns);

/// Returns a line with the colours (ECMA-48) of what it begins with: "met", "not met", "note:",
/// "rotatebook:".
std::string coloured(const std::string& line);

/// Returns `text` with each paragraph on one line: a line goes on with the next if it has at least
/// 60 letters, and neither is indented.
std::string withWholeParagraphs(std::string_view text);

/// Wraps and colours what is printed to a stream, for as long as it lives, if the stream is a
/// terminal. Lines appear when they are complete; those that begin with \r, as a bar does, at once
/// and as they are. Heeds the variables NO_COLOR (no-color.org) and TERM=dumb.
class TerminalText : public std::streambuf {
 public:
  /// `stream` prints to `descriptor`.
  TerminalText(std::ostream& stream, int descriptor);
  TerminalText(const TerminalText&) = delete;
  TerminalText& operator=(const TerminalText&) = delete;
  ~TerminalText() override { leave(); }

  bool isTerminal() const { return columns_ > 0; }
  /// Leaves the rest of what is printed as it is.
  void leave();

 protected:
  int overflow(int letter) override;
  std::streamsize xsputn(const char* text, std::streamsize size) override;
  int sync() override;

 private:
  bool print(std::string_view text);
  bool printLine(std::string line);
  bool printPending();

  std::ostream& stream_;
  int descriptor_;
  std::size_t columns_;
  bool isColoured_;
  std::streambuf* target_ = nullptr;  ///< Null if text is left as it is.
  std::string pending_;               ///< A line that isn't complete.
  std::mutex mutex_;
};

}  // namespace rotatebook::cli

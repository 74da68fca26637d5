// The name of a column, taken apart. Inside the room only.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rotatebook::recording {

/// The parts of a column's header.
struct ColumnName {
  /// The words in one, without a unit of rates or accelerations at their end: "gyroscopex" for
  /// "Gyroscope x (rad/s)", "gyrox" for "gyro_x_dps".
  std::string plain;
  std::string unit;                ///< In brackets, without blanks: "rad/s"; empty without.
  std::vector<std::string> words;  ///< Before brackets: "time", "ms" for "timeMs". Small letters.
};

ColumnName columnNameOf(std::string_view header);

/// Returns the words of `text`, which are separated by single blanks.
std::vector<std::string_view> wordsOf(std::string_view text);

/// Returns `text` with small letters of ASCII.
std::string smallText(std::string_view text);

/// Returns whether `word` is one of those in `list`, which are separated by blanks.
bool isAmong(std::string_view list, std::string_view word);

}  // namespace rotatebook::recording

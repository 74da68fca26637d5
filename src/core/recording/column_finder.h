// Finds columns by their usual names. Inside the room only.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "recording/column_spellings.h"
#include "recording/csv_table.h"
#include "recording/read_options.h"

namespace rotatebook::recording {

/// Finds columns in a table's header. Its functions throw InputError if two columns hold the same,
/// and for a column that is named by the options and isn't there.
class ColumnFinder {
 public:
  ColumnFinder(const CsvTable& table, const ColumnNames& named);

  /// Returns the column of times, of those with numbers; of several, one of kPreferredTimes.
  std::optional<std::size_t> time() const;
  /// Returns the column of kNanosecondNames.
  std::optional<std::size_t> nanoseconds() const;

  /// Returns the columns of a group, all in one spelling but for those that the options name; none
  /// if the table has none of them, or if the options name one by an empty text. Throws InputError,
  /// too, if it has some but not all.
  template <std::size_t N>
  std::optional<std::array<std::size_t, N>> group(const Spellings& group) const {
    const std::optional<std::vector<std::size_t>> found = columnsOf(group);
    if (!found) return std::nullopt;
    std::array<std::size_t, N> columns{};
    for (std::size_t i = 0; i < N; ++i) columns[i] = (*found)[i];
    return columns;
  }

  /// Returns the columns called x, y and z alone; none if there aren't all three, or if they are a
  /// quaternion's.
  std::optional<std::array<std::size_t, 3>> bareAxes() const;
  /// Returns whether the options name a column of the group.
  bool isNamed(const Spellings& group) const;
  /// Returns the names of all columns, for messages.
  std::string names() const;
  [[noreturn]] void failTwice(std::size_t first, std::size_t second) const;

 private:
  using Columns = std::vector<std::optional<std::size_t>>;

  /// A group in a spelling in which all of it is there.
  struct Whole {
    std::string_view beginning;
    Columns columns;
    bool isConfirmed = false;  // by a column that the options name
  };

  std::optional<std::vector<std::size_t>> columnsOf(const Spellings& group) const;
  bool isLeftOut(const Spellings& group) const;
  std::vector<Whole> wholesOf(const Spellings& group, const Columns& stated) const;
  std::optional<std::vector<std::size_t>> wholeOrNone(const Spellings& group,
                                                      const Columns& columns) const;
  Columns named(const Spellings& group) const;
  std::optional<std::size_t> named(std::string_view role) const;
  Columns spelling(std::string_view beginning, std::string_view ends, const Columns& stated) const;
  Columns partOf(const Spellings& group, Columns part) const;
  void requireSingle(const Spellings& group, const Whole& taken) const;
  bool hasPlain(std::string_view name) const;
  template <typename IsWanted>
  std::optional<std::size_t> onlyOne(const IsWanted& isWanted) const;

  const CsvTable& table_;
  const ColumnNames& named_;
  std::vector<std::string> plain_;
};

}  // namespace rotatebook::recording

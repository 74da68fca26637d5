// The room that text takes on a terminal. Inside the room only.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace rotatebook::cli {

/// Returns the columns of a terminal that `text`, in UTF-8, takes: two of a wide letter, such as
/// Chinese has, none of a mark over another.
std::size_t columnsOf(std::string_view text);

/// Returns the longest beginning of `text` that takes at most `columns`, letters with their marks.
std::string_view firstColumns(std::string_view text, std::size_t columns);

/// Returns `text` if it takes at most `columns`; else its beginning and an ellipsis, in as many.
std::string cutTo(std::string_view text, std::size_t columns);

}  // namespace rotatebook::cli

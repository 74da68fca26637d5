// The text of files that other programs wrote.
#pragma once

#include <string>
#include <string_view>

namespace rotatebook {

/// Returns a file's text in UTF-8 without the byte order mark that it may begin with: `bytes`, or
/// in place of UTF-16 with its mark, in either order of bytes, what is put into `decoded`. Halves
/// of surrogate pairs become U+FFFD.
std::string_view textOfFile(std::string_view bytes, std::string& decoded);

}  // namespace rotatebook

// The mark of what --pack made: a text with the checksums of its files. Inside the room only.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace rotatebook::page {

/// The name of the mark. It is written first, so that an interrupted pack is known for one, too.
inline constexpr const char* kPackMark = "rotatebook.pack";

/// The states in which a pack left its files, or was going to, by name: of each its checksum, and
/// what it was made from, which is empty if that isn't known.
using PackFiles = std::map<std::string, std::map<std::string, std::string>>;

/// Returns the text of a mark.
std::string packMarkText(const PackFiles& files);
/// Returns the files of a mark; nothing for other text.
std::optional<PackFiles> parsePackMark(std::string_view text);

}  // namespace rotatebook::page

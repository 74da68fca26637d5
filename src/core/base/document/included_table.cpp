#include "base/document/included_table.h"

#include <variant>

#include "base/error.h"
#include "base/text.h"

namespace rotatebook::document {
namespace {

TomlNode* valueOf(TomlNode* node, std::string_view key) {
  auto* table = node != nullptr ? std::get_if<TomlNode::Table>(&node->value) : nullptr;
  TomlEntry* entry = table != nullptr ? find(*table, key) : nullptr;
  return entry != nullptr ? &entry->node : nullptr;
}

std::string textOf(const std::filesystem::path& file, const std::string& location,
                   const ReadNamedFile& readNamedFile) {
  try {
    return readNamedFile(file, kLongestWords);
  } catch (const InputError& error) {
    failAt(location, error.what());
  }
}

}  // namespace

std::filesystem::path includeTable(TomlNode& root, std::string_view section, std::string_view key,
                                   const std::filesystem::path& folder,
                                   const ReadNamedFile& readNamedFile) {
  TomlNode* node = valueOf(valueOf(&root, section), key);
  const auto* text = node != nullptr ? std::get_if<std::string>(&node->value) : nullptr;
  if (text == nullptr || text->find('.') == text->npos) return {};
  const std::filesystem::path name = *text;
  const std::string shown =
      std::string(section) + "." + std::string(key) + " names the file " + describe(*node);
  node->value = TomlNode::Table{};
  if (!readNamedFile)
    failAt(node->location, shown + ", but no file is read here; write its table instead");
  if (name.is_absolute())
    failAt(node->location, shown + ", which must be relative to the scene's folder");
  const std::filesystem::path file = folder / name;
  *node =
      parseToml(textOf(name, node->location, readNamedFile), oneLine(file.string()), kLongestWords);
  return file;
}

}  // namespace rotatebook::document

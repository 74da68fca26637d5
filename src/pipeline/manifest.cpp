#include "pipeline/manifest.h"

#include <variant>

#include "base/atomic_file.h"
#include "base/error.h"
#include "base/read_file.h"
#include "scene/toml_text.h"
#include "scene/toml_tree.h"

namespace rotatebook::pipeline {
namespace {

namespace fs = std::filesystem;
using Entries = Manifest::Entries;

constexpr const char* kHead =
    "# What the frames beside this were made from and with. Their checksums are in frames.xxh128,\n"
    "# which 'xxh128sum --check' reads; here are those of the files that were made with them.\n";

std::string tableText(const char* name, const Entries& entries) {
  std::string text = "\n[" + std::string(name) + "]\n";
  for (const auto& [key, value] : entries) {
    text += scene::tomlString(key) + " = " + scene::tomlString(value) + '\n';
  }
  return text;
}

/// The strings of a table in the file's root.
Entries entriesOf(const scene::TomlNode& root, const char* name) {
  Entries entries;
  const auto* tables = std::get_if<scene::TomlNode::Table>(&root.value);
  const scene::TomlEntry* table = tables != nullptr ? find(*tables, name) : nullptr;
  if (table == nullptr) return entries;
  const auto* rows = std::get_if<scene::TomlNode::Table>(&table->node.value);
  if (rows == nullptr) return entries;
  for (const scene::TomlEntry& row : *rows) {
    const auto* text = std::get_if<std::string>(&row.node.value);
    if (text != nullptr) entries[row.key] = *text;
  }
  return entries;
}

}  // namespace

Manifest parseManifest(std::string_view text, const std::string& file) {
  const scene::TomlNode root = scene::parseToml(text, file);
  return {entriesOf(root, "made"), entriesOf(root, "files")};
}

std::optional<Manifest> readManifest(const fs::path& folder) {
  const fs::path path = folder / kManifestName;
  try {
    return parseManifest(readFile(path, scene::kLongestToml), path);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

std::string manifestText(const Manifest& manifest) {
  std::string text = kHead + tableText("made", manifest.made);
  if (manifest.isComplete()) text += tableText("files", manifest.files);
  return text;
}

void writeManifest(const fs::path& folder, const Manifest& manifest) {
  writeFileAtomically(folder / kManifestName, manifestText(manifest));
}

}  // namespace rotatebook::pipeline

#include "store/manifest.h"

#include <algorithm>
#include <cstdio>
#include <system_error>
#include <variant>

#include <fmt/core.h>

#include "base/document/toml_text.h"
#include "base/document/toml_tree.h"
#include "base/error.h"
#include "store/clip_files.h"
#include "system/atomic_file.h"
#include "system/read_file.h"
#include "system/temporary_files.h"

namespace rotatebook::store {
namespace {

namespace fs = std::filesystem;
using Entries = Manifest::Entries;

constexpr const char* kHead =
    "# Provenance of the frames in this folder. Their checksums are in frames.xxh128, which\n"
    "# 'xxh128sum --check' reads; those below are of the files made with the frames, and of files "
    "of\n"
    "# the same clip made with other settings.\n";

/// The key that is true if the frames beside finished files aren't a whole clip.
constexpr const char* kUnfinished = "unfinished";

/// The key of the array of renders with other settings.
constexpr const char* kOther = "other";

std::string tableText(const std::string& name, const Entries& entries) {
  std::string text = fmt::format("\n[{}]\n", name);
  for (const auto& [key, value] : entries)
    text += fmt::format("{} = {}\n", document::tomlString(key), document::tomlString(value));
  return text;
}

/// Returns the value `name` of the table `parent` if it has this type; else null.
template <typename Type>
const Type* find(const document::TomlNode& parent, const char* name) {
  const auto* table = std::get_if<document::TomlNode::Table>(&parent.value);
  const document::TomlEntry* entry = table != nullptr ? document::find(*table, name) : nullptr;
  return entry != nullptr ? std::get_if<Type>(&entry->node.value) : nullptr;
}

/// Returns the strings in the table `name` of `parent`.
Entries entriesOf(const document::TomlNode& parent, const char* name) {
  Entries entries;
  const auto* rows = find<document::TomlNode::Table>(parent, name);
  if (rows == nullptr) return entries;
  for (const document::TomlEntry& row : *rows) {
    const auto* text = std::get_if<std::string>(&row.node.value);
    if (text != nullptr) entries[row.key] = *text;
  }
  return entries;
}

Manifest::Render renderFrom(const document::TomlNode& table) {
  return {entriesOf(table, "made"), entriesOf(table, "files")};
}

/// Reads the manifest that is the file at `path`; returns nothing where readManifest() does.
std::optional<Manifest> readFrom(const fs::path& path) {
  try {
    return parseManifest(system::readFile(path, document::kLongestToml), path);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// Gives the file `aside` its name again, unless another has it now.
void putBack(const fs::path& aside, const fs::path& path) {
  std::error_code error;
  fs::create_hard_link(aside, path, error);
  // Some file systems have no hard links
  if (error && error != std::errc::file_exists) fs::rename(aside, path, error);
}

}  // namespace

const Entries* Manifest::filesOf(const Entries& made) const {
  if (own.made == made) return &own.files;
  const auto found = std::ranges::find(others, made, &Render::made);
  return found != others.end() ? &found->files : nullptr;
}

void Manifest::add(const Entries& made, const Entries& files) {
  // Take the files from the renders that wrote them before
  const auto isReplaced = [&](const auto& file) { return files.contains(file.first); };
  std::erase_if(own.files, isReplaced);
  for (Render& other : others) std::erase_if(other.files, isReplaced);

  // Add them to the render that wrote them last
  if (filesOf(made) == nullptr) others.push_back({made, {}});
  Render& render = own.made == made ? own : *std::ranges::find(others, made, &Render::made);
  render.files.insert(files.begin(), files.end());

  // Remove renders of which nothing remains
  std::erase_if(others, [](const Render& other) { return other.files.empty(); });
}

void Manifest::become(const Entries& made) {
  if (own.made == made) return;
  Render now{made, {}};
  const auto found = std::ranges::find(others, made, &Render::made);
  if (found != others.end()) {
    now = *found;
    others.erase(found);
  }
  if (!own.files.empty()) others.push_back(own);
  own = now;
}

// A finished render has a table of files, which is empty if other renders have replaced all of
// them. One without PNGs has it, too, beside unfinished frames.
Manifest parseManifest(std::string_view text, const std::string& file) {
  const document::TomlNode root = document::parseToml(text, file);
  Manifest manifest{.own = renderFrom(root)};
  const bool* unfinished = find<bool>(root, kUnfinished);
  manifest.finished = find<document::TomlNode::Table>(root, "files") != nullptr &&
                      (unfinished == nullptr || !*unfinished);
  if (const auto* others = find<document::TomlNode::Array>(root, kOther)) {
    for (const document::TomlNode& other : *others) manifest.others.push_back(renderFrom(other));
  }
  return manifest;
}

std::optional<Manifest> readManifest(const fs::path& folder) {
  return readFrom(folder / kManifestName);
}

std::string manifestText(const Manifest& manifest) {
  const bool hasFiles = manifest.finished || !manifest.own.files.empty();
  std::string text = kHead;
  if (hasFiles && !manifest.finished) text += fmt::format("{} = true\n", kUnfinished);
  text += tableText("made", manifest.own.made);
  if (hasFiles) text += tableText("files", manifest.own.files);
  for (const Manifest::Render& other : manifest.others) {
    const std::string table = kOther;
    text += fmt::format("\n[[{}]]\n", table) + tableText(table + ".made", other.made) +
            tableText(table + ".files", other.files);
  }
  return text;
}

void writeManifest(const fs::path& folder, const Manifest& manifest) {
  system::writeFileAtomically(folder / kManifestName, manifestText(manifest));
}

bool replaceManifest(const fs::path& folder, const std::optional<Manifest>& there,
                     const Manifest& next) {
  const fs::path path = folder / kManifestName;
  if (there) {
    // Take away the one that was read, which only one process can
    const fs::path aside = system::temporaryNameFor(path.string() + ".before");
    if (std::rename(path.c_str(), aside.c_str()) != 0) return false;
    const bool isSame = readFrom(aside) == there;
    if (!isSame) putBack(aside, path);
    system::removeFile(aside);
    if (!isSame) return false;
  }
  return system::createFileAtomically(path, manifestText(next));
}

}  // namespace rotatebook::store

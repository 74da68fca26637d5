#include "cli/recordings.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <functional>
#include <utility>
#include <vector>
#include <zip.h>

#include <fmt/core.h>

#include "base/error.h"
#include "base/text.h"
#include "cli/commands.h"
#include "cli/option_checks.h"
#include "recording/columns.h"
#include "recording/csv_table.h"
#include "system/read_file.h"
#include "system/zip_archive.h"

namespace rotatebook::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxEntries = 1000;  // of an archive or folder
constexpr std::size_t kMaxTables = 64;
constexpr std::uint64_t kMaxBytes = 64 << 20;  // of all tables

/// A table that may be read.
struct Entry {
  std::string name;  // within the archive or folder
  std::uint64_t size = 0;
  std::function<std::string()> read;
};

std::string bytesAt(const std::string& path) {
  try {
    return system::readFileOrInput(path, recording::kLargestRecording);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: can't be read: {}", system::nameOfInput(path), error.what()));
  }
}

/// Returns whether a file of that name may be a table of readings.
bool isTable(const fs::path& name) {
  for (const fs::path& part : name) {
    if (part.string().starts_with('.') || part == "meta" || part == "__MACOSX") return false;
  }
  const std::string ending = lowerCase(name.extension().string());
  return ending == ".csv" || ending == ".tsv" || ending == ".txt";
}

void requireFewEntries(const std::string& path, std::size_t count) {
  if (count <= kMaxEntries) return;
  throw InputError(fmt::format("{}: more than {} entries; name the recording's tables themselves",
                               path, kMaxEntries));
}

/// Reads the tables, unless there are too many or they are too large; `inside` is what their names
/// begin with in messages.
std::vector<TableFile> readAll(const std::string& path, const std::string& inside,
                               const std::vector<Entry>& entries) {
  std::uint64_t total = 0;
  for (const Entry& entry : entries) {
    if (entry.size > recording::kLargestRecording) {
      throw InputError(
          fmt::format("{}{}: longer than {} MiB, the limit for a recording; export a part of it",
                      inside, entry.name, recording::kLargestRecording >> 20));
    }
    total += entry.size;
  }
  if (entries.size() > kMaxTables || total > kMaxBytes) {
    throw InputError(
        fmt::format("{}: more than {} tables or {} MiB of them; name the gyroscope's table", path,
                    kMaxTables, kMaxBytes >> 20));
  }
  std::vector<TableFile> tables;
  for (const Entry& entry : entries)
    tables.push_back({inside + entry.name, entry.read(), entry.name});
  return tables;
}

[[noreturn]] void failArchive(const std::string& path, const std::string& cause) {
  throw InputError(fmt::format("{}: can't be read as a ZIP archive: {}", path, cause));
}

std::string readArchived(zip_t* archive, zip_uint64_t index, std::uint64_t size,
                         const std::string& path) {
  const system::ZippedFile file(zip_fopen_index(archive, index, 0));
  if (file == nullptr) failArchive(path, zip_strerror(archive));
  // One byte more than there ought to be, so that the end is reached and the checksum compared.
  std::string bytes(size + 1, '\0');
  std::uint64_t count = 0;
  while (count < bytes.size()) {
    const zip_int64_t got = zip_fread(file.get(), bytes.data() + count, bytes.size() - count);
    if (got < 0) failArchive(path, zip_file_strerror(file.get()));
    if (got == 0) break;
    count += static_cast<std::uint64_t>(got);
  }
  if (count != size) failArchive(path, "an entry isn't as long as it says");
  bytes.resize(size);
  return bytes;
}

system::ZipArchive openArchive(const std::string& bytes, const std::string& path) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* const source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  zip_t* const archive =
      source == nullptr ? nullptr : zip_open_from_source(source, ZIP_RDONLY, &error);
  if (archive == nullptr) {
    zip_source_free(source);
    const std::string cause = zip_error_strerror(&error);
    zip_error_fini(&error);
    failArchive(path, cause);
  }
  zip_error_fini(&error);
  return system::ZipArchive(archive);
}

std::vector<TableFile> tablesInArchive(const std::string& bytes, const std::string& path) {
  const system::ZipArchive archive = openArchive(bytes, path);
  const zip_int64_t count = zip_get_num_entries(archive.get(), 0);
  requireFewEntries(path, static_cast<std::size_t>(std::max<zip_int64_t>(count, 0)));
  std::vector<Entry> entries;
  for (zip_int64_t i = 0; i < count; ++i) {
    const auto index = static_cast<zip_uint64_t>(i);
    zip_stat_t about;
    zip_stat_init(&about);
    if (zip_stat_index(archive.get(), index, 0, &about) != 0)
      failArchive(path, zip_strerror(archive.get()));
    constexpr zip_uint64_t kNeeded = ZIP_STAT_NAME | ZIP_STAT_SIZE;
    if ((about.valid & kNeeded) != kNeeded) continue;
    if (std::string_view(about.name) == "[Content_Types].xml") {
      throw InputError(path + ": a workbook (.xlsx), which isn't read; save it as CSV");
    }
    if (!isTable(about.name)) continue;
    entries.push_back({about.name, about.size, [&archive, index, size = about.size, &path] {
                         return readArchived(archive.get(), index, size, path);
                       }});
  }
  return readAll(path, path + ": ", entries);
}

std::vector<TableFile> tablesInFolder(const fs::path& folder) {
  std::vector<Entry> entries;
  std::error_code error;
  std::size_t count = 0;
  for (fs::directory_iterator one(folder, error), end; !error && one != end; one.increment(error)) {
    requireFewEntries(folder.string(), ++count);
    std::error_code none;  // of a file that is gone again
    const std::uint64_t size = one->file_size(none);
    if (none || !one->is_regular_file(none) || !isTable(one->path().filename())) continue;
    entries.push_back({one->path().filename().string(), size,
                       [path = one->path().string()] { return bytesAt(path); }});
  }
  if (error) throw InputError(folder.string() + ": can't be read: " + error.message());
  std::ranges::sort(entries, {}, &Entry::name);
  return readAll(folder.string(), folder.string() + "/", entries);
}

std::string namesOf(const std::vector<TableFile>& tables) {
  constexpr std::size_t kLongest = 80;  // [characters]
  std::vector<std::string> names;
  for (const TableFile& table : tables) names.push_back(quotedBeginning(table.entry, kLongest));
  return listed(names);
}

/// Takes the only one of `tables` that `isWanted`; nothing if none is. Of several, one whose name
/// contains `preferred` is taken. Throws InputError, with the `remedy`, if it isn't the only one.
template <typename IsWanted>
std::optional<TableFile> takeOnly(const std::string& path, std::vector<TableFile>& tables,
                                  const std::string& what, const std::string& preferred,
                                  const IsWanted& isWanted) {
  std::vector<TableFile> wanted;
  for (const TableFile& table : tables) {
    if (isWanted(table)) wanted.push_back(table);
  }
  const auto isPreferred = [&](const TableFile& table) {
    return lowerCase(fs::path(table.entry).filename().string()).find(preferred) !=
           std::string::npos;
  };
  if (wanted.size() > 1 && std::ranges::count_if(wanted, isPreferred) == 1)
    return *std::ranges::find_if(wanted, isPreferred);
  if (wanted.size() > 1) {
    throw InputError(
        fmt::format("{}: {} all have {}; name the tables themselves, and the "
                    "accelerometer's with --acceleration",
                    path, namesOf(wanted), what));
  }
  return wanted.empty() ? std::nullopt : std::optional(wanted.front());
}

/// Chooses a recording's tables by their columns.
RecordingFiles chosenOf(const std::string& path, std::vector<TableFile> tables,
                        const recording::ReadOptions& options) {
  const auto contents = [&](const TableFile& table) {
    return recording::contentsOf(table.table(), options);
  };
  if (tables.empty()) {
    throw InputError(
        path +
        ": no table is in it (.csv, .tsv or .txt); export the recording as CSV, of phyphox's "
        "formats \"CSV (Comma, decimal point)\"");
  }
  RecordingFiles files;
  auto motion = takeOnly(path, tables, "rates", "gyroscope.", [&](const TableFile& table) {
    return contents(table).hasRates && !contents(table).hasAttitudes;
  });
  if (!motion) {
    motion = takeOnly(path, tables, "attitudes", "orientation.",
                      [&](const TableFile& table) { return contents(table).hasAttitudes; });
  }
  if (!motion) {
    throw InputError(
        fmt::format("{}: no table of a gyroscope's rates, or of attitudes, among {}; name "
                    "a table itself, and its columns with --column",
                    path, namesOf(tables)));
  }
  files.motion = std::move(*motion);
  if (contents(files.motion).hasForce) return files;
  files.acceleration = takeOnly(path, tables, "accelerations", "total", [&](const TableFile& one) {
    return contents(one).hasForce && !contents(one).hasRates && !contents(one).hasAttitudes;
  });
  return files;
}

}  // namespace

const recording::NamedTable* RecordingFiles::accelerationTable() {
  if (!acceleration) return nullptr;
  accelerationTable_ = acceleration->table();
  return &accelerationTable_;
}

RecordingFiles openRecording(const std::string& path, const std::string& acceleration,
                             const recording::ReadOptions& options) {
  RecordingFiles files;
  std::error_code error;
  const std::string name = system::nameOfInput(path);
  if (path != system::kStandardInput && fs::is_directory(path, error)) {
    files = chosenOf(path, tablesInFolder(path), options);
    files.path = files.motion.name;
  } else {
    std::string bytes = bytesAt(path);
    if (bytes.starts_with("PK\x03\x04") || bytes.starts_with("PK\x05\x06")) {
      files = chosenOf(name, tablesInArchive(bytes, name), options);
    } else {
      files.motion = {name, std::move(bytes)};
      files.path = path;
    }
  }
  if (!acceleration.empty()) {
    files.acceleration = TableFile{system::nameOfInput(acceleration), bytesAt(acceleration)};
  }
  return files;
}

void RecordingOptions::addTo(CLI::App& command) {
  constexpr const char* kGroup = "Recording";
  addOption(command, "--from", "SECONDS", options.from,
            "Where the motion starts, of the file's times", kGroup);
  addOption(command, "--to", "SECONDS", options.to, "Where it ends, likewise", kGroup);
  addOption(command, "--rates", "rad/s|deg/s", options.unit,
            "Unit of a gyroscope's rates, if the header has none", kGroup)
      ->check(oneOf({"rad/s", "deg/s"}));
  addOption(command, "--time-unit", "s|ms|us|ns|min", options.timeUnit,
            "Unit of the file's times, if the header has none", kGroup)
      ->check(oneOf({"s", "ms", "us", "ns", "min"}));
  repeated(addOption(command, "--column", "HOLDS=NAME", columns,
                     "A column without a usual name, e.g. --column \"wx=Gyro X\"; may be repeated",
                     kGroup));
}

recording::ReadOptions RecordingOptions::read() const {
  recording::ReadOptions result = options;
  const auto roles = recording::columnRoles();
  for (const std::string& column : columns) {
    const std::size_t middle = std::min(column.find('='), column.size());
    const std::string role = column.substr(0, middle);
    if (middle == column.size() || std::ranges::find(roles, role) == roles.end()) {
      throw InputError(fmt::format("--column {} must be HOLDS=NAME, where HOLDS is one of {}",
                                   column, joined({roles.begin(), roles.end()})));
    }
    result.columns.emplace_back(role, column.substr(middle + 1));
  }
  return result;
}

Eigen::Vector3d threeNumbers(const std::string& text, const char* option) {
  Eigen::Vector3d numbers;
  const char* at = text.data();
  const char* const end = text.data() + text.size();
  for (int i = 0; i < 3; ++i) {
    const auto [rest, error] = std::from_chars(at, end, numbers[i]);
    const bool isLast = i == 2;
    const bool isSound = error == std::errc() && numbers[i] > 0 &&
                         (isLast ? rest == end : rest != end && *rest == ',');
    if (!isSound) {
      throw InputError(fmt::format("{} {} must be three numbers over 0, such as 0.004,0.002,0.005",
                                   option, text));
    }
    at = rest + 1;
  }
  return numbers;
}

}  // namespace rotatebook::cli

// Recordings: their options, and their tables in a file, a phone's export of several, or its
// archive. Inside the room only.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "recording/read_recording.h"

namespace rotatebook::cli {

/// A table's bytes.
struct TableFile {
  std::string name;  ///< For messages: "export.zip: folder/Gyroscope.csv".
  std::string bytes;
  std::string entry{};  ///< Its name within an archive or folder.

  recording::NamedTable table() const { return {bytes, name}; }
};

/// A recording's tables.
struct RecordingFiles {
  TableFile motion;                       ///< Of a gyroscope, or of attitudes.
  std::optional<TableFile> acceleration;  ///< Of an accelerometer, if it is a table of its own.
  std::string path;                       ///< The motion's own file; empty within an archive.

  const recording::NamedTable* accelerationTable();

 private:
  recording::NamedTable accelerationTable_;
};

/// Reads the recording at `path`, or system::kStandardInput: a table, or a folder or ZIP archive
/// with tables (.csv, .tsv, .txt), of which those are taken whose columns are a gyroscope's, or
/// else attitudes, and an accelerometer's; folders in it called "meta" are skipped. `acceleration`
/// is the path of the latter's table; empty if none is stated. Throws InputError "FILE: PROBLEM"
/// for what can't be read, for more than 1000 entries, 64 tables or 64 MiB of them, for a table of
/// more than recording::kLargestRecording, and if none or several tables are a gyroscope's.
RecordingFiles openRecording(const std::string& path, const std::string& acceleration,
                             const recording::ReadOptions& options);

/// The values of --rates, --time-unit, --column, --from and --to.
struct RecordingOptions {
  recording::ReadOptions options;
  std::vector<std::string> columns;  ///< "wx=NAME"

  void addTo(CLI::App& command);
  /// Returns the options. Throws InputError for a column that isn't HOLDS=NAME.
  recording::ReadOptions read() const;
};

/// Returns three numbers over 0, such as "0.004,0.002,0.005". Throws InputError that names
/// `option`.
Eigen::Vector3d threeNumbers(const std::string& text, const char* option);

}  // namespace rotatebook::cli

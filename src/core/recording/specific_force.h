// The specific force beside a gyroscope's readings. Inside the room only.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "recording/csv_table.h"
#include "recording/inertial_recording.h"
#include "recording/read_options.h"
#include "recording/table_columns.h"

namespace rotatebook::recording {

/// An accelerometer's reading.
struct Force {
  double time = 0;                 ///< [s]
  Eigen::Vector3d force{0, 0, 0};  ///< In body axes. [m/s^2]
};

/// Returns the readings in `rows` of a table, at times after `zero`. Throws InputError for a unit
/// that isn't read, and for none where they seem to be in g.
std::vector<Force> forcesOf(const CsvTable& table, const Columns& columns,
                            const std::vector<std::size_t>& rows, double zero);
/// Returns those of a table of accelerations. Throws InputError like forcesOf(), and if there are
/// none.
std::vector<Force> forcesIn(const NamedTable& named, const ReadOptions& options, double zero);

/// Sets the force of each reading: what lies on the line between two of `forces`, and infinite
/// beyond. Throws InputError, beginning with `name`, if no reading lies between.
void addForces(InertialRecording& recording, const std::vector<Force>& forces,
               const std::string& name);

/// Returns the options without the columns that `table` doesn't have.
ReadOptions withoutMissing(ReadOptions options, const CsvTable& table);
/// Returns the options without an accelerometer's columns.
ReadOptions withoutForce(ReadOptions options);

}  // namespace rotatebook::recording

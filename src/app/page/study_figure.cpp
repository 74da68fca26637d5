// The figure of a study: its plot, and from its tables its expectations and measurements.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/number_text.h"
#include "embedded/page.h"
#include "page/expectation_table.h"
#include "page/figure.h"
#include "scene/expectation_text.h"
#include "scene/names.h"
#include "store/study_files.h"
#include "study/study.h"
#include "study/sweep.h"
#include "system/read_file.h"

namespace rotatebook::page {
namespace {

namespace fs = std::filesystem;

/// A row of a table: its fields by the names of their columns.
using RunRow = std::map<std::string, std::string>;

std::vector<std::string> fieldsOf(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
  return fields;
}

/// Reads the rows of a CSV as `rotatebook study` writes it: no quotes, and no commas within fields.
std::vector<RunRow> rowsOf(const fs::path& csv) {
  std::istringstream stream(system::readFileOrEmpty(csv));
  std::string line;
  std::getline(stream, line);
  const std::vector<std::string> names = fieldsOf(line);
  std::vector<RunRow> rows;
  while (std::getline(stream, line)) {
    const std::vector<std::string> fields = fieldsOf(line);
    RunRow row;
    for (std::size_t i = 0; i < std::min(names.size(), fields.size()); ++i)
      row[names[i]] = fields[i];
    rows.push_back(row);
  }
  return rows;
}

double fieldOf(const RunRow& row, const std::string& column) {
  double number = study::kNoNumber;
  const auto found = row.find(column);
  if (found == row.end()) return number;
  const std::string& text = found->second;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

/// Joins the fields of these columns with commas; a missing field is empty.
std::string keyOf(const RunRow& row, const std::vector<std::string>& columns) {
  std::string key;
  for (const std::string& column : columns) {
    const auto found = row.find(column);
    key += (key.empty() ? "" : ",") + (found == row.end() ? "" : found->second);
  }
  return key;
}

/// The runs of a study, each identified by fields of its table.
struct Runs {
  std::vector<std::string> columns;
  std::set<std::string> keys;
};

Runs runsOf(const scene::Scene& scene) {
  const scene::StudySettings& study = *scene.study;
  if (study.isOfTilts()) {
    Runs runs{{"tilt_rad"}, {}};
    for (const double tilt : study.tilts) runs.keys.insert(shortestText(tilt));
    return runs;
  }
  if (study.sweep) {
    const scene::Sweep& sweep = *study.sweep;
    Runs runs{{sweep.over.key}, {}};
    if (sweep.curves) runs.columns.push_back(sweep.curves->key);
    for (const scene::SweepRun& run : sweep.runs) {
      runs.keys.insert(run.value + (sweep.curves ? "," + run.curve : ""));
    }
    return runs;
  }
  Runs runs{{"integrator", "h_s", "steps"}, {}};
  physics::MotionSettings motion = studiedMotion(scene, study);
  motion.simulation.step.reset();
  const std::int64_t samples = studiedSamples(scene, study, motion);
  for (const physics::Integrator integrator : study.integrators) {
    for (const int substeps : study.steps) {
      motion.simulation.substeps = substeps;
      runs.keys.insert(std::string(scene::nameOf(scene::kIntegrators, integrator)) + "," +
                       shortestText(motion.simulation.steps().length()) + "," +
                       std::to_string(scene::studiedSteps(motion, samples)));
    }
  }
  return runs;
}

/// Throws InputError unless the table holds exactly the runs of the scene's study.
void requireRuns(const fs::path& csv, const scene::Scene& scene) {
  const Runs wanted = runsOf(scene);
  std::set<std::string> found;
  for (const RunRow& row : rowsOf(csv)) found.insert(keyOf(row, wanted.columns));
  if (found == wanted.keys) return;
  throw InputError(csv.string() +
                   " doesn't hold the runs of the scene's study; run the study again (or give "
                   "this command the same --set): " +
                   remedy("study", scene, csv.parent_path()));
}

std::vector<Check> checksOfOrders(const scene::StudySettings& study, const fs::path& csv) {
  std::map<std::string, double> orders;
  for (const RunRow& row : rowsOf(csv)) {
    orders[keyOf(row, {"integrator"})] = fieldOf(row, "order");
  }
  std::vector<Check> checks;
  for (const auto& [integrator, bounds] : study.orders) {
    const std::string name(scene::nameOf(scene::kIntegrators, integrator));
    checks.push_back(checkOf("order of " + name, bounds,
                             orders.contains(name) ? orders[name] : study::kNoNumber,
                             "power of the step by which the error shrinks"));
  }
  return checks;
}

std::vector<Check> checksOfTilts(const scene::StudySettings& study, const fs::path& csv) {
  if (!study.flipLaw) return {};
  study::TiltStudy measured;
  for (const RunRow& row : rowsOf(csv)) {
    study::TiltRow tilt;
    tilt.interval = fieldOf(row, "interval_s");
    tilt.law = fieldOf(row, "law_s");
    measured.rows.push_back(tilt);
  }
  return {checkOf("flip_law", *study.flipLaw, measured.greatestDeviation(),
                  "largest deviation from the interval that the law gives, as a share of it")};
}

/// Reads the results of a sweep from its table, as far as they are measured.
study::SweepStudy sweepFrom(const scene::Sweep& sweep, const fs::path& csv) {
  study::SweepStudy study;
  for (const RunRow& row : rowsOf(csv)) {
    study::SweepRow run{keyOf(row, {sweep.over.key}),
                        sweep.curves ? keyOf(row, {sweep.curves->key}) : ""};
    for (const scene::Measure measure : sweep.measures) {
      run.measured.push_back(fieldOf(row, std::string(nameOf(measure))));
    }
    study.rows.push_back(run);
  }
  return study;
}

std::vector<Check> checksOfSweep(const scene::Sweep& sweep, const fs::path& csv) {
  std::vector<Check> checks;
  for (const study::ExpectedOfRun& one : expectedOf(sweepFrom(sweep, csv), sweep)) {
    checks.push_back(checkOf(one.subject(), one.expectation.bounds, one.measured,
                             std::string(rowOf(one.expectation.measure).meaning)));
  }
  return checks;
}

std::vector<Check> checksOf(const scene::StudySettings& study, const store::StudyFiles& files) {
  if (study.sweep) return checksOfSweep(*study.sweep, files.csv);
  return study.isOfTilts() ? checksOfTilts(study, files.csv) : checksOfOrders(study, files.orders);
}

}  // namespace

Figure studyFigure(const scene::Scene& scene, const fs::path& folder) {
  const store::StudyFiles files = store::studyFiles(folder, scene.name);
  const bool hasOrders = !scene.study->isOfTilts() && !scene.study->sweep;
  requireFile(files.csv, scene, "study");
  for (const auto& file : files.plots) requireFile(file, scene, "study");
  if (hasOrders) requireFile(files.orders, scene, "study");
  requireRuns(files.csv, scene);
  const std::vector<Check> checks = checksOf(*scene.study, files);

  Figure figure{FigureKind::Study, scene.name, scene.title};
  figure.badge = unmetBadge(checks);
  Html links;
  const auto link = [&](const fs::path& file, const std::string& title) {
    figure.files.push_back(file.filename().string());
    links += linkItem(figure.files.back(), title);
  };
  for (const fs::path& plot : files.plots) {
    link(plot, formatOf(plot));
    if (plot.extension() == ".svg") figure.thumbnail = figure.files.back();
  }
  link(files.csv, "CSV");
  if (hasOrders) link(files.orders, "CSV of the orders");
  figure.section =
      filled(studyTemplate(),
             {{"id", escaped(scene.name)},
              {"anchor", addressOf(scene.name)},
              {"title", escaped(scene.title)},
              {"badge", figure.badge},
              {"plot", addressOf(figure.thumbnail)},
              {"caption", escaped(scene.caption)},
              {"checks", foldedChecks(checks, checksTable("Expected and measured", checks))},
              {"links", links},
              {"scene", sceneDetails(scene)}});
  return figure;
}

}  // namespace rotatebook::page

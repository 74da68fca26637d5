#include "report/study_report.h"

#include <limits>
#include <sstream>
#include <variant>

#include <gtest/gtest.h>

namespace rotatebook::report {
namespace {

using physics::Integrator;
using study::RunEnd;

study::PrecisionRow rowOf(Integrator integrator, RunEnd::Kind kind) {
  study::PrecisionRow row;
  row.integrator = integrator;
  row.end.kind = kind;
  return row;
}

study::PrecisionStudy exampleStudy() {
  study::PrecisionStudy study;
  study.rows = {rowOf(Integrator::Rk4, RunEnd::Kind::Diverged),
                rowOf(Integrator::Rk4, RunEnd::Kind::Whole),
                rowOf(Integrator::Midpoint, RunEnd::Kind::NoConvergence)};
  study.orders = {{Integrator::Rk4, {4.0123456, 5, 0.001, 0.0123456}}, {Integrator::Midpoint, {}}};
  return study;
}

TEST(StudyReport, ReportsOrdersAndFailures) {
  std::ostringstream out;
  EXPECT_TRUE(reportStudy(exampleStudy(), {}, out));
  EXPECT_EQ(out.str(),
            "  rk4              order  4.01 from  5 runs, steps of 0.001 to 0.0123 s\n"
            "  midpoint         no order: 0 usable runs, 3 needed\n"
            "  rk4: 1 of 2 runs diverged\n"
            "  midpoint: 1 of 1 runs found no solution for their steps\n");
}

TEST(StudyReport, SaysNoSolutionOnlyWhereNoneWasFound) {
  study::PrecisionStudy study;
  study.rows = {rowOf(Integrator::Dmv4, RunEnd::Kind::StepTooLong)};
  study.orders = {{Integrator::Dmv4, {}}};
  std::ostringstream out;
  EXPECT_TRUE(reportStudy(study, {}, out));
  EXPECT_EQ(out.str(),
            "  dmv4             no order: 0 usable runs, 3 needed\n"
            "  dmv4: 1 of 1 runs had steps too long for their series\n");
}

TEST(StudyReport, ComparesOrdersWithWhatIsExpected) {
  scene::StudySettings settings;
  settings.orders = {{Integrator::Rk4, {3.9, {}}}};
  std::ostringstream out;
  EXPECT_TRUE(reportStudy(exampleStudy(), settings, out));
  EXPECT_NE(out.str().find("\n  met      order of rk4: expected at least 3.9; measured 4.012346\n"),
            std::string::npos);
  settings.orders = {{Integrator::Rk4, {3.9, 4}}, {Integrator::Midpoint, {2, {}}}};
  EXPECT_FALSE(reportStudy(exampleStudy(), settings, out));
  EXPECT_NE(out.str().find("\n  not met  order of rk4: expected at least 3.9, at most 4; measured "
                           "4.012346\n  not met  order of midpoint: expected at least 2; measured "
                           "nothing\n"),
            std::string::npos);
}

TEST(StudyReport, ReportsIntervals) {
  study::TiltStudy study;
  study.rows = {{0.1, {}, 7, 2.0, 2.5}, {1e-8, {RunEnd::Kind::FewFlips, 12}, 1}};
  scene::StudySettings settings;
  settings.flipLaw = scene::Bounds{{}, 0.1};
  std::ostringstream out;
  EXPECT_FALSE(reportStudy(study, settings, out));
  EXPECT_EQ(out.str(),
            "  tilt 0.1       7 flips, one every 2 s; the law says 2.5 s\n"
            "  tilt 1e-08   fewer than two flips in 12 s\n"
            "  not met  flip_law: expected at most 0.1; measured nothing\n");
  study.rows.pop_back();
  settings.flipLaw = scene::Bounds{0.1, 0.3};
  EXPECT_TRUE(reportStudy(study, settings, out));
}

StudiedScene studiedScene() {
  StudiedScene studied;
  studied.scene.name = "s";
  studied.scene.title = "\"S\"";
  studied.checksum = "5ce";
  return studied;
}

TEST(StudyReport, IsJsonToo) {
  StudiedScene studied = studiedScene();
  studied.study.orders = {{Integrator::Rk4, {3.9, 4}}};
  studied.result = exampleStudy();
  studied.files = {"out/s-study.csv"};
  std::ostringstream out;
  reportStudiesAsJson({studied}, false, out);
  EXPECT_EQ(
      out.str(),
      R"({"interrupted": false, "studies": [{"name": "s", "title": "\"S\"", "scene_xxh128": "5ce", )"
      R"("kind": "integrators", "interrupted": false, "error": null, )"
      R"("files": ["out/s-study.csv"], "runs": 3, )"
      R"("failures": [{"integrator": "rk4", "h_s": 0, "status": "diverged at 0 s"}, )"
      R"({"integrator": "midpoint", "h_s": 0, "status": "no convergence"}], )"
      R"("orders": [{"integrator": "rk4", "order": 4.0123456, "runs": 5, "shortest_h_s": 0.001, )"
      R"("longest_h_s": 0.0123456}, {"integrator": "midpoint", "order": null, "runs": 0, )"
      R"("shortest_h_s": null, "longest_h_s": null}], "tilts": [], "sweep": [], )"
      R"("expectations": [{"quantity": "order", "integrator": "rk4", )"
      R"("meaning": "power of the step by which the error shrinks", "min": 3.9, "max": 4, )"
      R"("measured": 4.0123456, "met": false}]}]})"
      "\n");
}

TEST(StudyReport, IsJsonForTiltsAndWhatWasNotStudied) {
  StudiedScene studied = studiedScene(), failed = studiedScene();
  studied.study.tilts = failed.study.tilts = {0.1, 1e-8};
  studied.study.flipLaw = failed.study.flipLaw = scene::Bounds{{}, 0.1};
  studied.result =
      study::TiltStudy{{{0.1, {}, 7, 2.0, 2.5}, {1e-8, {RunEnd::Kind::FewFlips, 12}, 1}}};
  failed.error = "no disk";
  std::ostringstream out;
  reportStudiesAsJson({studied, failed}, true, out);
  EXPECT_EQ(
      out.str(),
      R"({"interrupted": true, "studies": [{"name": "s", "title": "\"S\"", "scene_xxh128": "5ce", "kind": "tilts", )"
      R"("interrupted": false, "error": null, "files": [], "runs": 2, )"
      R"("failures": [{"tilt_rad": 1e-08, "status": "fewer than two flips in 12 s"}], )"
      R"("orders": [], "tilts": [{"tilt_rad": 0.1, "flips": 7, "interval_s": 2, "law_s": 2.5, )"
      R"("ratio": 0.8}, {"tilt_rad": 1e-08, "flips": 1, "interval_s": null, "law_s": 0, )"
      R"("ratio": null}], "sweep": [], "expectations": [{"quantity": "flip_law", "integrator": null, )"
      R"("meaning": "largest deviation from the interval that the law gives, as a share of it", )"
      R"("min": null, "max": 0.1, "measured": null, "met": false}]}, {"name": "s", )"
      R"("title": "\"S\"", "scene_xxh128": "5ce", "kind": "tilts", "interrupted": false, )"
      R"("error": "no disk", )"
      R"("files": [], "runs": 0, "failures": [], "orders": [], "tilts": [], )"
      R"("sweep": [], "expectations": []}]})"
      "\n");
}

/// A sweep over steps of two models; the matrix diverges.
StudiedScene sweptScene() {
  StudiedScene studied = studiedScene();
  scene::Sweep& sweep = studied.study.sweep.emplace();
  sweep.x = {"simulation.substeps", {{"10", "10", 10}}};
  sweep.curves = {"simulation.model", {{"", "matrix"}, {"", "quaternion"}}};
  sweep.measures = {scene::Measure::DivergesAt, scene::Measure::Stretch};
  sweep.expected = {
      {.measure = scene::Measure::DivergesAt, .max = 4, .at = {std::nullopt, "matrix"}},
      {.measure = scene::Measure::DivergesAt, .min = 30, .at = {std::nullopt, "quaternion"}}};
  constexpr double kNever = std::numeric_limits<double>::infinity();
  studied.result = study::SweepStudy{
      {{"10", "matrix", {RunEnd::Kind::Diverged, 4.5}, 20, {4.5, study::kNoNumber}},
       {"10", "quaternion", {}, 20, {kNever, 0.25}}}};
  return studied;
}

TEST(StudyReport, HasALineForEachRunOfASweep) {
  const StudiedScene studied = sweptScene();
  std::ostringstream out;
  EXPECT_FALSE(reportStudy(std::get<study::SweepStudy>(studied.result), studied.study, out));
  EXPECT_EQ(out.str(),
            "  matrix, 10: diverges_at 4.5, stretch –; diverged at 4.5 s\n"
            "  quaternion, 10: diverges_at not within 20 s, stretch 0.25\n"
            "  not met  diverges_at at 10, matrix: expected at most 4; measured 4.5\n"
            "  met      diverges_at at 10, quaternion: expected at least 30; measured inf\n");
}

TEST(StudyReport, IsJsonForASweep) {
  std::ostringstream out;
  reportStudiesAsJson({sweptScene()}, false, out);
  EXPECT_EQ(
      out.str(),
      R"({"interrupted": false, "studies": [{"name": "s", "title": "\"S\"", "scene_xxh128": "5ce", )"
      R"("kind": "sweep", "interrupted": false, "error": null, "files": [], "runs": 2, )"
      R"("failures": [{"value": "10", "curve": "matrix", "status": "diverged at 4.5 s"}], )"
      R"("orders": [], "tilts": [], "sweep": [{"value": "10", "curve": "matrix", )"
      R"("diverges_at": 4.5, "stretch": null}, {"value": "10", "curve": "quaternion", )"
      R"("diverges_at": null, "stretch": 0.25}], "expectations": [{"quantity": )"
      R"("diverges_at at 10, matrix", "integrator": null, "meaning": ")" +
          std::string(rowOf(scene::Measure::DivergesAt).meaning) +
          R"(", "min": null, "max": 4, "measured": 4.5, "met": false}, {"quantity": )"
          R"("diverges_at at 10, quaternion", "integrator": null, "meaning": ")" +
          std::string(rowOf(scene::Measure::DivergesAt).meaning) +
          R"(", "min": 30, "max": null, "measured": "inf", "met": true}]}]})"
          "\n");
}

}  // namespace
}  // namespace rotatebook::report

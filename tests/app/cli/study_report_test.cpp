#include <limits>
#include <sstream>

#include <gtest/gtest.h>

#include "cli/batch.h"
#include "cli/study_command.h"

namespace rotatebook::cli {
namespace {

using scene::Measure;
using study::RunEnd;
using study::StudyRow;

StudyRow rowOf(const std::string& curve, RunEnd::Kind kind, double error = study::kNoNumber) {
  StudyRow row{"1", curve, {kind, 4.5}, 20, 0.25};
  row.measured = {error};
  return row;
}

StudiedScene studiedScene(const std::vector<Measure>& measures) {
  StudiedScene studied;
  studied.scene.name = "s";
  studied.scene.title = "\"S\"";
  studied.checksum = "5ce";
  scene::StudySettings& study = studied.scene.study.emplace();
  study.x.key = "simulation.substeps";
  study.curves.emplace().key = "simulation.integrator";
  study.measures = measures;
  return studied;
}

StudiedScene orders() {
  StudiedScene studied = studiedScene({Measure::Order});
  studied.result = study::Study{
      {rowOf("rk4", RunEnd::Kind::Diverged), rowOf("rk4", RunEnd::Kind::Whole, 3),
       rowOf("midpoint", RunEnd::Kind::NoConvergence), rowOf("dmv4", RunEnd::Kind::StepTooLong)},
      {{"rk4", {4.0123456, 5, 0.001, 0.0123456}}, {"midpoint", {}}, {"dmv4", {}}}};
  return studied;
}

/// The report, and whether all is met.
std::pair<std::string, bool> reportOf(const StudiedScene& studied) {
  std::ostringstream out;
  const bool met = reportStudy(*studied.result, *studied.scene.study, out);
  return {out.str(), met};
}

TEST(StudyReport, ReportsOrdersAndFailures) {
  const auto [text, met] = reportOf(orders());
  EXPECT_TRUE(met);
  EXPECT_EQ(text,
            "  rk4              order  4.01 from  5 runs, steps of 0.001 to 0.0123 s\n"
            "  midpoint         no order: 0 usable runs, 3 needed\n"
            "  dmv4             no order: 0 usable runs, 3 needed\n"
            "  rk4: 1 of 2 runs diverged\n"
            "  midpoint: 1 of 1 runs found no solution for their steps\n"
            "  dmv4: 1 of 1 runs had steps too long for their series\n");
}

TEST(StudyReport, ComparesOrdersWithWhatIsExpected) {
  StudiedScene studied = orders();
  studied.scene.study->expected = {
      {.measure = Measure::Order, .min = 3.9, .max = 4, .at = {std::nullopt, "rk4"}},
      {.measure = Measure::Order, .min = 2, .at = {std::nullopt, "midpoint"}}};
  const auto [text, met] = reportOf(studied);
  EXPECT_FALSE(met);
  EXPECT_NE(text.find("\n  not met  order of rk4: expected at least 3.9, at most 4; measured "
                      "4.012346\n  not met  order of midpoint: expected at least 2; measured "
                      "nothing\n"),
            std::string::npos);
}

/// Runs of two models; the matrix diverges.
StudiedScene runs() {
  StudiedScene studied = studiedScene({Measure::DivergesAt, Measure::Stretch});
  studied.scene.study->expected = {
      {.measure = Measure::DivergesAt, .max = 4, .at = {std::nullopt, "matrix"}},
      {.measure = Measure::DivergesAt, .min = 30, .at = {std::nullopt, "quaternion"}}};
  constexpr double kNever = std::numeric_limits<double>::infinity();
  studied.result = study::Study{
      {{"10", "matrix", {RunEnd::Kind::Diverged, 4.5}, 20, 0.1, {4.5, study::kNoNumber}},
       {"10", "quaternion", {}, 20, 0.1, {kNever, 0.25}}}};
  return studied;
}

TEST(StudyReport, HasALineForEachRun) {
  const auto [text, met] = reportOf(runs());
  EXPECT_FALSE(met);
  EXPECT_EQ(text,
            "  matrix, 10: diverges_at 4.5, stretch –; diverged at 4.5 s\n"
            "  quaternion, 10: diverges_at not within 20 s, stretch 0.25\n"
            "  not met  diverges_at at 10, matrix: expected at most 4; measured 4.5\n"
            "  met      diverges_at at 10, quaternion: expected at least 30; measured inf\n");
}

TEST(StudyReport, HasTheErrorOfARunWhereMoreThanTheOrderIsMeasured) {
  StudiedScene studied = studiedScene({Measure::Order, Measure::HalfTurns});
  studied.result = study::Study{{{"1", "rk4", {}, 20, 0.1, {0.5, 3}}}, {{"rk4", {}}}};
  EXPECT_EQ(reportOf(studied).first,
            "  rk4              no order: 0 usable runs, 3 needed\n"
            "  rk4, 1: error_deg 0.5, half_turns 3\n");
}

TEST(StudyReport, IsJsonToo) {
  StudiedScene studied = runs(), failed = orders();
  studied.written = {"out/s-study.csv"};
  failed.result.reset();
  failed.error = "no disk";
  const std::string meaning(scene::rowOf(Measure::DivergesAt).meaning);
  EXPECT_EQ(jsonText(batchJson("studies", std::vector{studied, failed}, studyJson, true)),
            R"({"interrupted":true,"studies":[{"result":"study","name":"s","title":"\"S\"",)"
            R"("scene_xxh128":"5ce",)"
            R"("x":"simulation.substeps","curves":"simulation.integrator","interrupted":false,)"
            R"("error":null,"files":["out/s-study.csv"],)"
            R"("runs":[{"value":"10","curve":"matrix","diverges_at":4.5,"stretch":null,)"
            R"("status":"diverged at 4.5 s"},{"value":"10","curve":"quaternion",)"
            R"("diverges_at":null,"stretch":0.25,"status":"ok"}],"orders":[],)"
            R"("expectations":[{"quantity":"diverges_at at 10, matrix","meaning":")" +
                meaning +
                R"(","min":null,"max":4.0,"measured":4.5,"met":false},)"
                R"({"quantity":"diverges_at at 10, quaternion","meaning":")" +
                meaning +
                R"(","min":30.0,"max":null,"measured":"inf","met":true}]},)"
                R"({"result":"study","name":"s","title":"\"S\"","scene_xxh128":"5ce",)"
                R"("x":"simulation.substeps",)"
                R"("curves":"simulation.integrator","interrupted":false,"error":"no disk",)"
                R"("files":[],"runs":[],"orders":[],"expectations":[]}]})");
}

TEST(StudyReport, HasOrdersAsJson) {
  const std::string json = jsonText(studyJson(orders()));
  EXPECT_NE(json.find(R"("runs":[{"value":"1","curve":"rk4","h_s":0.25,"error_deg":null,)"
                      R"("ns_per_step":null,"status":"diverged at 4.5 s"},)"),
            std::string::npos);
  EXPECT_NE(json.find(R"("orders":[{"curve":"rk4","order":4.0123456,"runs":5,)"
                      R"("shortest_h_s":0.001,"longest_h_s":0.0123456},)"
                      R"({"curve":"midpoint","order":null,"runs":0,)"
                      R"("shortest_h_s":null,"longest_h_s":null},)"),
            std::string::npos);
}

}  // namespace
}  // namespace rotatebook::cli

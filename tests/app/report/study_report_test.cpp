#include "report/study_report.h"

#include <sstream>

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

TEST(StudyReport, ComparesOrdersWithWhatIsExpected) {
  scene::StudySettings settings;
  settings.orders = {{Integrator::Rk4, {3.9, {}}}};
  std::ostringstream out;
  EXPECT_TRUE(reportStudy(exampleStudy(), settings, out));
  EXPECT_NE(out.str().find("\n  met    order of rk4: expected at least 3.9; measured 4.012346\n"),
            std::string::npos);
  settings.orders = {{Integrator::Rk4, {3.9, 4}}, {Integrator::Midpoint, {2, {}}}};
  EXPECT_FALSE(reportStudy(exampleStudy(), settings, out));
  EXPECT_NE(out.str().find("\n  UNMET  order of rk4: expected at least 3.9, at most 4; measured "
                           "4.012346\n  UNMET  order of midpoint: expected at least 2; measured "
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
            "  UNMET  flip_law: expected at most 0.1; measured nothing\n");
  study.rows.pop_back();
  settings.flipLaw = scene::Bounds{0.1, 0.3};
  EXPECT_TRUE(reportStudy(study, settings, out));
}

}  // namespace
}  // namespace rotatebook::report

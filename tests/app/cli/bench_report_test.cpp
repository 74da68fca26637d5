#include <sstream>

#include <gtest/gtest.h>

#include "cli/machine_commands.h"

namespace rotatebook::cli {
namespace {

pipeline::Speed example() {
  pipeline::Speed speed;
  speed.frames = 120;
  speed.cores = 2;
  speed.startUp = 0.25;
  speed.whole = {50, 95};
  speed.drawing = {25, 30};
  speed.renderer = "a \"card\"";
  speed.encoder = "libx264";
  speed.stages = {{0, 0}, {22, 24}, {4, 4}, {42, 42}, {20, 20}};
  return speed;
}

scene::Scene named() {
  scene::Scene scene;
  scene.name = "tiny";
  return scene;
}

TEST(BenchReport, ReportsStagesLimitAndWhatHelps) {
  std::ostringstream out;
  reportSpeed(named(), example(), out);
  EXPECT_EQ(out.str(),
            "tiny: 120 frames, 1280x720, PNGs and MP4\n"
            "  renderer a \"card\"; encoder libx264; 2 cores\n"
            "  20.0 frames/s, 50.00 ms a frame, 95.00 ms of processor time; started in 0.25 s\n"
            "  drawing alone: 40.0 frames/s, 25.00 ms a frame, 30.00 ms of processor time\n"
            "\n"
            "  each stage alone      ms/frame  processor   share\n"
            "  simulate                  0.00       0.00     0 %\n"
            "  draw the book            22.00      24.00    27 %\n"
            "  edges, overlays           4.00       4.00     4 %\n"
            "  PNG                      42.00      42.00    47 %\n"
            "  convert and encode       20.00      20.00    22 %\n"
            "  all                                 90.00\n"
            "\n"
            "  limit: 45.00 ms a frame, 22.2 frames/s; the render took 1.11 times that\n"
            "  what limits: the 2 cores, which are busiest with \"PNG\"\n"
            "  what would help:\n"
            "    --size 640x360           up to 4.00 times as fast, 80 frames/s; a quarter of the "
            "pixels\n"
            "    more cores               up to 2.00 times as fast, 40 frames/s; with 4\n"
            "    --no-png                 up to 1.88 times as fast, 38 frames/s; the MP4 alone\n");
}

TEST(BenchReport, NamesTheStageForWhichOthersWait) {
  pipeline::Speed speed = example();
  speed.cores = 16;
  std::ostringstream out;
  reportSpeed(named(), speed, out);
  EXPECT_NE(out.str().find("\n  what limits: \"draw the book\", for which the other stages wait "
                           "while cores are idle\n"),
            std::string::npos)
      << out.str();
}

TEST(BenchReport, IsJsonToo) {
  pipeline::Speed speed = example();
  speed.frames = 100'000;
  std::ostringstream out;
  reportSpeedAsJson(named(), speed, out);
  EXPECT_EQ(out.str(),
            "{\"scene\":\"tiny\",\"frames\":100000,\"width\":1280,\"height\":720,\"cores\":2,"
            "\"renderer\":\"a \\\"card\\\"\",\"encoder\":\"libx264\",\"start_up_s\":0.25,"
            "\"frames_per_second\":20.0,\"whole\":{\"wall\":50.0,\"processor\":95.0},\"drawing\":"
            "{\"wall\":25.0,"
            "\"processor\":30.0},\"limit\":"
            "45.0,\"limited_by\":\"cores\",\"stages\":{\"simulate\":{\"wall\":0.0,"
            "\"processor\":0.0},\"book\":{\"wall\":22.0,\"processor\":24.0},\"compose\":"
            "{\"wall\":4.0,\"processor\":4.0},\"png\":{\"wall\":42.0,\"processor\":42.0},"
            "\"video\":{\"wall\":20.0,\"processor\":20.0}}}\n");
}

}  // namespace
}  // namespace rotatebook::cli

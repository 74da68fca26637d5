#include "diagnose/doctor_report.h"

#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rotatebook::diagnose {
namespace {

using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;

/// A card that fails, software in its place, and no VP9.
Checkup lameMachine() {
  Checkup checkup;
  DisplayCheck card{.candidate = {.index = 0, .renderNode = "/dev/dri/renderD128", .cudaId = 1},
                    .failure = render::CallFailure{"eglInitialize", "EGL_NOT_INITIALIZED"}};
  DisplayCheck software{.candidate = {.index = 1, .software = true},
                        .vendor = "Mesa",
                        .renderer = "llvmpipe",
                        .version = "4.5",
                        .samples = 4,
                        .software = true};
  software.reference.tolerance = {.largest = 3, .failPercent = 0.5};
  checkup.graphics.candidates = {card, software};
  checkup.graphics.byDefault = 1;
  checkup.encoders = {{video::VideoFormat::Mp4, "libx264", ""},
                      {video::VideoFormat::WebM, "", "no encoder"}};
  checkup.folder = {"out", 12'340'000'000, ""};
  checkup.cores = 2;
  checkup.memory = 8e9;
  checkup.problems = {{"the card fails", "do this:\n  a command"}, {"webm: no encoder", "install"}};
  return checkup;
}

std::string textOf(const Checkup& checkup) {
  std::ostringstream out;
  reportCheckup(checkup, out);
  return out.str();
}

TEST(DoctorReport, ReportsEachDeviceAndProblemAndAVerdict) {
  EXPECT_THAT(
      textOf(lameMachine()),
      EndsWith("graphics\n"
               "  EGL device 0         eglInitialize: EGL_NOT_INITIALIZED\n"
               "                       /dev/dri/renderD128, cuda:1\n"
               "  EGL device 1         llvmpipe; draws by default\n"
               "                       software, Mesa, OpenGL 4.5, 4 samples\n"
               "                       reference picture right: off by at most 0 of 255, 0 % by "
               "more than 3 (0.5 % allowed)\n"
               "\n"
               "encoders\n"
               "  mp4                  libx264\n"
               "  webm                 none\n"
               "\n"
               "machine\n"
               "  font                 the one that ships is loaded\n"
               "  output folder        out, 12.3 GB free\n"
               "  cores                2\n"
               "  memory               8 GB\n"
               "\n"
               "problems\n"
               "  1. the card fails\n"
               "     remedy: do this:\n"
               "               a command\n"
               "  2. webm: no encoder\n"
               "     remedy: install\n"
               "\n"
               "Ready to render: EGL device 1 draws (software), libx264 encodes; 2 problems "
               "are reported above.\n"));
}

TEST(DoctorReport, IsNotReadyWithoutAFrameAnEncoderOrAFolder) {
  Checkup checkup = lameMachine();
  checkup.graphics.candidates[1].reference.comparison.same = false;
  checkup.encoders[0].found.clear();
  checkup.folder.failure = "out can't be written";
  EXPECT_FALSE(checkup.ready());
  EXPECT_THAT(textOf(checkup),
              AllOf(HasSubstr(" reference picture WRONG: "),
                    EndsWith("\nNOT READY to render: nothing draws as it should, MP4 can't be "
                             "encoded, the output folder can't be written.\n")));
}

TEST(DoctorReport, IsJsonToo) {
  std::ostringstream out;
  reportCheckupAsJson(lameMachine(), out);
  EXPECT_THAT(
      out.str(),
      AllOf(HasSubstr("{\"name\":\"EGL device 0\",\"device\":0,\"default\":false,"
                      "\"drm_node\":null,\"render_node\":\"/dev/dri/renderD128\",\"cuda\":1,"
                      "\"failure\":{\"call\":\"eglInitialize\",\"error\":"
                      "\"EGL_NOT_INITIALIZED\"}}"),
            HasSubstr("\"free_bytes\":12340000000"), HasSubstr("do this:\\n  a command")));
}

}  // namespace
}  // namespace rotatebook::diagnose

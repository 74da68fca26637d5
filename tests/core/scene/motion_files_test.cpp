#include "scene/motion_files.h"

#include <filesystem>
#include <map>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/checksum.h"
#include "base/error.h"
#include "messages.h"
#include "recording/recorded_motion.h"
#include "scene/parse.h"

namespace rotatebook::scene {
namespace {

using physics::Model;
using ::testing::HasSubstr;
using ::testing::Not;

// Two seconds of a steady spin of 3 rad/s about z.
constexpr const char* kGyro =
    "t,wx (rad/s),wy (rad/s),wz (rad/s)\n0,0,0,3\n0.5,0,0,3\n1,0,0,3\n2,0,0,3\n";
constexpr const char* kRecorded =
    "[simulation]\nmodel = \"recorded\"\nfile = \"g.csv\"\n[clip]\nduration = 1\n";

std::string fileNamed(const std::filesystem::path& file, std::size_t /*most*/) {
  static const std::map<std::string, std::string> files{
      {"g.csv", kGyro},
      {"bare.csv", "a,b,c,d\n0,0,0,180\n2,0,0,180\n"},
      {"rest.csv", "t,wx (rad/s),wy (rad/s),wz (rad/s)\n0,0,0,0\n2,0,0,1\n"}};
  const auto found = files.find(file.string());
  if (found == files.end()) throw InputError("can't read " + file.string() + ": no such file");
  return found->second;
}

Scene readRecorded(const std::string& text) {
  return parseScene(text, "a.toml", {}, fileNamed);
}

std::string refusalOfRecording(const std::string& text) {
  try {
    readRecorded(text);
    return "no error";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(Recordings, StartAsTheirFileDoes) {
  const Scene scene = readRecorded(kRecorded);
  EXPECT_EQ(scene.motions[0].simulation.model, Model::Recorded);
  EXPECT_NE(scene.motions[0].simulation.recorded.motion, nullptr);
  EXPECT_EQ(scene.motions[0].initial.value, Eigen::Vector3d(0, 0, 3));
  EXPECT_EQ(scene.motions[0].simulation.recorded.checksum, checksumOf(kGyro));
}

TEST(Recordings, ArePrintedWithTheirChecksumAndReadBack) {
  const Scene scene = readRecorded(std::string(kRecorded) +
                                   "[simulation.columns]\ntime = \"t\"\nwx = \"wx (rad/s)\"\n");
  const std::string text = sceneText(scene);
  EXPECT_THAT(text, HasSubstr("file = \"g.csv\""));
  EXPECT_THAT(text, HasSubstr("columns = { time = \"t\", wx = \"wx (rad/s)\" }"));
  EXPECT_THAT(text, HasSubstr("checksum = \"" + checksumOf(kGyro) + "\""));
  EXPECT_THAT(text, Not(HasSubstr("[initial]")));
  EXPECT_EQ(sceneText(readRecorded(text)), text);
  // A record is compared where the file isn't.
  EXPECT_EQ(sceneText(parseScene(text, "a.toml")), text);
}

TEST(Recordings, TakeColumnsUnitsPartsAndBias) {
  const Scene scene = readRecorded(
      "[simulation]\nmodel = \"recorded\"\nfile = \"bare.csv\"\nrates = \"deg/s\"\ntime_unit = "
      "\"s\"\n"
      "columns = { time = \"a\", wx = \"d\", wy = \"b\", wz = \"c\" }\nfrom = 0.5\nto = \"2 s\"\n"
      "bias = [0, 0, 1]\n[clip]\nduration = 1\n");
  EXPECT_NEAR(scene.motions[0].initial.value.x(), 3.14159265, 1e-8);
  EXPECT_EQ(scene.motions[0].initial.value.z(), -1);
  EXPECT_NEAR(scene.motions[0].simulation.recorded.motion->duration(), 1.5, 1e-15);
  EXPECT_EQ(sceneText(readRecorded(sceneText(scene))), sceneText(scene));
}

TEST(Recordings, AreOfPanelsToo) {
  const Scene scene = readRecorded(std::string(kRecorded) +
                                   "[initial]\nangular_velocity = [1, 2, 3]\n"
                                   "[[panel]]\nlabel = \"a\"\n"
                                   "[[panel]]\nlabel = \"b\"\nsimulation.model = \"exact\"\n");
  EXPECT_EQ(scene.motions[0].initial.value, Eigen::Vector3d(0, 0, 3));
  EXPECT_EQ(scene.motions[1].initial.value, Eigen::Vector3d(1, 2, 3));
}

TEST(Recordings, AreRefusedWhereTheyAreNamed) {
  EXPECT_EQ(refusalOfRecording("[simulation]\nmodel = \"recorded\"\nfile = \"no.csv\"\n"),
            "a.toml:3:8: can't read no.csv: no such file");
  EXPECT_EQ(refusalOfRecording("[simulation]\nmodel = \"recorded\"\nfile = \"bare.csv\"\n"),
            "a.toml:3:8: bare.csv: no column of times among \"a\", \"b\", \"c\" and \"d\"; name it "
            "in simulation.columns, or with --column");
  EXPECT_EQ(refusalOfRecording("[simulation]\nmodel = \"recorded\"\nfile = \"rest.csv\"\n"),
            "a.toml:3:8: rest.csv: the body is at rest at first; say when its motion starts with "
            "simulation.from, or --from");
  EXPECT_EQ(refusalOfRecording("[simulation]\nmodel = \"recorded\"\nfile = \"g.csv\"\n"),
            "a.toml:3:8: the recording \"g.csv\" lasts 2 s, but the clip shows 11.9833 s of it; "
            "lower clip.duration or clip.speed");
  EXPECT_EQ(refusalOfRecording(
                "[simulation]\nmodel = \"recorded\"\nfile = \"g.csv\"\nchecksum = \"0\"\n"),
            "a.toml:3:8: the file \"g.csv\" has changed: its checksum is " + checksumOf(kGyro) +
                ", not 0; bring the file back, or leave simulation.checksum out");
  const std::string panels =
      "[clip]\nduration = 1\n[simulation]\nmodel = \"recorded\"\n"
      "[[panel]]\nlabel = \"a\"\nsimulation.file = \"g.csv\"\n"
      "[[panel]]\nlabel = \"b\"\nsimulation.file = \"no.csv\"\n";
  EXPECT_EQ(refusalOfRecording(panels), "a.toml:10:19: can't read no.csv: no such file");
}

TEST(Recordings, NeedAFileAndNoStart) {
  EXPECT_EQ(
      refusalOfRecording("[simulation]\nmodel = \"recorded\"\n"),
      "a.toml:2:9: the model \"recorded\" needs simulation.file, a table of the motion (CSV)");
  EXPECT_MESSAGE(refusalOfRecording(std::string(kRecorded) + kSpin));
  EXPECT_MESSAGE(refusalOfRecording(std::string(kRecorded) + "[study]\n"));
  EXPECT_MESSAGE(
      refusalOfRecording("[simulation]\nmodel = \"recorded\"\nintegrator = \"rk4\"\n"
                         "file = \"g.csv\"\n"));
}

TEST(Recordings, ArentReadWithoutAReader) {
  const Scene scene = parseScene(kRecorded, "a.toml");
  EXPECT_EQ(scene.motions[0].simulation.recorded.motion, nullptr);
  EXPECT_THAT(sceneText(scene), Not(HasSubstr("checksum")));
}

}  // namespace
}  // namespace rotatebook::scene

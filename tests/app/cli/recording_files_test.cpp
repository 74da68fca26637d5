// Recordings as phones export them: tables of several sensors in a folder, or in an archive.
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>
#include <zip.h>

#include "cli/program_test.h"
#include "messages.h"

namespace rotatebook::cli::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

using Files = std::map<std::string, std::string>;

/// Returns docs/toss.csv as phyphox exports it: a table for each sensor, the accelerometer's with
/// times of its own, and those of the experiment and the device.
Files phyphoxExport() {
  std::ifstream table(fs::path(ROTATEBOOK_SOURCE) / "docs/toss.csv");
  Files files{
      {"Gyroscope.csv",
       "\"Time (s)\",\"Gyroscope x (rad/s)\",\"Gyroscope y (rad/s)\",\"Gyroscope z (rad/s)\"\n"},
      {"Accelerometer.csv",
       "\"Time (s)\",\"Acceleration x (m/s^2)\",\"Acceleration y (m/s^2)\",\"Acceleration z "
       "(m/s^2)\"\n"},
      {"meta/time.csv", "\"event\",\"experiment time\",\"system time\"\n\"START\",0,1.7E9\n"},
      {"meta/device.csv", "\"property\",\"value\"\n\"version\",\"1.1.16\"\n"}};
  std::string line;
  std::getline(table, line);
  while (std::getline(table, line)) {
    std::istringstream cells(line);
    std::vector<std::string> cell(7);
    for (std::string& one : cell) std::getline(cells, one, ',');
    files["Gyroscope.csv"] += cell[0] + "," + cell[1] + "," + cell[2] + "," + cell[3] + "\n";
    files["Accelerometer.csv"] += std::to_string(std::stod(cell[0]) + 0.0037) + "," + cell[4] +
                                  "," + cell[5] + "," + cell[6] + "\n";
  }
  return files;
}

class RecordingFiles : public ProgramTest {
 protected:
  void writeFolder(const std::string& name, const Files& files) const {
    for (const auto& [file, text] : files) {
      const fs::path path = folder() / name / file;
      fs::create_directories(path.parent_path());
      std::ofstream(path) << text;
    }
  }

  void writeZip(const std::string& name, const Files& files) const {
    int error = 0;
    zip_t* const archive = zip_open((folder() / name).c_str(), ZIP_CREATE | ZIP_TRUNCATE, &error);
    ASSERT_NE(archive, nullptr);
    for (const auto& [file, text] : files) {
      zip_source_t* const source = zip_source_buffer(archive, text.data(), text.size(), 0);
      ASSERT_GE(zip_file_add(archive, file.c_str(), source, 0), 0);
    }
    ASSERT_EQ(zip_close(archive), 0);
  }

  ChildResult toss(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "toss");
    return runWithoutGraphics(arguments);
  }
};

// The default book's ratios are 0.3151 and 0.7266.
const auto kIsTheBook =
    AllOf(HasSubstr("  I1/I3 = 0.315"), HasSubstr("  I2/I3 = 0.726"), HasSubstr("of rest before"));

TEST_F(RecordingFiles, OfPhyphoxGiveTheRatios) {
  const Files files = phyphoxExport();
  writeZip("phyphox.zip", files);
  writeFolder("phyphox", files);
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"phyphox.zip"},
        {"phyphox"},
        {"phyphox/Gyroscope.csv"},
        {"phyphox/Gyroscope.csv", "--acceleration", "phyphox/Accelerometer.csv"}}) {
    const ChildResult result = toss(arguments);
    EXPECT_EQ(result.status, 0) << result.error;
    EXPECT_THAT(result.output, kIsTheBook);
  }
  // The folder's scene names the gyroscope's table.
  EXPECT_EQ(toss({"phyphox", "-o", "toss.toml"}).status, 0);
  EXPECT_THAT(read("toss.toml"), HasSubstr("file = \"phyphox/Gyroscope.csv\""));
  EXPECT_EQ(runWithoutGraphics({"simulate", "toss.toml"}).status, 0);
  EXPECT_THAT(toss({"phyphox.zip", "-o", "other.toml"}).error,
              HasSubstr("other.toml: a scene reads no archive; unpack phyphox.zip, and toss the "
                        "folder"));
}

TEST_F(RecordingFiles, ListTheirThrows) {
  writeFolder("phyphox", phyphoxExport());
  const ChildResult list = toss({"phyphox/Gyroscope.csv", "--list"});
  EXPECT_EQ(list.status, 0) << list.error;
  EXPECT_THAT(list.output,
              AllOf(HasSubstr("phyphox/Gyroscope.csv: 1 flight\n"), HasSubstr("I1/I3 = 0.315")));
  EXPECT_THAT(toss({"phyphox", "--list", "--json"}).output, HasSubstr("\"accepted\":true"));
}

TEST_F(RecordingFiles, TakeALeverWhereTheFlightIsSearchedByIt) {
  writeFolder("phyphox", phyphoxExport());
  const std::string refusal =
      "rotatebook: --lever is for the search for the flight by an "
      "accelerometer, and ";
  EXPECT_EQ(toss({"phyphox", "--lever", "0.04"}).status, 0);
  for (const char* bound : {"--from", "--to"}) {
    EXPECT_EQ(toss({"phyphox", "--lever", "0.04", bound, "1.5"}).error,
              refusal + "--from and --to state it; leave it out\n");
  }
  EXPECT_EQ(toss({"phyphox/Gyroscope.csv", "--lever", "0.04"}).error,
            refusal + "the recording has none; leave it out\n");
}

TEST_F(RecordingFiles, OfSensorLoggerGiveTheRatios) {
  const Files phyphox = phyphoxExport();
  Files files{{"Metadata.csv", "version,device name\n3,phone\n"}};
  for (const auto& [from, to] : {std::pair{"Gyroscope.csv", "Gyroscope.csv"},
                                 {"Accelerometer.csv", "TotalAcceleration.csv"},
                                 {"Accelerometer.csv", "Accelerometer.csv"}}) {
    std::istringstream lines(phyphox.at(from));
    std::string line, text = "time,seconds_elapsed,z,y,x\n";
    std::getline(lines, line);
    while (std::getline(lines, line)) {
      std::istringstream cells(line);
      std::string t, x, y, z;
      std::getline(std::getline(std::getline(std::getline(cells, t, ','), x, ','), y, ','), z, ',');
      text += "1727600000000000000," + t + "," + z + "," + y + "," + x + "\n";
    }
    files[to] = text;
  }
  writeZip("logged.zip", files);
  const ChildResult result = toss({"logged.zip"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_THAT(result.output, kIsTheBook);
}

TEST_F(RecordingFiles, SayWhatIsWrongWithThem) {
  writeZip("none.zip", {{"a.csv", "x,y\n1,2\n"}, {"b.txt", "words"}});
  EXPECT_THAT(
      toss({"none.zip"}).error,
      HasSubstr("none.zip: no table of a gyroscope's rates, or of attitudes, among \"a.csv\" "
                "and \"b.txt\""));
  writeZip("workbook.zip", {{"Toss.xls", "\xD0\xCF\x11\xE0"}});
  EXPECT_THAT(
      toss({"workbook.zip"}).error,
      HasSubstr("workbook.zip: no table is in it (.csv, .tsv or .txt); export the recording as "
                "CSV, of phyphox's formats \"CSV (Comma, decimal point)\""));
  const std::string rates = phyphoxExport().at("Gyroscope.csv");
  writeZip("two.zip", {{"a.csv", rates}, {"b.csv", rates}});
  EXPECT_THAT(toss({"two.zip"}).error, HasSubstr("\"a.csv\" and \"b.csv\" all have rates"));
  // Archives have the experiment's folder, whose name tells tables apart.
  writeZip("twice.zip", {{"left/Gyroscope.csv", rates}, {"right/Gyroscope.csv", rates}});
  EXPECT_THAT(toss({"twice.zip"}).error,
              HasSubstr("\"left/Gyroscope.csv\" and \"right/Gyroscope.csv\" all have rates"));
  writeZip("broken.zip", {{"left/Gyroscope.csv", rates + "99,x,0,0\n"}});
  EXPECT_THAT(toss({"broken.zip"}).error, HasSubstr("broken.zip: left/Gyroscope.csv:"));
  writeZip("book.xlsx", {{"[Content_Types].xml", "<Types/>"}, {"xl/workbook.xml", "<workbook/>"}});
  EXPECT_THAT(toss({"book.xlsx"}).error, HasSubstr("a workbook (.xlsx), which isn't read"));
  write("cut.zip", "PK\x03\x04 and no more");
  EXPECT_THAT(toss({"cut.zip"}).error, HasSubstr("cut.zip: can't be read as a ZIP archive: "));
  write("old.xls", "\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1");
  EXPECT_THAT(toss({"old.xls"}).error, HasSubstr("export the recording as CSV"));
}

TEST_F(RecordingFiles, AreReadWithinLimits) {
  // 17 MiB of blanks, in 17 kB
  writeZip("bomb.zip", {{"Gyroscope.csv", std::string(17 << 20, ' ')}});
  EXPECT_LT(fs::file_size(folder() / "bomb.zip"), 1 << 16);
  EXPECT_THAT(toss({"bomb.zip"}).error,
              HasSubstr("bomb.zip: Gyroscope.csv: longer than 16 MiB, the limit for a recording"));
  Files many;
  for (int i = 0; i < 65; ++i) many[std::to_string(i) + ".csv"] = "a\n";
  writeZip("many.zip", many);
  EXPECT_THAT(toss({"many.zip"}).error, HasSubstr("many.zip: more than 64 tables or 64 MiB"));
  Files large;
  for (int i = 0; i < 5; ++i) large[std::to_string(i) + ".csv"] = std::string(15 << 20, ' ');
  writeZip("large.zip", large);
  EXPECT_THAT(toss({"large.zip"}).error, HasSubstr("large.zip: more than 64 tables or 64 MiB"));
}

TEST_F(RecordingFiles, AreJudgedWithWhatWasLeftOut) {
  Files files = phyphoxExport();
  files["Gyroscope.csv"] += "3.0,NaN,NaN,NaN\n";
  writeZip("phyphox.zip", files);
  const ChildResult result = runWithoutGraphics(
      {"judge", "phyphox.zip", "--inertia", "0.315,0.726,1", "--from", "1.25", "--to", "1.95"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_MESSAGE(result.error);
}

}  // namespace
}  // namespace rotatebook::cli::testing

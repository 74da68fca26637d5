#include "system/portable_folder.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rotatebook::system {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// A folder with a program, and a host, both in a folder of the running test.
class PortableFolder : public ::testing::Test {
 protected:
  PortableFolder() {
    fs::remove_all(root_);
    write(program_);
    write(folder_ / "share/rotatebook/portable");
    write(host_ / "etc/fonts/fonts.conf");
  }

  static void write(const fs::path& path) {
    fs::create_directories(path.parent_path());
    std::ofstream(path) << "x";
  }

  /// Returns the lines that portableVariables() has for the environment.
  std::vector<std::string> lines() const {
    std::vector<std::string> lines;
    for (const Variable& one : portableVariables(program_, host_)) lines.push_back(one.text());
    return lines;
  }

  const fs::path root_ = fs::path(ROTATEBOOK_TEST_OUTPUT) / "portable_folder" /
                         ::testing::UnitTest::GetInstance()->current_test_info()->name();
  const fs::path folder_ = root_ / "folder";
  const fs::path host_ = root_ / "host";
  const fs::path program_ = folder_ / "bin/rotatebook";
  const std::string drivers_ = "LIBGL_DRIVERS_PATH=" + (folder_ / "lib/dri").string();
  const std::string mesa_ = (folder_ / "share/glvnd/egl_vendor.d/50_mesa.json").string();
};

TEST_F(PortableFolder, HasDriversOfItsOwn) {
  EXPECT_THAT(lines(), ElementsAre(drivers_, "__EGL_VENDOR_LIBRARY_FILENAMES=" + mesa_));
}

TEST_F(PortableFolder, IsKnownByItsMarker) {
  fs::remove(folder_ / "share/rotatebook/portable");
  write(folder_ / "lib/dri/swrast_dri.so");
  EXPECT_THAT(lines(), IsEmpty());
  EXPECT_THAT(portableVariables(), IsEmpty()) << "this test isn't in such a folder";
  EXPECT_THAT(portableVariables("rotatebook"), IsEmpty());
}

TEST_F(PortableFolder, BringsAConfigurationOfFontsWhereThereIsNone) {
  fs::remove(host_ / "etc/fonts/fonts.conf");
  EXPECT_THAT(lines(),
              ElementsAre(drivers_, "__EGL_VENDOR_LIBRARY_FILENAMES=" + mesa_,
                          "FONTCONFIG_FILE=" + (folder_ / "etc/fonts/fonts.conf").string()));
}

TEST_F(PortableFolder, LetsTheDriverOfAnNvidiaCardIn) {
  for (const std::string place : {"usr/share", "etc"}) {
    const fs::path vendors = host_ / place / "glvnd/egl_vendor.d";
    write(vendors / "50_mesa.json");
    write(vendors / "10_nvidia.json");
    EXPECT_EQ(lines().at(1), "__EGL_VENDOR_LIBRARY_FILENAMES=" +
                                 (vendors / "10_nvidia.json").string() + ':' + mesa_)
        << "one, and libEGL looks into etc first";
  }
}

/// Has a copy of this test, in `folder`/bin, print the values of two variables; returns them.
std::string printedIn(const fs::path& folder, const std::string& environment) {
  const fs::path copy = folder / "bin/test", output = folder / "output";
  fs::copy_file("/proc/self/exe", copy, fs::copy_options::overwrite_existing);
  const std::string command =
      "env -u LIBGL_DRIVERS_PATH -u __EGL_VENDOR_LIBRARY_FILENAMES " + environment +
      " GTEST_ALSO_RUN_DISABLED_TESTS=1 '" + copy.string() +
      "' --gtest_filter='*DISABLED_PrintsItsVariables' | sed -n 's/^> //p' > '" + output.string() +
      "'";
  EXPECT_EQ(std::system(command.c_str()), 0);
  std::ifstream file(output);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(PortableProgram, DISABLED_PrintsItsVariables) {
  usePortableFolder();
  for (const char* name : {"LIBGL_DRIVERS_PATH", "__EGL_VENDOR_LIBRARY_FILENAMES"}) {
    const char* value = std::getenv(name);
    std::printf("> %s\n", value == nullptr ? "unset" : value);
  }
}

TEST_F(PortableFolder, IsUsedWhereTheUserHasNotSetWhatElseToUse) {
  const fs::path real = fs::canonical(folder_);
  const std::string drivers = (real / "lib/dri").string() + '\n';
  const std::string set = printedIn(folder_, "");
  EXPECT_TRUE(set.starts_with(drivers)) << set;
  EXPECT_TRUE(set.ends_with((real / "share/glvnd/egl_vendor.d/50_mesa.json").string() + '\n'))
      << set;
  EXPECT_EQ(printedIn(folder_, "LIBGL_DRIVERS_PATH=/a __EGL_VENDOR_LIBRARY_FILENAMES=/b"),
            "/a\n/b\n");
  EXPECT_EQ(printedIn(folder_, "__EGL_VENDOR_LIBRARY_DIRS=/c"), drivers + "unset\n");
}

}  // namespace
}  // namespace rotatebook::system

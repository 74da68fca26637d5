// From the ways in which machines fail to what is said of them.
#include "diagnose/remedies.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rotatebook::diagnose {

void PrintTo(const Problem& problem, std::ostream* stream) {
  *stream << problem.what << "\n  remedy: " << problem.remedy;
}

namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::IsSupersetOf;
using ::testing::Not;
using ::testing::Optional;
using ::testing::StartsWith;

const render::CallFailure kNotReady{"eglInitialize", "EGL_NOT_INITIALIZED"};
const VendorFile kMesa{"/usr/share/glvnd/egl_vendor.d/50_mesa.json", "libEGL_mesa.so.0"};
const VendorFile kNvidia{"/usr/share/glvnd/egl_vendor.d/10_nvidia.json", "libEGL_nvidia.so.0"};
const DeviceNode kCard{"/dev/nvidia0", "root"};

auto says(const std::string& what, const std::string& remedy) {
  return AllOf(Field(&Problem::what, HasSubstr(what)), Field(&Problem::remedy, HasSubstr(remedy)));
}

DisplayCheck drawing(render::DisplayCandidate candidate, bool software) {
  candidate.software = software;
  return {.candidate = candidate, .renderer = software ? "llvmpipe" : "Card", .software = software};
}

DisplayCheck failing(const render::DisplayCandidate& candidate,
                     const render::CallFailure& failure) {
  return {.candidate = candidate, .failure = failure};
}

/// Returns the check of a machine on which llvmpipe draws.
GraphicsCheck softwareCheck() {
  return {.candidates = {drawing({}, true)}, .byDefault = 0};
}

/// A card that fails, then llvmpipe.
GraphicsCheck brokenCard(const render::DisplayCandidate& card,
                         const render::CallFailure& failure = kNotReady) {
  return {.candidates = {failing(card, failure), drawing({.index = 1}, true)}, .byDefault = 1};
}

GraphicsCheck nothingDraws() {
  return {.candidates = {failing({.kind = render::DisplayCandidate::Kind::Default},
                                 {"eglGetDisplay", "EGL_BAD_PARAMETER"})}};
}

TEST(Remedies, AreNoneWhereThereIsNothingToFix) {
  EXPECT_THAT(diagnose(softwareCheck(), {.vendorFiles = {kMesa}}), IsEmpty());
  GraphicsCheck check = softwareCheck();
  check.candidates.push_back(failing({.kind = render::DisplayCandidate::Kind::Default},
                                     {"eglGetDisplay", "EGL_BAD_PARAMETER"}));
  EXPECT_THAT(diagnose(check, {.vendorFiles = {kMesa}}), IsEmpty());
}

TEST(Remedies, NameTheMissingLibrary) {
  const std::string lost = ": cannot open shared object file: No such file or directory";
  EXPECT_THAT(diagnose({.library = render::CallFailure{"dlopen", "libEGL.so.1" + lost}}, {}),
              ElementsAre(says("dlopen: libEGL.so.1", "apt-get install libegl1 ")));
  EXPECT_THAT(diagnose({.library = render::CallFailure{"dlopen", "libGL.so.1" + lost}}, {}),
              ElementsAre(says("dlopen: libGL.so.1", "apt-get install libopengl0")));
}

TEST(Remedies, UnsetTheVariableThatHidesTheDrivers) {
  const GraphicsFacts facts{.vendorFiles = {{"/nonexistent", "", "isn't there"}},
                            .vendorVariable = "__EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent"};
  EXPECT_THAT(diagnose(nothingDraws(), facts),
              ElementsAre(says("__EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent names no EGL driver",
                               "unset __EGL_VENDOR_LIBRARY_FILENAMES")));
}

TEST(Remedies, InstallMesaWhereItsLibraryIsMissing) {
  VendorFile mesa = kMesa;
  mesa.failure = "libEGL_mesa.so.0: cannot open shared object file";
  EXPECT_THAT(diagnose(nothingDraws(), {.vendorFiles = {mesa}}),
              ElementsAre(says("50_mesa.json: libEGL_mesa.so.0: cannot open", "libegl-mesa0")));
  EXPECT_THAT(diagnose(nothingDraws(), {}),
              ElementsAre(says("no EGL driver is installed", "libegl-mesa0")));
}

TEST(Remedies, MakeTheVendorFileThatNvidiaLacks) {
  const GraphicsFacts facts{.vendorFiles = {kMesa}, .nodes = {kCard}, .nvidiaLibrary = true};
  EXPECT_THAT(diagnose(softwareCheck(), facts),
              ElementsAre(says("EGL doesn't list it: no vendor file names libEGL_nvidia.so.0",
                               "> /usr/share/glvnd/egl_vendor.d/10_nvidia.json")));
}

TEST(Remedies, GiveAContainerItsGraphics) {
  GraphicsFacts facts{.vendorFiles = {kMesa},
                      .nodes = {kCard},
                      .container = true,
                      .nvidiaCapabilities = "compute,utility"};
  EXPECT_THAT(diagnose(softwareCheck(), facts),
              ElementsAre(says("NVIDIA_DRIVER_CAPABILITIES is compute,utility",
                               "NVIDIA_DRIVER_CAPABILITIES=all")));
  facts.nvidiaCapabilities = "all";
  EXPECT_THAT(diagnose(softwareCheck(), facts),
              ElementsAre(says("libEGL_nvidia.so.0 can't be loaded", "libegl-nvidia0")));
}

TEST(Remedies, InstallOrRemoveWhatAVendorFileNames) {
  VendorFile nvidia = kNvidia;
  nvidia.failure = "libEGL_nvidia.so.0: cannot open shared object file";
  EXPECT_THAT(diagnose(softwareCheck(), {.vendorFiles = {nvidia, kMesa}}),
              ElementsAre(says("10_nvidia.json: libEGL_nvidia.so.0: cannot open",
                               "there is no NVIDIA card: remove ")));
  GraphicsFacts facts{.vendorFiles = {nvidia, kMesa}, .nodes = {kCard}};
  EXPECT_THAT(diagnose(softwareCheck(), facts), ElementsAre(says("cannot open", "libegl-nvidia0")));
  facts.container = true;
  EXPECT_THAT(diagnose(softwareCheck(), facts),
              ElementsAre(says("cannot open", "NVIDIA_DRIVER_CAPABILITIES=all")));
  const VendorFile other{"/etc/x.json", "libEGL_x.so", "libEGL_x.so: cannot open"};
  EXPECT_THAT(diagnose(softwareCheck(), {.vendorFiles = {other, kMesa}}),
              ElementsAre(says("/etc/x.json: ", "install libEGL_x.so, or remove /etc/x.json")));
}

TEST(Remedies, AskForNvidiasOwnNodes) {
  GraphicsFacts facts{.vendorFiles = {kNvidia, kMesa}, .nodes = {kCard}, .nvidiaLibrary = true};
  EXPECT_THAT(diagnose(softwareCheck(), facts),
              ElementsAre(says("doesn't list it, though its library is there", "libegl-nvidia0")));
  facts.nodes[0].permitted = false;
  EXPECT_THAT(diagnose(softwareCheck(), facts),
              ElementsAre(says("doesn't list it: no permission on /dev/nvidia0",
                               "let this user read and write /dev/nvidia0")));
}

TEST(Remedies, JoinTheGroupOfANodeWithoutPermission) {
  const GraphicsFacts facts{.vendorFiles = {kMesa},
                            .nodes = {{"/dev/dri/renderD128", "render", false}}};
  EXPECT_THAT(diagnose(brokenCard({.renderNode = "/dev/dri/renderD128"}), facts),
              ElementsAre(says("EGL device 0 (/dev/dri/renderD128): eglInitialize: "
                               "EGL_NOT_INITIALIZED: no permission on /dev/dri/renderD128",
                               "sudo usermod -aG render $USER")));
  EXPECT_THAT(diagnose(softwareCheck(), facts),
              ElementsAre(says("a graphics card isn't used: no permission on", "group render")));
}

TEST(Remedies, BlameNoNodeOfAnotherDevice) {
  const GraphicsFacts facts{
      .vendorFiles = {kMesa},
      .nodes = {{"/dev/dri/renderD128", "render", true}, {"/dev/dri/renderD129", "render", false}}};
  EXPECT_THAT(diagnose(brokenCard({.renderNode = "/dev/dri/renderD128"}), facts),
              ElementsAre(says("EGL device 0 ", "install Mesa's drivers")));
}

TEST(Remedies, NameNvidiasNodesToo) {
  GraphicsFacts facts{.vendorFiles = {kNvidia, kMesa}, .nodes = {kCard}, .nvidiaLibrary = true};
  facts.nodes[0].permitted = false;
  EXPECT_THAT(diagnose(brokenCard({.nvidia = true}), facts),
              ElementsAre(says("no permission on /dev/nvidia0", "/dev/nvidia0")));
  facts.nodes[0].permitted = true;
  EXPECT_THAT(diagnose(brokenCard({.nvidia = true}), facts),
              ElementsAre(says("eglInitialize: EGL_NOT_INITIALIZED", "kernel driver's version")));
}

TEST(Remedies, ExplainTheDeviceListThatFails) {
  GraphicsCheck check = softwareCheck();
  check.devices = {"eglQueryDevicesEXT", "EGL_BAD_ALLOC"};
  GraphicsFacts facts{.vendorFiles = {kNvidia, kMesa}, .nvidiaLibrary = true};
  EXPECT_THAT(diagnose(check, facts),
              ElementsAre(says("eglQueryDevicesEXT: EGL_BAD_ALLOC, as where NVIDIA's EGL library "
                               "is installed without its card",
                               "10_nvidia.json")));
  facts.container = true;
  EXPECT_THAT(diagnose(check, facts), ElementsAre(says("EGL_BAD_ALLOC", "--gpus all")));
  check.candidates.clear();
  check.byDefault.reset();
  EXPECT_THAT(diagnose(check, {.vendorFiles = {kMesa}}),
              ElementsAre(says("eglQueryDevicesEXT: EGL_BAD_ALLOC", "libegl-mesa0")));
}

TEST(Remedies, UpdateADriverThatIsTooOld) {
  const render::CallFailure old{"eglCreateContext for OpenGL 3.3 core", "EGL_BAD_MATCH"};
  EXPECT_THAT(
      diagnose(brokenCard({.renderNode = "/dev/dri/renderD128"}, old), {.vendorFiles = {kMesa}}),
      ElementsAre(says("OpenGL 3.3 core: EGL_BAD_MATCH", "update the card's driver")));
}

TEST(Remedies, UpdateADriverThatEndsTheProcess) {
  GraphicsCheck check = brokenCard({}, {"its driver", "ends the process (Segmentation fault)"});
  check.candidates[0].ends = true;
  check.byDefault.reset();
  EXPECT_THAT(diagnose(check, {.vendorFiles = {kMesa}}),
              ElementsAre(says("EGL device 0: its driver: ends the process (Segmentation fault)",
                               "until then --device software")));
}

TEST(Remedies, ReportAWrongReferencePicture) {
  GraphicsCheck check = softwareCheck();
  check.candidates[0].reference.comparison.same = false;
  EXPECT_THAT(diagnose(check, {.vendorFiles = {kMesa}}),
              ElementsAre(says("llvmpipe: the reference picture isn't drawn as it should be",
                               "update Mesa")));
  check.candidates[0].software = false;
  EXPECT_THAT(diagnose(check, {.vendorFiles = {kMesa}}),
              ElementsAre(says("the reference picture isn't", "until then --device software")));
}

TEST(Remedies, BeginWithVariablesThatMayBeTheCause) {
  const GraphicsFacts facts{.vendorFiles = {kMesa},
                            .mesaVariables = {"GALLIUM_NOOP=1", "LIBGL_DRIVERS_PATH=/x=y"}};
  const std::string unset =
      "unset GALLIUM_NOOP (it is 1), LIBGL_DRIVERS_PATH (it is /x=y); if that doesn't help: ";
  EXPECT_THAT(diagnose(softwareCheck(), facts), IsEmpty());
  GraphicsCheck check = softwareCheck();
  check.candidates[0].reference.comparison.same = false;
  EXPECT_THAT(diagnose(check, facts),
              ElementsAre(says("the reference picture", unset + "update Mesa")));
  check.candidates[0] = failing({.software = true}, kNotReady);
  EXPECT_THAT(diagnose(check, facts), ElementsAre(says("EGL_NOT_INIT", unset + "install Mesa's")));
  EXPECT_THAT(diagnose(nothingDraws(), facts),
              ElementsAre(says("eglGetDisplay", unset + "Install Mesa's")));
  check = {.devices = render::CallFailure{"eglQueryDevicesEXT", "EGL_BAD_ALLOC"}};
  EXPECT_THAT(diagnose(check, facts), ElementsAre(says("EGL_BAD_ALLOC", unset + "install")));
}

TEST(Remedies, BlameNoVariableOfMesaForNvidia) {
  const GraphicsFacts facts{.vendorFiles = {kNvidia, kMesa},
                            .mesaVariables = {"MESA_DEBUG=1"},
                            .nodes = {kCard},
                            .nvidiaLibrary = true};
  EXPECT_THAT(
      diagnose(brokenCard({.nvidia = true}), facts),
      ElementsAre(Field(&Problem::remedy, StartsWith("install the EGL library of NVIDIA"))));
}

DisplayCheck ending(const render::DisplayCandidate& candidate) {
  DisplayCheck check = failing(candidate, {"its driver", "ends the process (Segmentation fault)"});
  check.ends = true;
  return check;
}

// A crash of a render comes from the driver only if the render used the one that ends a process.
TEST(Remedies, ExplainACrashByTheDriverThatWasUsed) {
  using Kind = render::DeviceChoice::Kind;
  const GraphicsCheck check{
      .candidates = {failing({}, kNotReady), ending({.index = 1}), drawing({.index = 2}, true)}};
  const auto explained = [&](const render::DeviceChoice& choice) {
    return diagnoseCrash(check, {.vendorFiles = {kMesa}}, choice);
  };
  for (const render::DeviceChoice& choice :
       {render::DeviceChoice{}, {.kind = Kind::Index, .number = 1}, {.requireHardware = true}}) {
    EXPECT_THAT(explained(choice), Optional(says("EGL device 1: its driver: ends the process (Seg",
                                                 "update the card's driver; until then --device")));
  }
  EXPECT_EQ(explained({.kind = Kind::Software}), std::nullopt);
  EXPECT_EQ(explained({.kind = Kind::Index, .number = 0}), std::nullopt);
  EXPECT_EQ(explained({.kind = Kind::Index, .number = 7}), std::nullopt);
  EXPECT_EQ(diagnoseCrash(softwareCheck(), {}, {}), std::nullopt);
}

TEST(Remedies, RaiseTheLimitsThatMayEndTheProcess) {
  const GraphicsFacts facts{.memoryLimits = {"ulimit -d (it is 100000 kB)"}};
  EXPECT_THAT(diagnoseCrash({.candidates = {ending({.software = true})}}, facts, {}),
              Optional(says("EGL device 0",
                            "raise ulimit -d (it is 100000 kB); if that doesn't help: update")));
}

// Unsets variables that must not stay set for the rest of the tests.
class GraphicsFactsOf : public ::testing::Test {
 protected:
  ~GraphicsFactsOf() override {
    unsetenv("GALLIUM_OF_TEST");
    unsetenv("MESA_OF_TEST");
    unsetenv("NOT_MESA_OF_TEST");
    unsetenv("__EGL_VENDOR_LIBRARY_FILENAMES");
  }
};

TEST_F(GraphicsFactsOf, VariablesAreThoseOfMesa) {
  setenv("MESA_OF_TEST", "a=b", 1);
  setenv("GALLIUM_OF_TEST", "", 1);
  setenv("NOT_MESA_OF_TEST", "1", 1);
  const std::vector<std::string> found = readGraphicsFacts().mesaVariables;
  EXPECT_THAT(found, IsSupersetOf({"GALLIUM_OF_TEST=", "MESA_OF_TEST=a=b"}));
  EXPECT_THAT(found, Not(Contains(HasSubstr("NOT_MESA"))));
}

TEST_F(GraphicsFactsOf, VendorFilesAreReadAsJson) {
  const std::string library = "/nowhere/libEGL_\\u006desa.so";  // JSON's escape of an m
  const auto libraryIn = [](const std::string& text) {
    const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "vendor.json";
    std::ofstream(file) << text;
    setenv("__EGL_VENDOR_LIBRARY_FILENAMES", file.c_str(), 1);
    return readGraphicsFacts().vendorFiles.at(0);
  };
  const VendorFile found = libraryIn(R"({"ICD": {"library_path": ")" + library + "\"}}");
  EXPECT_EQ(found.library, "/nowhere/libEGL_mesa.so");
  EXPECT_THAT(found.failure, HasSubstr("libEGL_mesa.so"));
  for (const char* wrong :
       {"{\"ICD\": {\"library_path\": 1}}", "{\"library_path\": \"a.so\"}", "[1", "1"})
    EXPECT_EQ(libraryIn(wrong).failure, "names no library") << wrong;
}

TEST(Remedies, AreNeverNoneWhereNothingDraws) {
  EXPECT_THAT(diagnose(nothingDraws(), {.vendorFiles = {kMesa}}),
              ElementsAre(says("default EGL display: eglGetDisplay: EGL_BAD_PARAMETER",
                               "libgl1-mesa-dri")));
}

}  // namespace
}  // namespace rotatebook::diagnose

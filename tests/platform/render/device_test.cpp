// Choosing among renderers that a machine might have.
#include "render/device/device.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"

namespace rotatebook::render {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

const std::string kLlvmpipe = "llvmpipe (LLVM 15.0.6, 256 bits)";
const CallFailure kNotInitialized{"eglInitialize", "EGL_NOT_INITIALIZED"};

using Kind = DeviceChoice::Kind;

DisplayCandidate nvidia(int index, int cudaId) {
  return {.index = index,
          .nvidia = true,
          .renderNode = "/dev/dri/renderD" + std::to_string(128 + index),
          .cudaId = cudaId};
}

DisplayCandidate software(int index) {
  return {.index = index, .software = true};
}

const DisplayCandidate kSurfaceless{.kind = DisplayCandidate::Kind::Surfaceless};
const DisplayCandidate kDefault{.kind = DisplayCandidate::Kind::Default};

/// Display candidates, and what trying each gives.
struct Machine {
  DisplayCandidates list;
  std::vector<Attempt> attempts;

  void add(const DisplayCandidate& candidate, const Attempt& attempt) {
    list.candidates.push_back(candidate);
    attempts.push_back(attempt);
  }
};

/// Two cards whose numbers are the other way round in CUDA, then software.
Machine twoCards() {
  Machine machine;
  machine.add(nvidia(0, 1), {.renderer = "Card A"});
  machine.add(nvidia(1, 0), {.renderer = "Card B"});
  machine.add(software(2), {.renderer = kLlvmpipe});
  machine.add(kSurfaceless, {.renderer = "Card A"});
  machine.add(kDefault, {.failure = CallFailure{"eglGetDisplay", "EGL_BAD_PARAMETER"}});
  return machine;
}

Machine brokenCard() {
  Machine machine;
  machine.add(nvidia(0, 0), {.failure = kNotInitialized});
  machine.add(software(1), {.renderer = kLlvmpipe});
  return machine;
}

Machine softwareAlone() {
  Machine machine;
  machine.add(software(0), {.renderer = kLlvmpipe});
  machine.add(kSurfaceless, {.renderer = kLlvmpipe});
  return machine;
}

/// As where NVIDIA's library is installed without its card.
Machine devicesFail() {
  Machine machine;
  machine.list.failure = {"eglQueryDevicesEXT", "EGL_BAD_ALLOC"};
  machine.add(kSurfaceless, {.renderer = kLlvmpipe});
  machine.add(kDefault, {.renderer = kLlvmpipe});
  return machine;
}

/// The chosen candidate, and the candidates that were tried.
struct Outcome {
  ChosenDisplay chosen;
  std::vector<std::size_t> tried;
};

Outcome choose(const Machine& machine, const DeviceChoice& choice) {
  Outcome outcome;
  outcome.chosen = chooseDisplay(machine.list, choice, [&](std::size_t candidate) {
    outcome.tried.push_back(candidate);
    return machine.attempts[candidate];
  });
  return outcome;
}

/// Why nothing is chosen.
template <typename Kind>
std::string refusal(const Machine& machine, const DeviceChoice& choice) {
  try {
    return "chosen: " + std::to_string(choose(machine, choice).chosen.candidate);
  } catch (const Kind& error) {
    return error.what();
  }
}

TEST(DeviceChoice, IsTheFirstThatDrawsUnlessAskedOtherwise) {
  const Outcome outcome = choose(twoCards(), {});
  EXPECT_EQ(outcome.chosen.candidate, 0U);
  EXPECT_THAT(outcome.tried, ElementsAre(0U));
  EXPECT_THAT(outcome.chosen.warning, IsEmpty());
}

TEST(DeviceChoice, TakesTheNumbersOfEglOrOfCuda) {
  EXPECT_EQ(choose(twoCards(), {.kind = Kind::Index, .number = 1}).chosen.candidate, 1U);
  EXPECT_EQ(choose(twoCards(), {.kind = Kind::Cuda, .number = 1}).chosen.candidate, 0U);
  EXPECT_EQ(choose(twoCards(), {.kind = Kind::Cuda, .number = 0}).chosen.candidate, 1U);
}

TEST(DeviceChoice, SoftwareNeverOpensACard) {
  const Outcome outcome = choose(twoCards(), {.kind = Kind::Software});
  EXPECT_EQ(outcome.chosen.candidate, 2U);
  EXPECT_THAT(outcome.tried, ElementsAre(2U));
}

TEST(DeviceChoice, SoftwareIsFoundWhereDevicesAreNotListed) {
  EXPECT_EQ(choose(devicesFail(), {.kind = Kind::Software}).chosen.candidate, 0U);
  Machine cardBehind = devicesFail();
  cardBehind.attempts[0] = {.renderer = "Card A"};
  EXPECT_EQ(choose(cardBehind, {.kind = Kind::Software}).chosen.candidate, 1U);
  cardBehind.attempts[1] = {.renderer = "Card A"};
  EXPECT_THAT(refusal<MachineError>(cardBehind, {.kind = Kind::Software}),
              AllOf(HasSubstr("can't draw: no software renderer gives"),
                    HasSubstr("\n  surfaceless EGL: Card A, hardware\n"),
                    HasSubstr("libgl1-mesa-dri"), HasSubstr("rotatebook doctor")));
}

TEST(DeviceChoice, GoesOnWhereDevicesAreNotListed) {
  const Outcome outcome = choose(devicesFail(), {});
  EXPECT_EQ(outcome.chosen.candidate, 0U);
  EXPECT_THAT(outcome.chosen.warning, IsEmpty());
}

TEST(DeviceChoice, ReportsThatSoftwareDrawsInPlaceOfHardware) {
  const Outcome outcome = choose(brokenCard(), {});
  EXPECT_EQ(outcome.chosen.candidate, 1U);
  EXPECT_EQ(outcome.chosen.warning,
            "software draws (" + kLlvmpipe +
                ") in place of hardware: EGL device 0 (/dev/dri/renderD128, cuda:0): "
                "eglInitialize: EGL_NOT_INITIALIZED; run 'rotatebook doctor' for the remedy");
  Machine unlisted = softwareAlone();
  unlisted.list.unlistedCard = "NVIDIA's card (/dev/nvidia0)";
  EXPECT_THAT(choose(unlisted, {}).chosen.warning,
              HasSubstr("in place of hardware: EGL doesn't list NVIDIA's card (/dev/nvidia0);"));
}

TEST(DeviceChoice, ReportsNothingWhereSoftwareIsAllThereIsOrWasAskedFor) {
  EXPECT_THAT(choose(softwareAlone(), {}).chosen.warning, IsEmpty());
  EXPECT_THAT(choose(brokenCard(), {.kind = Kind::Software}).chosen.warning, IsEmpty());
  EXPECT_THAT(choose(brokenCard(), {.kind = Kind::Index, .number = 1}).chosen.warning, IsEmpty());
}

TEST(DeviceChoice, ReportsNothingWhereAnotherCardDraws) {
  Machine machine = twoCards();
  machine.attempts[0] = {.failure = kNotInitialized};
  const Outcome outcome = choose(machine, {});
  EXPECT_EQ(outcome.chosen.candidate, 1U);
  EXPECT_THAT(outcome.chosen.warning, IsEmpty());
}

TEST(DeviceChoice, RefusesADeviceThatIsNotThereAndNamesThoseThatAre) {
  EXPECT_EQ(refusal<InputError>(twoCards(), {.kind = Kind::Index, .number = 3}),
            "can't draw: there is no EGL device 3\n"
            "  There are:\n"
            "  EGL device 0 (/dev/dri/renderD128, cuda:1)\n"
            "  EGL device 1 (/dev/dri/renderD129, cuda:0)\n"
            "  EGL device 2 (software)");
  EXPECT_THAT(refusal<InputError>(softwareAlone(), {.kind = Kind::Cuda, .number = 0}),
              AllOf(HasSubstr("there is no EGL device with the CUDA id 0\n"),
                    HasSubstr("  EGL device 0 (software)")));
}

TEST(DeviceChoice, IsTheMachinesFailureWhereNoDeviceIsListed) {
  EXPECT_THAT(refusal<MachineError>(devicesFail(), {.kind = Kind::Index}),
              AllOf(HasSubstr("there is no EGL device 0:"),
                    HasSubstr("\n  EGL devices: eglQueryDevicesEXT: EGL_BAD_ALLOC\n"),
                    HasSubstr("rotatebook doctor")));
}

TEST(DeviceChoice, TakesNoOtherInTheFailedDevicesPlace) {
  for (const Kind kind : {Kind::Index, Kind::Cuda}) {
    EXPECT_THAT(refusal<MachineError>(brokenCard(), {.kind = kind}),
                AllOf(HasSubstr("\n  EGL device 0 (/dev/dri/renderD128, cuda:0): eglInitialize: "
                                "EGL_NOT_INITIALIZED\n"),
                      HasSubstr("\n  There are:\n"), HasSubstr("\n  EGL device 1 (software)\n")));
  }
}

TEST(DeviceChoice, RequiringHardwareRefusesSoftware) {
  const DeviceChoice hardware{.requireHardware = true};
  EXPECT_THAT(refusal<MachineError>(softwareAlone(), hardware),
              AllOf(HasSubstr("can't draw: no EGL display draws in hardware, which is required:"),
                    HasSubstr("\n  EGL device 0 (software): software\n"),
                    HasSubstr("\n  surfaceless EGL: " + kLlvmpipe + ", software\n"),
                    HasSubstr("\n  Run 'rotatebook doctor'"), Not(HasSubstr("apt-get"))));
  EXPECT_THAT(refusal<MachineError>(brokenCard(), hardware), HasSubstr("EGL_NOT_INITIALIZED"));
  EXPECT_THAT(refusal<MachineError>(twoCards(),
                                    {.kind = Kind::Index, .number = 2, .requireHardware = true}),
              HasSubstr("EGL device 2 (software): software"));
  EXPECT_EQ(choose(twoCards(), hardware).chosen.candidate, 0U);
}

TEST(DeviceChoice, RequiringHardwareSkipsSoftwareThatComesFirst) {
  Machine machine;
  machine.add(software(0), {.renderer = kLlvmpipe});
  machine.add(nvidia(1, 0), {.renderer = "Card A"});
  EXPECT_EQ(choose(machine, {}).chosen.candidate, 0U);
  const Outcome outcome = choose(machine, {.requireHardware = true});
  EXPECT_THAT(outcome.tried, ElementsAre(1U));
}

TEST(SoftwareRenderer, IsKnownByItsName) {
  for (const char* name : {"llvmpipe (LLVM 15.0.6, 256 bits)", "softpipe", "Mesa swrast",
                           "Software Rasterizer", "Google SwiftShader"}) {
    EXPECT_TRUE(isSoftwareRenderer(name)) << name;
  }
  for (const char* name : {"NVIDIA H200/PCIe/SSE2", "Mesa Intel(R) UHD Graphics", "zink", ""}) {
    EXPECT_FALSE(isSoftwareRenderer(name)) << name;
  }
}

}  // namespace
}  // namespace rotatebook::render

#include "cli/device_options.h"

#include <algorithm>
#include <iostream>
#include <iterator>
#include <memory>
#include <mutex>
#include <regex>
#include <unistd.h>
#include <utility>

#include <fmt/ostream.h>

#include "base/error.h"
#include "cli/commands.h"
#include "cli/crash_handler.h"
#include "cli/terminal.h"
#include "system/crash_successor.h"

namespace rotatebook::cli {
namespace {

using Kind = picture::DeviceChoice::Kind;

picture::DeviceChoice parseDevice(const std::string& text) {
  if (text.empty()) return {};
  if (text == "software") return {.kind = Kind::Software};
  std::smatch match;
  if (!std::regex_match(text, match, std::regex("(cuda:)?([0-9]{1,4})"))) {
    throw InputError(
        fmt::format("--device {}: not a device; write a number that 'rotatebook doctor' "
                    "lists, for example 0, or cuda:0, or software",
                    text));
  }
  return {.kind = match[1].matched ? Kind::Cuda : Kind::Index, .number = std::stoi(match[2])};
}

/// Prints `line` to the standard error, in one piece, over a progress bar that may be there.
void printAside(const std::string& line) {
  const std::string erase = terminalColumns(STDERR_FILENO) > 0 ? "\r\x1b[K" : "";
  fmt::print(std::cerr, "{}rotatebook: {}\n", erase, line);
}

}  // namespace

void DeviceOptions::addTo(CLI::App& command) {
  constexpr const char* kGroup = "Device";
  addOption(command, "--device", "N|cuda:N|software", device,
            "Device that draws: the number of an EGL device ('rotatebook doctor' lists them), "
            "a CUDA id, or software; by default the first that works",
            kGroup);
  command
      .add_flag("--require-hardware", requireHardware, "Fail if only a software renderer can draw")
      ->group(kGroup);
}

std::vector<std::string> DeviceOptions::words() const {
  std::vector<std::string> words;
  if (!device.empty()) words = {"--device", device};
  if (requireHardware) words.emplace_back("--require-hardware");
  return words;
}

picture::DeviceChoice DeviceOptions::parsed() const {
  picture::DeviceChoice choice = parseDevice(device);
  choice.requireHardware = requireHardware;
  if (requireHardware && choice.kind == Kind::Software) {
    throw InputError("--device software and --require-hardware exclude each other");
  }
  return choice;
}

picture::DeviceChoice DeviceOptions::choice(bool resumable) const {
  picture::DeviceChoice choice = parsed();
  std::vector<std::string> successor{"rotatebook", kAfterCrash};
  std::ranges::move(words(), std::back_inserter(successor));
  successor.push_back(fmt::format("{}={}", kStack, crashStackFile()));
  if (resumable) {
    adviseResume();
    successor.emplace_back(kResumable);
  }
  system::setCrashSuccessor(std::move(successor));
  // A clip may have several renderers, on several threads; one warning is enough.
  choice.warn = [once = std::make_shared<std::once_flag>()](const std::string& line) {
    std::call_once(*once, printAside, line);
  };
  return choice;
}

}  // namespace rotatebook::cli

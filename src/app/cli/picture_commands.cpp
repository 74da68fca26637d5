#include <algorithm>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/ostream.h>

#include "base/error.h"
#include "base/text.h"
#include "cli/commands.h"
#include "cli/device_options.h"
#include "cli/exit_code.h"
#include "cli/input_guard.h"
#include "cli/option_checks.h"
#include "cli/scene_options.h"
#include "cli/terminal.h"
#include "image/comparison.h"
#include "image/png_file.h"
#include "picture/sheet.h"
#include "picture/still.h"
#include "system/program_mark.h"

namespace rotatebook::cli {
namespace {

struct StillArguments {
  std::vector<std::string> scenes;
  SceneOptions sceneOptions;
  DeviceOptions deviceOptions;
  std::optional<double> time;
  std::optional<int> count;
  picture::SheetOptions sheet;
  bool noCaption = false;
  std::string output;

  /// Several pictures are asked for, side by side.
  bool isSheet() const { return count || !sheet.times.empty() || scenes.size() > 1; }
};

void leaveOutCaption(scene::Scene& scene) {
  std::erase_if(scene.overlay.show, [](scene::Overlay overlay) {
    return overlay == scene::Overlay::Caption || overlay == scene::Overlay::Settings;
  });
}

/// Returns the file to write: the one that was named; else NAME.png, of several pictures
/// NAME.sheet.png, and of several scenes sheet.png.
std::string outputOf(const StillArguments& arguments, const std::vector<scene::Scene>& scenes) {
  if (!arguments.output.empty()) return arguments.output;
  if (scenes.size() > 1) return "sheet.png";
  refuseSameNames(scenes);
  return scenes.front().name + (arguments.isSheet() ? ".sheet.png" : ".png");
}

/// Writes a PNG to the file, or to the standard output.
void writePicture(const std::string& output, image::ImageView picture, bool transparent) {
  if (output != kStandardOutput) return image::writePng(output, picture, transparent);
  std::string bytes = image::PngWriter(transparent).encode(picture, "the standard output");
  system::addProgramMark(bytes);
  std::cout << bytes;
}

/// Returns the stream for the report, which isn't the picture's.
std::ostream& reportStream(const std::string& output) {
  return output == kStandardOutput ? std::clog : std::cout;
}

void writeOne(const scene::Scene& scene, const StillArguments& arguments,
              const std::string& output) {
  const auto [frame, picture] =
      picture::drawStill(scene, arguments.time, arguments.deviceOptions.choice());
  writePicture(output, picture.view(), scene::isTransparent(scene));
  fmt::print(reportStream(output), "{}: wrote frame {} to {}\n", scene.name, frame,
             oneLine(output));
}

void writeSheet(const std::vector<scene::Scene>& scenes, const StillArguments& arguments,
                const std::string& output) {
  picture::SheetOptions options = arguments.sheet;
  options.count = arguments.count.value_or(options.count);
  options.device = arguments.deviceOptions.choice();
  const image::Image sheet = picture::drawSheet(scenes, options);
  const bool transparent = std::ranges::any_of(scenes, &scene::isTransparent);
  writePicture(output, sheet.view(), transparent);
  fmt::print(reportStream(output), "wrote {}, {}\n", oneLine(output),
             sizeText(sheet.width(), sheet.height()));
}

int writeStill(const StillArguments& arguments) {
  const bool isSheet = arguments.isSheet();
  if (isSheet && arguments.time)
    throw InputError("--time is of a single picture; --times are of several");
  if (!isSheet && arguments.sheet.columns)
    throw InputError("--columns is of several pictures; add --count, --times or another scene");
  auto [scenes, inputs] = readAllScenes(
      arguments.scenes, [&](const std::string& path) { return arguments.sceneOptions.read(path); });
  if (arguments.noCaption) std::ranges::for_each(scenes, leaveOutCaption);
  const std::string output = outputOf(arguments, scenes);
  output == kStandardOutput ? refuseTerminal("--output -") : requirePictureOutput(output, inputs);
  std::error_code ignored;
  const bool replaces = arguments.output.empty() && std::filesystem::exists(output, ignored);
  isSheet ? writeSheet(scenes, arguments, output) : writeOne(scenes.front(), arguments, output);
  if (replaces) fmt::print(std::cerr, "note: replaced {}\n", oneLine(output));
  return kDone;
}

}  // namespace

void addStillCommand(CLI::App& program, Action& action) {
  constexpr int kMax = 1000;
  auto [command, arguments] = addCommand(
      program, action, "still", "Draw one picture of a scene, or several side by side", writeStill);
  command.add_option("SCENE", arguments.scenes, "Scene files")->required();
  addOption(command, "-o,--output", "FILE", arguments.output,
            "PNG to write, or - for the standard output; by default NAME.png, or NAME.sheet.png of "
            "several pictures, in "
            "the folder where you are");
  addOption(command, "--time", "SECONDS", arguments.time,
            "Time in the video, whose nearest frame is drawn; by default the poster's");
  addOption(command, "--count", "N", arguments.count,
            "Number of frames of each scene, side by side, from its first to its last; 1 "
            "draws its poster")
      ->check(wholeNumber(1, kMax));
  addOption(command, "--times", "SECONDS,...", arguments.sheet.times,
            "Times of the frames in the video, in place of --count")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->excludes("--count");
  addOption(command, "--columns", "N", arguments.sheet.columns, "Pictures in a row")
      ->check(wholeNumber(1, kMax));
  command.add_flag("--no-caption", arguments.noCaption, "Leave the caption out of the pictures");
  arguments.sceneOptions.addTo(command);
  arguments.deviceOptions.addTo(command);
  command.footer(R"(
--size is the size of each picture. Beneath each of several is what tells it apart: its time, its
scene's title, or both. The time is that of the video, as --times and --time take it; where the
motion's is another, in slow motion, that follows as t.

Examples:
  rotatebook still scenes/starter.toml
  rotatebook still scenes/starter.toml --time 2.5 -o book.png --size 1920x1080
  rotatebook still scenes/starter.toml -o sheet.png --times 0,0.5,1 --columns 3
  rotatebook still - -o - < scenes/starter.toml > book.png
  rotatebook still scenes/figures/*.toml -o sheet.png --count 1 --size 480x270)");
}

namespace {

struct DiffArguments {
  std::string first, second, output;
  image::Tolerance tolerance;
};

void printComparison(const image::Comparison& comparison) {
  fmt::print(std::cout,
             "{}: largest difference {} of 255, mean {:.4f}, {} pixels ({:.4f} %) over the bound\n",
             comparison.same ? "same" : "different", comparison.largest, comparison.mean,
             comparison.differingPixels, comparison.differingPercent);
}

int diff(const DiffArguments& arguments) {
  const std::string what = "one of the pictures to compare";
  if (!arguments.output.empty()) {
    requirePictureOutput(arguments.output, {{arguments.first, what}, {arguments.second, what}});
  }
  const image::Image a = image::readPng(arguments.first);
  const image::Image b = image::readPng(arguments.second);
  const image::Comparison comparison = compare(a.view(), b.view(), arguments.tolerance);
  if (!arguments.output.empty()) {
    image::writePng(arguments.output, differenceImage(a.view(), b.view()).view());
  }
  printComparison(comparison);
  return comparison.same ? kDone : kUnmet;
}

}  // namespace

void addDiffCommand(CLI::App& program, Action& action) {
  auto [command, arguments] = addCommand(program, action, "diff", "Compare two pictures", diff);
  command.add_option("A", arguments.first, "PNG")->required()->check(notStandardInput);
  command.add_option("B", arguments.second, "PNG")->required()->check(notStandardInput);
  addOption(command, "--max", "N", arguments.tolerance.largest,
            "A pixel differs if a channel differs by more than this")
      ->check(wholeNumber(0, 255))
      ->capture_default_str();
  addOption(command, "--fail-percent", "P", arguments.tolerance.failPercent,
            "The pictures differ if more than this share of the pixels does")
      ->check(numberWithin(0, 100))
      ->capture_default_str();
  addOption(command, "-o,--output", "FILE", arguments.output,
            "PNG of the differences, 16 times enlarged");
  command.footer(R"(
Exit status: 0 the same within the bounds, 1 different, 2 the pictures can't be compared.

Example:
  rotatebook diff out/a/frame_00000.png out/b/frame_00000.png --max 2 --fail-percent 0.1 -o diff.png)");
}

}  // namespace rotatebook::cli

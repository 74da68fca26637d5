#include <array>
#include <cstdio>
#include <iostream>
#include <memory>
#include <string>

#include "cli/commands.h"
#include "cli/exit_code.h"
#include "cli/input_guard.h"
#include "image/comparison.h"
#include "image/png_file.h"

namespace rotatebook::cli {
namespace {

struct DiffArguments {
  std::string first, second, output;
  image::Tolerance tolerance;
};

void printComparison(const image::Comparison& comparison) {
  std::array<char, 160> text;
  std::snprintf(text.data(), text.size(),
                "%s: largest difference %d of 255, mean %.4f, %lld pixels (%.4f %%) over the bound",
                comparison.same ? "same" : "different", comparison.largest, comparison.mean,
                static_cast<long long>(comparison.differingPixels), comparison.differingPercent);
  std::cout << text.data() << '\n';
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
  auto arguments = std::make_shared<DiffArguments>();
  CLI::App* command = program.add_subcommand("diff", "Compare two pictures");
  command->add_option("A", arguments->first, "PNG")->required();
  command->add_option("B", arguments->second, "PNG")->required();
  command
      ->add_option("--max", arguments->tolerance.largest,
                   "A pixel differs if a channel differs by more than this")
      ->type_name("N")
      ->check(CLI::Range(0, 255))
      ->capture_default_str();
  command
      ->add_option("--fail-percent", arguments->tolerance.failPercent,
                   "The pictures differ if more than this share of the pixels does")
      ->type_name("P")
      ->check(CLI::Range(0.0, 100.0))
      ->capture_default_str();
  command->add_option("-o,--output", arguments->output, "PNG of the differences, 16 times enlarged")
      ->type_name("FILE");
  command->footer(R"(
Exit status: 0 the same within the bounds, 1 different, 2 the pictures can't be compared.

Example:
  rotatebook diff out/a/frame_00000.png out/b/frame_00000.png --max 2 --fail-percent 0.1 -o diff.png)");
  command->callback([arguments, &action] { action = [arguments] { return diff(*arguments); }; });
}

}  // namespace rotatebook::cli

#include <iostream>
#include <memory>
#include <string>

#include "cli/commands.h"
#include "cli/exit_code.h"
#include "diagnose/checkup.h"
#include "diagnose/doctor_report.h"

namespace rotatebook::cli {
namespace {

struct DoctorArguments {
  std::string folder = "out";
  bool json = false;
};

int examine(const DoctorArguments& arguments) {
  const diagnose::Checkup checkup = diagnose::checkUp(arguments.folder);
  (arguments.json ? diagnose::reportCheckupAsJson : diagnose::reportCheckup)(checkup, std::cout);
  return checkup.ready() ? kDone : kMachineFailed;
}

}  // namespace

void addDoctorCommand(CLI::App& program, Action& action) {
  auto arguments = std::make_shared<DoctorArguments>();
  CLI::App* command = program.add_subcommand(
      "doctor", "Check whether this machine can render; if not, report why and what helps");
  command
      ->add_option("-o,--output", arguments->folder,
                   "Folder for the results: its free space is reported, and whether it can be "
                   "written; nothing is left there")
      ->type_name("DIR")
      ->capture_default_str();
  command->add_flag("--json", arguments->json, "Print one JSON object");
  command->footer(R"(
Lists the EGL devices, whose numbers --device takes, and the other EGL displays; draws a small picture
with each and compares it with a stored one. Then checks encoders, font, folder, cores and memory.

Exit status: 0 if render works as it is by default, 3 if it doesn't.

Examples:
  rotatebook doctor
  rotatebook doctor --json | python3 -m json.tool)");
  command->callback([arguments, &action] { action = [arguments] { return examine(*arguments); }; });
}

}  // namespace rotatebook::cli

// Functions that add the commands, one each: they describe the command's options to the parser, and
// set `action` if it is chosen. Inside the room only.
#pragma once

#include <functional>

#include <CLI/CLI.hpp>

namespace rotatebook::cli {

/// The work of the chosen command. Returns the exit status; throws Error.
using Action = std::function<int()>;

void addRenderCommand(CLI::App& program, Action& action);
void addSimulateCommand(CLI::App& program, Action& action);
void addStudyCommand(CLI::App& program, Action& action);
void addMapCommand(CLI::App& program, Action& action);
void addSubmitCommand(CLI::App& program, Action& action);
void addStatusCommand(CLI::App& program, Action& action);
void addPageCommand(CLI::App& program, Action& action);
void addStillCommand(CLI::App& program, Action& action);
void addDiffCommand(CLI::App& program, Action& action);
void addVerifyCommand(CLI::App& program, Action& action);
void addAssembleCommand(CLI::App& program, Action& action);
void addBenchCommand(CLI::App& program, Action& action);
void addDoctorCommand(CLI::App& program, Action& action);
void addCheckCommand(CLI::App& program, Action& action);
void addListCommand(CLI::App& program, Action& action);
void addNewCommand(CLI::App& program, Action& action);
void addInfoCommand(CLI::App& program, Action& action);
void addJudgeCommand(CLI::App& program, Action& action);
void addTossCommand(CLI::App& program, Action& action);
void addHelpCommand(CLI::App& program, Action& action);

/// The name of a command that isn't for users: a process that crashes while it draws becomes it.
inline constexpr const char* kAfterCrash = "after-crash";
inline constexpr const char* kResumable = "--resumable";  ///< Its flag: the other had --resume.
void addAfterCrashCommand(CLI::App& program, Action& action);

}  // namespace rotatebook::cli

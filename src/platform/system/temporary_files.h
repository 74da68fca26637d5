// Names of temporary files, and the removal of those that nobody writes any more.
#pragma once

#include <filesystem>
#include <string>

namespace rotatebook::system {

/// Returns a name of this process that no other process has, on any machine: HOST-BOOT-PID. HOST
/// and BOOT are 8 and 12 hexadecimal digits: checksums of the machine's names, and of its present
/// start and the process's PID namespace.
std::string processName();

/// Returns the name under which this process writes the file at `path` until it is complete, beside
/// it: `.NAME.rotatebook-HOST-BOOT-PID`.
std::filesystem::path temporaryNameFor(const std::filesystem::path& path);

/// Returns the name of the file whose lock marks `path` as in use, `.NAME.rotatebook-0`: the same
/// for all machines.
std::filesystem::path lockNameFor(const std::filesystem::path& path);

/// Returns whether `name` is one that temporaryNameFor() or lockNameFor() gives, on any machine.
bool isTemporaryName(const std::string& name);

/// Removes the temporary files in `folder` whose writers are known to be dead: those of a process
/// of this machine that has ended, or that were last changed before this machine started. Those of
/// other machines, and those that are locked or can't be locked, stay, as do those that can't be
/// removed, which does no harm. Does nothing if there is no such folder.
void removeStaleTemporaries(const std::filesystem::path& folder);

}  // namespace rotatebook::system

// Permissions to move and remove files, asked before they are needed.
#pragma once

#include <filesystem>
#include <string>

namespace rotatebook::system {

/// Returns whether there is something at `path`, be it a link to nothing.
bool isOccupied(const std::filesystem::path& path);

/// Returns whether there is a file at `path`, and no link to one: what is written or removed there
/// is nowhere else.
bool isPlainFile(const std::filesystem::path& path);

/// Returns why this user can't rename or remove what is at `path`: "it belongs to root, ..."; empty
/// if they can, or nothing is there. Asks the folder's permissions, its sticky bit and the owners.
std::string obstacleToRemoval(const std::filesystem::path& path);

/// Returns likewise why this user can't remove the files in `folder`; empty if they can.
std::string obstacleToEmptying(const std::filesystem::path& folder);

/// Returns likewise why this user can't move one of the folders in `folder` to another folder.
std::string obstacleToMovingFolders(const std::filesystem::path& folder);

}  // namespace rotatebook::system

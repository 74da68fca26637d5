// A live book that follows a scene while it is edited. Inside the room only.
#pragma once

#include <filesystem>
#include <string>

#include "base/json.h"
#include "scene/scene.h"

namespace rotatebook::cli {

/// Returns the live book that is installed with the program, or that `make play` made where the
/// program was built. Throws InputError if there is none.
std::filesystem::path installedBook();

/// A page, NAME.live.html, that plays what its script, NAME.live.js, says. It reads the script
/// again and again, as a page from a disk may read nothing else.
class LiveFollower {
 public:
  /// Writes NAME.live.html into `folder`: the page `book`, which `make play` makes, with what
  /// follows. Throws InputError if `book` is none, or if there is another file of one of the names.
  LiveFollower(const std::filesystem::path& book, const std::filesystem::path& folder,
               const std::string& name);

  /// Plays the scene, which was read from `file`. Throws OutputError.
  void play(const scene::Scene& scene, const std::filesystem::path& file) const;
  /// Shows a message over what is played. Throws OutputError.
  void say(const std::string& message) const;

  const std::filesystem::path& page() const { return page_; }

 private:
  void write(const Json& content) const;

  std::filesystem::path page_, script_;
};

}  // namespace rotatebook::cli

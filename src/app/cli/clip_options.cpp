#include "cli/clip_options.h"

#include "base/error.h"
#include "cli/exit_code.h"

namespace rotatebook::cli {

void addClip(CLI::App& command, std::filesystem::path& clip) {
  const std::string kinds =
      listFormats(&video::FormatRow::title, "or", &video::FormatRow::holdsRecord);
  command.add_option("CLIP", clip, kinds + " that rotatebook made")->required();
}

void addTextureOptions(CLI::App& command, store::TextureLookup& textures) {
  command
      .add_option(
          "--scene-folder", textures.folder,
          "Folder with the scene's textures, meshes and recordings; by default the clip's folder, "
          "the one above it, the current one or a folder in these that has them as they were")
      ->type_name("DIR");
  addAllowOutside(command, textures.allowOutside);
}

store::ClipPart partOf(const std::string& text) {
  if (const auto part = store::parsePart(text)) return *part;
  throw InputError("--part " + text +
                   ": not a part; write its number and how many there are, 1/16 " +
                   "to 16/16 for 16 parts");
}

void addRetryStatus(CLI::App& command) {
  command.add_flag_callback("--retry-status", askForRetryStatus,
                            "End with 75 where trying again may help: after a signal, a full disk, "
                            "a lock of another process, a missing device");
}

CLI::Option* addAllowOutside(CLI::App& command, bool& allowOutside) {
  return command.add_flag("--allow-outside", allowOutside,
                          "Let the scene read textures and words from outside its folder");
}

}  // namespace rotatebook::cli

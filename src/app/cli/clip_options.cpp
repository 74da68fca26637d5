#include "cli/clip_options.h"

namespace rotatebook::cli {

void addClip(CLI::App& command, std::filesystem::path& clip) {
  const std::string kinds =
      listFormats(&video::FormatRow::title, "or", &video::FormatRow::holdsRecord);
  command.add_option("CLIP", clip, kinds + " that rotatebook made")->required();
}

void addTextureOptions(CLI::App& command, store::TextureLookup& textures) {
  command
      .add_option("--scene-folder", textures.folder,
                  "Folder with the scene's textures; by default the clip's folder")
      ->type_name("DIR");
  addAllowOutside(command, textures.allowOutside);
}

CLI::Option* addAllowOutside(CLI::App& command, bool& allowOutside) {
  return command.add_flag("--allow-outside", allowOutside,
                          "Let the scene read textures and words from outside its folder");
}

}  // namespace rotatebook::cli

// Making a clip again from its own record. Inside the room only.
#pragma once

#include <filesystem>

#include "cli/device_options.h"
#include "store/clip_record.h"
#include "store/clip_settings.h"

namespace rotatebook::cli {

struct RerunArguments {
  std::filesystem::path clip, folder;
  store::TextureLookup textures;
  bool png = false;
  store::EarlierFrames earlier;
  DeviceOptions deviceOptions;
};

/// Renders the clip again from its record into the folder, and reports whether the new file has the
/// very bytes of the clip; returns the exit status. The clip itself is never replaced, another
/// scene's of its name only with `earlier.overwrite`. Throws Error.
int rerun(const RerunArguments& arguments);

}  // namespace rotatebook::cli

// A scene's pictures on the standard output, for other programs. Inside the room only.
#pragma once

#include <string>
#include <vector>

#include "cli/render_scenes.h"
#include "pipeline/stream_clip.h"

namespace rotatebook::cli {

/// Returns the format that --format names, y4m if it names none. Throws InputError for others than
/// streams have, and for several.
pipeline::StreamFormat streamFormatOf(const std::vector<std::string>& names);

/// Writes the scene's pictures to the standard output, and reports on them on the standard error.
/// Returns the exit status. Throws Error.
int streamScene(const SceneToRender& one, const pipeline::StreamOptions& options);

}  // namespace rotatebook::cli

#include "cli/rerun.h"

#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/text.h"
#include "cli/exit_code.h"
#include "cli/input_guard.h"
#include "cli/interrupt.h"
#include "cli/render_scenes.h"
#include "picture/preflight.h"
#include "store/clip_record.h"
#include "system/file_checksum.h"
#include "system/read_file.h"
#include "video/clip_reader.h"
#include "video/whole_file.h"

namespace rotatebook::cli {
namespace {

namespace fs = std::filesystem;

store::ClipFiles filesOf(const store::RecordedClip& clip, const fs::path& folder) {
  const std::string& name = clip.record.scene.name;
  return clip.record.part ? store::clipFiles(folder, name, *clip.record.part)
                          : store::clipFiles(folder, name);
}

/// Throws InputError if the rerun would replace what another scene's clip of the same name left:
/// its video, or, if `png`, its frames.
void refuseOtherClip(const scene::Scene& scene, const store::ClipFiles& files,
                     const fs::path& output, bool png) {
  const auto refuse = [](const fs::path& file) {
    throw InputError(file.string() +
                     " isn't from the clip's scene and would be lost; name another folder with -o, "
                     "or replace it with --overwrite");
  };
  if (fs::exists(output) && !store::isRecordOf(scene, store::recordIn(output))) refuse(output);
  const fs::path& copy = files.sceneCopy;
  if (png && fs::exists(copy) && !store::isRecordOf(scene, system::readFileOrEmpty(copy)))
    refuse(copy);
}

/// Lists why `clip`, which was made `there`, may have other bytes than the one made `here` from the
/// same record.
std::vector<std::string> reasons(const fs::path& clip, const store::Provenance& there,
                                 const store::Provenance& here) {
  try {
    video::requireWholeFile(clip);
  } catch (const InputError& cut) {
    return {cut.what()};
  }
  std::vector<std::string> found = store::differencesOfTools(there, here);
  if (there.motion != here.motion) found.push_back("the motion differs from the recorded one");
  if (!found.empty()) return found;
  return {
      "version, renderer, FFmpeg and motion are those recorded: the clip was changed, or a "
      "texture, the font, the video encoder or the build of this program differs"};
}

/// Reports whether both files have the same bytes; returns the status.
int compare(const store::RecordedClip& there, const RerunArguments& arguments,
            const fs::path& output) {
  const std::string clip = oneLine(arguments.clip.string());
  const std::string made = oneLine(output.string());
  if (system::checksumOfFile(arguments.clip) == system::checksumOfFile(output)) {
    std::cout << "  " << made << " has exactly the bytes of " << clip << std::endl;
    return kDone;
  }
  std::cout << "  " << made << " has OTHER bytes than " << clip << '\n';
  const store::ClipRecord here = store::parseRecord(video::readClipMetadata(output).comment, output,
                                                    there.record.scene.folder);
  for (const std::string& reason :
       reasons(arguments.clip, there.record.provenance, here.provenance)) {
    std::cout << "    " << oneLine(reason) << std::endl;
  }
  return kUnmet;
}

}  // namespace

int rerun(const RerunArguments& arguments) {
  const store::RecordedClip clip = store::readRecordedClip(arguments.clip, arguments.textures);
  picture::requireText(clip.record.scene);
  const store::ClipFiles files = filesOf(clip, arguments.folder);
  const fs::path output = files.video(clip.format);
  pipeline::RenderOptions options;
  options.folder = arguments.folder;
  options.earlier = arguments.earlier;
  options.outputs = pipeline::outputsOf(arguments.png, {clip.format});
  options.frames = clip.record.part;
  std::vector<Input> inputs = inputsOf(clip.record.scene);
  inputs.push_back({arguments.clip, "the clip itself, which is to be compared with the new one"});
  refuseInputs(footprintOf(clip.record.scene, options), inputs);
  if (!arguments.earlier.overwrite) {
    refuseOtherClip(clip.record.scene, files, output, arguments.png);
  }
  options.device = arguments.deviceOptions.choice(/*resumable=*/true);
  options.stop = &catchInterrupts();
  // Expectations are reported, but decide no status: they decided that of the first render.
  const int status = renderScenes({{clip.record.scene, clip.textures}}, options, 1);
  return status >= kInterrupted ? status : compare(clip, arguments, output);
}

}  // namespace rotatebook::cli

#include "cli/input_guard.h"

#include <system_error>

#include "base/error.h"
#include "picture/named_file.h"
#include "store/result_owners.h"
#include "system/read_file.h"

namespace rotatebook::cli {
namespace fs = std::filesystem;

std::vector<Input> inputsOf(const scene::Scene& scene) {
  std::vector<Input> inputs;
  for (const auto& [path, kind] : picture::namedFiles(scene)) {
    inputs.push_back({path, "a " + kind + " of the scene " + scene.name});
  }
  return inputs;
}

std::vector<Input> inputsOf(const fs::path& path, const scene::Scene& scene) {
  std::vector<Input> inputs = inputsOf(scene);
  inputs.push_back({path, "the scene itself"});
  return inputs;
}

store::Footprint footprintOf(const scene::Scene& scene, const pipeline::RenderOptions& options) {
  store::Footprint footprint;
  const std::vector<video::VideoFormat> formats = formatsOf(options.outputs);
  if (options.part) {
    footprint.addFrames(options.folder, scene);
  } else if (options.frames) {
    footprint.addPart(options.folder, scene, *options.frames, formats, hasPng(options.outputs));
  } else {
    footprint.addClip(options.folder, scene, formats);
  }
  return footprint;
}

void refuseInputs(const store::Footprint& footprint, const std::vector<Input>& inputs,
                  const std::string& remedy) {
  for (const auto& [path, what] : inputs) {
    const auto fate = footprint.fateOf(path);
    if (fate)
      throw InputError(path.string() + " is " + what + " and would be " + *fate + "; " + remedy);
  }
}

void refuseInputs(const fs::path& output, const std::vector<Input>& inputs,
                  const std::string& remedy) {
  store::Footprint footprint;
  footprint.addFile(output);
  refuseInputs(footprint, inputs, remedy);
}

void requireEnding(const fs::path& output, const std::string& ending, const std::string& option) {
  if (output.extension() == ending) return;
  throw InputError(option + " " + output.string() + ": the name of the file must end in " + ending);
}

void requirePictureOutput(const fs::path& output, const std::vector<Input>& inputs) {
  refuseInputs(output, inputs);
  requireEnding(output, ".png");
  const std::string remedy = "the picture would replace it; name another file with -o";
  store::refuseResultsOfOthers({store::ResultKind::Still, ""}, {output}, remedy);
  store::refusePictureOfOthers(output, remedy);
}

void requireAbsent(const std::filesystem::path& path) {
  std::error_code ignored;
  const auto type = std::filesystem::symlink_status(path, ignored).type();
  if (type == std::filesystem::file_type::not_found) return;
  throw InputError(path.string() +
                   " exists, and isn't overwritten; choose another name, or remove it");
}

void requireAbsentOr(const std::filesystem::path& path, std::string_view beginning) {
  if (!system::readFileOrEmpty(path).starts_with(beginning)) requireAbsent(path);
}

}  // namespace rotatebook::cli

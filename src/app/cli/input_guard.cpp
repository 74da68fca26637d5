#include "cli/input_guard.h"

#include <algorithm>
#include <iterator>
#include <system_error>

#include <fmt/core.h>

#include "base/error.h"
#include "picture/named_file.h"
#include "store/map_files.h"
#include "store/study_files.h"
#include "system/read_file.h"

namespace rotatebook::cli {
namespace fs = std::filesystem;

std::vector<Input> inputsOf(const scene::Scene& scene) {
  std::vector<Input> inputs;
  for (const auto& [path, kind] : picture::namedFiles(scene)) {
    inputs.push_back({path, fmt::format("a {} of the scene {}", kind, scene.name)});
  }
  return inputs;
}

std::vector<Input> inputsOf(const fs::path& path, const scene::Scene& scene) {
  std::vector<Input> inputs = inputsOf(scene);
  inputs.push_back({path, "the scene itself"});
  return inputs;
}

ReadScenes readAllScenes(const std::vector<std::string>& paths,
                         const std::function<scene::Scene(const std::string& path)>& read) {
  ReadScenes all;
  for (const std::string& path : paths) {
    all.scenes.push_back(read(path));
    std::ranges::move(inputsOf(path, all.scenes.back()), std::back_inserter(all.inputs));
  }
  return all;
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
    if (const auto fate = footprint.fateOf(path)) {
      throw InputError(
          fmt::format("{} is {} and would be {}; {}", path.string(), what, *fate, remedy));
    }
  }
}

void refuseInputs(const fs::path& output, const std::vector<Input>& inputs,
                  const std::string& remedy) {
  store::Footprint footprint;
  footprint.addFile(output);
  refuseInputs(footprint, inputs, remedy);
}

void refuseLosses(store::ResultKind kind, const scene::Scene& scene, const fs::path& folder,
                  const std::vector<Input>& inputs,
                  const std::vector<video::VideoFormat>& formats) {
  store::Footprint footprint;
  const auto refuse = [&](const char* what, const std::vector<fs::path>& outputs) {
    refuseInputs(footprint, inputs);
    std::string remedy =
        fmt::format("the {} of {} would replace it; name another folder with -o", what, scene.name);
    store::refuseResultsOfOthers({kind, scene.name}, outputs, remedy);
    return remedy;
  };
  if (kind == store::ResultKind::Clip) {
    const store::ClipFiles files = store::clipFiles(folder, scene.name);
    const std::vector<fs::path> outputs = outputFiles(files, scene, formats);
    footprint.addClip(folder, scene, formats);
    store::refuseNoResultsOfClip(files, outputs, refuse("render", outputs));
  } else if (kind == store::ResultKind::Study) {
    const store::StudyFiles files = store::studyFiles(folder, scene.name);
    footprint.addStudy(files);
    store::refuseNoResultsOfStudy(files, refuse("study", allOf(files)));
  } else {
    const store::MapFiles files = store::mapFiles(folder, scene.name);
    const bool isFilm = kind == store::ResultKind::Film;
    footprint.addMap(files);
    isFilm ? refuse("film", {files.film}) : refuse("map", allOf(files));
    if (!isFilm) store::refuseNoResultsOfMap(files);
  }
}

void requireEnding(const fs::path& output, const std::string& ending, const std::string& option,
                   const std::string& others) {
  if (output.extension() == ending) return;
  throw InputError(fmt::format("{} {}: the name of the file must end in {}{}{}", option,
                               output.string(), ending, others.empty() ? "" : " ", others));
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

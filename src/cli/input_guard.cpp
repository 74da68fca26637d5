#include "cli/input_guard.h"

#include <system_error>

#include "base/error.h"
#include "pipeline/textures.h"

namespace rotatebook::cli {

namespace fs = std::filesystem;

void refuseInput(const fs::path& output, const fs::path& input, const std::string& what,
                 const std::string& remedy) {
  std::error_code missing;
  if (!fs::equivalent(output, input, missing)) return;
  throw InputError(output.string() + " is " + what + "; " + remedy);
}

void refuseInputs(const fs::path& output, const fs::path& path, const scene::Scene& scene,
                  const std::string& remedy) {
  refuseInput(output, path, "the scene itself, which would be lost", remedy);
  for (const fs::path& texture : pipeline::textureFiles(scene)) {
    refuseInput(output, texture, "a texture of the scene, which would be lost", remedy);
  }
}

}  // namespace rotatebook::cli

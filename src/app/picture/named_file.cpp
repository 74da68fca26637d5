#include "picture/named_file.h"

#include <algorithm>
#include <system_error>

#include "base/error.h"
#include "system/read_file.h"

namespace rotatebook::picture {

namespace fs = std::filesystem;

fs::path pathOfNamedFile(const fs::path& folder, const fs::path& file, bool allowOutside) {
  fs::path path = folder / file;
  if (allowOutside) return path;
  std::error_code error;
  const fs::path within = fs::canonical(folder.empty() ? "." : folder, error);
  const fs::path real = error ? fs::path() : fs::weakly_canonical(within / file, error);
  if (error) throw InputError("can't read " + path.string() + ": " + error.message());
  if (std::ranges::mismatch(within, real).in1 == within.end()) return path;
  throw InputError("can't read " + path.string() +
                   ": it leads outside the scene's folder, which --allow-outside allows");
}

std::string readNamedFile(const fs::path& folder, const fs::path& file, std::size_t most,
                          bool allowOutside) {
  return system::readInput(pathOfNamedFile(folder, file, allowOutside), most);
}

}  // namespace rotatebook::picture

#include "store/tables.h"

#include "store/clip_files.h"
#include "store/other_settings.h"
#include "system/atomic_file.h"
#include "timeline/trajectory_csv.h"

namespace rotatebook::store {

void writeTables(const std::vector<std::filesystem::path>& files,
                 const timeline::ClipMotion& motion) {
  for (std::size_t i = 0; i < files.size(); ++i) {
    system::AtomicFile file(files[i]);
    timeline::writeCsv(motion.trajectories()[i],
                       [&file](std::string_view piece) { file.write(piece); });
    file.commit();
  }
}

void refuseLostTables(const std::filesystem::path& csv,
                      const std::vector<std::filesystem::path>& files) {
  refuseFilesOfOtherClips(clipFiles(csv.parent_path(), csv.stem()), files,
                          "the table would replace it; name another file with --csv");
}

}  // namespace rotatebook::store

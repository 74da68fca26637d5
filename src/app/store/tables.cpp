#include "store/tables.h"

#include "base/json.h"
#include "store/fingerprint.h"
#include "system/atomic_file.h"
#include "timeline/clip_json.h"
#include "timeline/clip_tables.h"

namespace rotatebook::store {

void writeTables(const std::vector<std::filesystem::path>& files, const scene::Scene& scene,
                 const timeline::ClipMotion& motion) {
  for (std::size_t i = 0; i < files.size(); ++i) {
    system::AtomicFile file(files[i]);
    timeline::writeTable(scene, motion, i, [&file](std::string_view piece) { file.write(piece); });
    file.commit();
  }
}

void writeResult(const std::filesystem::path& file, const scene::Scene& scene,
                 const timeline::ClipMotion& motion,
                 const std::vector<timeline::MotionSummary>& summaries,
                 std::string_view motionSum) {
  const std::string sceneSum = sceneChecksum(scene);
  system::writeFileAtomically(file,
                              jsonLine(clipJson(scene, motion, summaries, {sceneSum, motionSum})));
}

}  // namespace rotatebook::store

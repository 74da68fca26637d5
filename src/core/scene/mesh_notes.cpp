#include "scene/mesh_notes.h"

#include "base/text.h"
#include "body/closed_mesh.h"

namespace rotatebook::scene {

std::vector<std::string> meshNotes(const Solid& solid) {
  std::vector<std::string> notes;
  if (solid.mesh.content == nullptr) return notes;
  for (const std::string& note : solid.mesh.content->closing.notes)
    notes.push_back(oneLine(solid.mesh.name, 200) + ": " + note);
  return notes;
}

}  // namespace rotatebook::scene

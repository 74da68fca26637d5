#include "fuzz/read_mesh.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  rotatebook::fuzzing::readMeshOrRefuse("a.glb", bytes, size);
  return 0;
}

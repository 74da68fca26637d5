#include "fuzz/read_mesh.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  rotatebook::fuzzing::readMeshOrRefuse("a.ply", bytes, size);
  return 0;
}

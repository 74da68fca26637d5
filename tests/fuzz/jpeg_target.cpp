// JPEG in, as a cover is read, with its EXIF.
#include "fuzz/decoded_picture.h"
#include "image/picture_file.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace rotatebook;
  fuzzing::requireWholeOrRefused([&] { return image::decodePicture({bytes, size}, "a.jpeg"); });
  return 0;
}

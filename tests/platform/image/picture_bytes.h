// Pictures of other formats than PNG, and what is said of wrong ones.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <string>

#include "base/error.h"
#include "image/picture_file.h"
#include "image/png_bytes.h"

namespace rotatebook::image::testing {

/// Returns the bytes of a file of tests/platform/image/pictures, such as "jpeg/sky.jpg".
inline Bytes storedPicture(const std::string& name) {
  return contentOf(std::string(ROTATEBOOK_TEST_DATA) + "/pictures/" + name);
}

inline Image decoded(const std::string& name) {
  return decodePicture(storedPicture(name), name);
}

/// Returns the message about a picture "bad"; empty if it is read.
inline std::string refusalOfPicture(const Bytes& bytes) {
  try {
    decodePicture(bytes, "bad");
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

/// Returns the mean difference of two pictures' bytes; 256 if their sizes or formats differ.
inline double distance(const Image& a, const Image& b) {
  if (a.width() != b.width() || a.height() != b.height() || a.format() != b.format()) return 256;
  const Bytes left = pixelsOf(a), right = pixelsOf(b);
  double sum = 0;
  for (std::size_t i = 0; i < left.size(); ++i) sum += std::abs(int{left[i]} - int{right[i]});
  return sum / static_cast<double>(left.size());
}

/// Returns an EXIF of one entry, as a TIFF in the byte order "II" or "MM".
Bytes exifOf(const std::string& byteOrder, int tag, int type, int value);

}  // namespace rotatebook::image::testing

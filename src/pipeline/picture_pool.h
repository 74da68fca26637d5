// A fixed set of pictures that go round, so that memory doesn't grow with the clip.
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <vector>

#include "image/image.h"

namespace rotatebook::pipeline {

/// Lends pictures and takes them back when their last owner lets go. It must outlive what it lends.
class PicturePool {
 public:
  /// `count` > 0 copies of `pattern`.
  PicturePool(const image::Image& pattern, int count);

  /// A picture with any content; waits until one is free. This is what slows drawing down to the
  /// sinks' pace.
  std::shared_ptr<image::Image> take();

 private:
  void giveBack(image::Image* picture);

  std::vector<std::unique_ptr<image::Image>> pictures_;
  std::mutex mutex_;
  std::condition_variable freed_;
  std::vector<image::Image*> free_;
};

}  // namespace rotatebook::pipeline

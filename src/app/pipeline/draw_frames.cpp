#include "pipeline/draw_frames.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "image/png_file.h"
#include "pipeline/frame_workers.h"
#include "system/pool.h"

namespace rotatebook::pipeline {
namespace {

constexpr int kExposuresInFlight = 3;

/// A frame on its way to its picture: its exposure, or the PNG of an earlier run.
struct Unfinished {
  std::int64_t frame = 0;
  /// With a PNG, held only to limit the frames in flight.
  std::shared_ptr<const picture::Exposure> exposure;
  std::optional<std::string> png;
};

image::Image decoded(const Unfinished& item) {
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(item.png->data());
  return image::decodePng({bytes, item.png->size()}, store::frameName(item.frame));
}

/// All sinks, each with its threads.
class SinkWorkers {
 public:
  SinkWorkers(const std::vector<SinkThreads>& sinks, system::FirstError& error) {
    for (const SinkThreads& entry : sinks) {
      auto workers = std::make_unique<FrameWorkers>(entry.sink, entry.threads, error);
      entries_.push_back({std::move(workers), entry.wantsKept});
    }
  }

  bool wantKept() const { return std::ranges::any_of(entries_, &Entry::wantsKept); }

  void submit(const Frame& frame, bool kept) {
    for (const Entry& entry : entries_) {
      if (!kept || entry.wantsKept) entry.workers->submit(frame);
    }
  }

  void drain() {
    for (const Entry& entry : entries_) entry.workers->drain();
  }

 private:
  struct Entry {
    std::unique_ptr<FrameWorkers> workers;
    bool wantsKept;
  };

  std::vector<Entry> entries_;
};

/// Returns how many pictures there are at once: one in each thread that writes them, one that is
/// composed, and two that wait for the slowest.
int picturesInFlight(const std::vector<SinkThreads>& sinks) {
  int count = 3;
  for (const SinkThreads& entry : sinks) count += entry.threads;
  return count;
}

}  // namespace

DrawnCount drawFrames(picture::FramePainter& painter, const FramesToDraw& frames,
                      const std::vector<SinkThreads>& sinks,
                      const std::function<void(RenderProgress)>& progress) {
  system::FirstError error;
  system::Pool<image::Image> pictures([&] { return painter.makePicture(); },
                                      picturesInFlight(sinks));
  system::Pool<picture::Exposure> exposures([&] { return painter.makeExposure(); },
                                            kExposuresInFlight);
  SinkWorkers workers(sinks, error);
  const auto finish = [&](const Unfinished& item) {
    const std::shared_ptr<image::Image> picture = pictures.take();
    item.png ? void(*picture = decoded(item)) : painter.compose(*item.exposure, *picture);
    workers.submit({item.frame, picture}, item.png.has_value());
  };
  system::Workers<Unfinished> finisher(finish, 1, error);
  DrawnCount count;
  const auto report = [&] {
    if (progress) progress({count.total(), frames.range.count()});
  };
  const auto isStopped = [&] { return frames.stop != nullptr && *frames.stop; };
  report();
  while (count.total() < frames.range.count() && !isStopped()) {
    const std::shared_ptr<picture::Exposure> exposure = exposures.take();
    Unfinished item{frames.range.first + count.total(), exposure, {}};
    try {
      if (frames.kept != nullptr) item.png = frames.kept->intact(item.frame);
      if (!item.png) painter.expose(item.frame, *exposure);
    } catch (...) {
      error.set(std::current_exception());
    }
    error.rethrow();
    ++(item.png ? count.kept : count.drawn);
    if (!item.png || workers.wantKept()) finisher.submit(std::move(item));
    report();
  }
  finisher.drain();
  workers.drain();
  error.rethrow();
  return count;
}

}  // namespace rotatebook::pipeline

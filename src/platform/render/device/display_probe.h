// Candidates to a renderer, opened one by one: for reports, not for drawing.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "render/device/context_info.h"
#include "render/device/device.h"

namespace rotatebook::render {

/// The candidates that EGL offers, in the order in which a render tries them.
class DisplayProbe {
 public:
  /// Lists them; missingLibrary() must be nothing.
  DisplayProbe();
  DisplayProbe(const DisplayProbe&) = delete;
  DisplayProbe& operator=(const DisplayProbe&) = delete;
  ~DisplayProbe();

  const DisplayCandidates& list() const;
  /// Makes an OpenGL context on candidate `index` of the list and ends it again. Nothing, and why
  /// in `failure`, if there is none. A driver may end the process, or never come back.
  std::optional<ContextInfo> open(std::size_t index, CallFailure& failure) const;

 private:
  struct Candidates;
  std::unique_ptr<Candidates> candidates_;
};

}  // namespace rotatebook::render

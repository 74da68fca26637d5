// Opens the display candidates one by one, for reports and not for drawing.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "render/device/context_info.h"
#include "render/device/device.h"

namespace rotatebook::render {

/// The display candidates that EGL offers, in the order in which a render tries them.
class DisplayProbe {
 public:
  /// Lists the candidates; missingLibrary() must return nothing.
  DisplayProbe();
  DisplayProbe(const DisplayProbe&) = delete;
  DisplayProbe& operator=(const DisplayProbe&) = delete;
  ~DisplayProbe();

  const DisplayCandidates& list() const;
  /// Creates an OpenGL context on candidate `index` of the list and destroys it again. Returns
  /// nothing, and the reason in `failure`, if that fails. A driver may end the process or hang.
  std::optional<ContextInfo> open(std::size_t index, CallFailure& failure) const;

 private:
  struct Candidates;
  std::unique_ptr<Candidates> candidates_;
};

}  // namespace rotatebook::render

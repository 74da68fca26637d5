// Calls of libjpeg, which leaves by longjmp when it fails. Inside the room only.
#pragma once

#include <csetjmp>
#include <cstdio>  // Before jpeglib.h, which needs FILE.
#include <jpeglib.h>
#include <type_traits>

namespace rotatebook::image {

/// libjpeg's message about a failure, and where to go then; plain memory, over which a longjmp may
/// pass. It is the `client_data` of what fails.
struct JpegFailure {
  std::jmp_buf landing;
  char message[JMSG_LENGTH_MAX] = "";
};

/// Leaves what libjpeg does, with its message; libjpeg's `error_exit`.
[[noreturn]] inline void leaveJpeg(j_common_ptr jpeg) {
  auto* failure = static_cast<JpegFailure*>(jpeg->client_data);
  jpeg->err->format_message(jpeg, failure->message);
  std::longjmp(failure->landing, 1);
}

/// Runs `body`, which calls libjpeg; returns false if libjpeg failed and jumped out of it. `body`
/// must own nothing: a longjmp over a destructor is undefined.
template <typename Body>
bool jpegSucceeds(JpegFailure& failure, Body body) {
  static_assert(std::is_trivially_destructible_v<Body>);
  if (setjmp(failure.landing) != 0) return false;
  body();
  return true;
}

}  // namespace rotatebook::image

// The descriptors 0, 1 and 2. Inside the room only.
#pragma once

namespace rotatebook::cli {

/// Some start programs with them closed. The next file that is opened would be one of them then,
/// and what is printed would go into it: puts something else there, which can't be read or written.
void keepStandardStreams();

}  // namespace rotatebook::cli

// Protection of the descriptors 0, 1 and 2. Inside the room only.
#pragma once

namespace rotatebook::cli {

/// Opens each standard stream that the program was started without, as one that can't be read or
/// written. Else the next file that is opened would take its descriptor, and what is printed would
/// go into that file.
void keepStandardStreams();

}  // namespace rotatebook::cli

// Calls that fail, in a library that is loaded before all others (LD_PRELOAD).
//
// ROTATEBOOK_FAULT is CALL:NUMBER:FAULT. The CALL of that NUMBER, from 1, has the FAULT:
// the number of an error, kill (0), or -1 times that of a signal.
//   read                                             below the folder ROTATEBOOK_FAULT_BELOW, and
//                                                    all later ones, too
//   open, write, flush, link, rename, remove, mkdir, any   likewise, of what changes files
//   encode                                           of FFmpeg's encoders and muxers; likewise
//   memory                                           of the program itself, not of libraries; the
//                                                    NUMBER is a place's, of which the first fails
//   graphics                                         of EGL and OpenGL, those that tell failures
// The process is on another machine, as far as it knows, by
//   ROTATEBOOK_FAULT_LOCKS     unseen: all locks succeed; none: there are none
//   ROTATEBOOK_FAULT_START     the file that is read for the number of the machine's start
//   ROTATEBOOK_FAULT_PROCESS   the number of the process
// Two processes with the same ROTATEBOOK_FAULT_MEETING, a folder, wait for each other, for at most
// 20 s, when each is about to write a manifest for the first time.
// The number of all goes to the file ROTATEBOOK_FAULT_COUNT, if it is set; of memory the places, a
// line for each. Calls that change files, whether they fail or not, go to the file
// ROTATEBOOK_FAULT_CHANGES, if that is set and the CALL is any: "CALL PATH", a line for each, in
// the order in which they began.
#pragma once

#include <dlfcn.h>
#include <string>
#include <string_view>

namespace rotatebook::faults {

/// Returns whether this call is to fail; sets errno then. Doesn't return if the process is to be
/// killed.
bool fails(std::string_view call);
/// Like fails(), for a call that changes the file of that path.
bool failsAt(std::string_view call, const std::string& path);
/// Returns whether this request for memory is to fail: the first from that place, if it is the one.
bool failsAtPlace(long place);
/// Returns whether it is asked for at all.
bool isWanted(std::string_view call);

/// Waits for the other process if `path` is that of a manifest that is written.
void meet(const char* path);
/// Returns the path of the file that is opened in the place of `path`.
const char* redirected(const char* path);

/// The function that would have been called.
template <typename Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace rotatebook::faults

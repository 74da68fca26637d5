// Memory that the program itself asks for, by the standard library's containers, too: what its
// other libraries want comes from elsewhere.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <link.h>
#include <map>
#include <mutex>
#include <new>
#include <span>
#include <string_view>
#include <unwind.h>

#include "reliability/faults.h"

namespace {

constexpr std::size_t kMaxFrames = 64;

struct Range {
  std::uintptr_t first = 0, end = 0;

  bool contains(const void* place) const { return offsetOf(place) < end - first; }
  std::uintptr_t offsetOf(const void* place) const {
    return reinterpret_cast<std::uintptr_t>(place) - first;
  }
};

/// Addresses of code that was loaded.
struct Code {
  Range program, standardLibrary;
};

int addCode(dl_phdr_info* info, std::size_t, void* data) {
  auto& code = *static_cast<Code*>(data);
  Range range;
  for (int i = 0; i < info->dlpi_phnum; ++i) {
    const auto& part = info->dlpi_phdr[i];
    if (part.p_type != PT_LOAD || (part.p_flags & PF_X) == 0) continue;
    range = {info->dlpi_addr + part.p_vaddr, info->dlpi_addr + part.p_vaddr + part.p_memsz};
  }
  // The program is the first that the loader tells of.
  if (code.program.end == 0) code.program = range;
  if (std::string_view(info->dlpi_name).find("libstdc++.so") != std::string_view::npos) {
    code.standardLibrary = range;
  }
  return 0;
}

const Code& loadedCode() {
  static const Code code = [] {
    Code found;
    dl_iterate_phdr(addCode, &found);
    return found;
  }();
  return code;
}

bool isNamedLikeAStream(void* frame) {
  Dl_info info;
  if (dladdr(frame, &info) == 0 || info.dli_sname == nullptr) return false;
  const std::string_view name = info.dli_sname;
  return name.find("stream") != name.npos || name.find("num_get") != name.npos;
}

/// Returns whether it is a function of a stream: they report no failure, and leave the rest out.
/// Each is looked up once, as that takes long.
bool isOfStream(void* frame) {
  static auto& mutex = *new std::mutex;  // Never destroyed: libraries go on until the end.
  static auto& known = *new std::map<void*, bool>;
  const std::lock_guard lock(mutex);
  const auto [found, isNew] = known.try_emplace(frame);
  if (isNew) found->second = isNamedLikeAStream(frame);
  return found->second;
}

struct Stack {
  std::array<void*, kMaxFrames> frames;
  std::size_t count = 0;
};

// Not by backtrace(), which loads a library first.
_Unwind_Reason_Code addFrame(_Unwind_Context* context, void* data) {
  auto& stack = *static_cast<Stack*>(data);
  if (stack.count == kMaxFrames) return _URC_END_OF_STACK;
  stack.frames[stack.count++] = reinterpret_cast<void*>(_Unwind_GetIP(context));
  return _URC_NO_REASON;
}

/// Identifies a request by the calls of the program that led to it, the same in each run. 0 if it
/// isn't the program's own.
long placeOfRequest(const void* caller) {
  const Code& code = loadedCode();
  // Most requests are of the driver's compiler, and following the calls takes long.
  if (!code.program.contains(caller) && !code.standardLibrary.contains(caller)) return 0;
  Stack stack;
  _Unwind_Backtrace(addFrame, &stack);
  std::span<void*> frames(stack.frames.data(), stack.count);
  while (!frames.empty() && frames.front() != caller) frames = frames.subspan(1);
  const auto isStandard = [&](void* frame) { return code.standardLibrary.contains(frame); };
  const auto asker = std::ranges::find_if_not(frames, isStandard);
  if (asker == frames.end() || !code.program.contains(*asker)) return 0;
  std::uint64_t place = 0xcbf29ce484222325;
  for (void* frame : frames) {
    if (isStandard(frame) && isOfStream(frame)) return 0;
    if (code.program.contains(frame))
      place = (place ^ code.program.offsetOf(frame)) * 0x100000001b3;
  }
  return static_cast<long>(place >> 1 | 1);
}

using Main = int(int, char**, char**);
Main* programMain;
bool started = false;

int startMain(int argc, char** argv, char** environment) {
  started = true;
  return programMain(argc, argv, environment);
}

[[noreturn]] void fail() {
  if (const std::new_handler handler = std::get_new_handler()) handler();
  throw std::bad_alloc();
}

void* allocate(std::size_t size, const void* caller) {
  // Before main() are libraries' static objects, CLI11's, where nobody can catch anything.
  if (started && rotatebook::faults::isWanted("memory")) {
    const long place = placeOfRequest(caller);
    if (place != 0 && rotatebook::faults::failsAtPlace(place)) fail();
  }
  void* memory = std::malloc(size > 0 ? size : 1);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

void* operator new(std::size_t size) {
  return allocate(size, __builtin_return_address(0));
}
void* operator new[](std::size_t size) {
  return allocate(size, __builtin_return_address(0));
}
// Whoever asks so does without.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return std::malloc(size > 0 ? size : 1);
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete[](void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
  std::free(memory);
}

extern "C" int __libc_start_main(Main* main, int argc, char** argv, Main* init, void (*fini)(),
                                 void (*loaderFini)(), void* stackEnd) {
  programMain = main;
  using Start = int(Main*, int, char**, Main*, void (*)(), void (*)(), void*);
  return rotatebook::faults::next<Start>("__libc_start_main")(startMain, argc, argv, init, fini,
                                                              loaderFini, stackEnd);
}

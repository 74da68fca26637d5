// Memory that the program itself asks for: what its libraries want comes from elsewhere.
#include <cstdint>
#include <cstdlib>
#include <link.h>
#include <new>

#include "reliability/faults.h"

namespace {

struct Range {
  std::uintptr_t first = 0, end = 0;
};

/// Where the program's code lies; it is the first that the loader tells of.
Range programRange() {
  Range range;
  const auto take = [](dl_phdr_info* info, std::size_t, void* data) {
    auto& found = *static_cast<Range*>(data);
    for (int i = 0; i < info->dlpi_phnum; ++i) {
      const auto& part = info->dlpi_phdr[i];
      if (part.p_type != PT_LOAD || (part.p_flags & PF_X) == 0) continue;
      found = {info->dlpi_addr + part.p_vaddr, info->dlpi_addr + part.p_vaddr + part.p_memsz};
    }
    return 1;
  };
  dl_iterate_phdr(take, &range);
  return range;
}

using Main = int(int, char**, char**);
Main* programMain;
bool started = false;

int startMain(int argc, char** argv, char** environment) {
  started = true;
  return programMain(argc, argv, environment);
}

void* allocate(std::size_t size, const void* caller) {
  static const Range program = programRange();
  const auto place = reinterpret_cast<std::uintptr_t>(caller);
  // Before main() are libraries' static objects, CLI11's, where nobody can catch anything.
  const bool own = started && program.first <= place && place < program.end;
  if (own && rotatebook::faults::fails("memory")) throw std::bad_alloc();
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

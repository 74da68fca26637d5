# Emscripten as Debian has it, and what its C++ library lacks.
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE BOTH)
find_program(EMXX em++ REQUIRED)
file(REAL_PATH ${EMXX} EMXX)
cmake_path(GET EMXX PARENT_PATH emscripten)
include(${emscripten}/cmake/Modules/Platform/Emscripten.cmake)

# Headers from a folder of their own: /usr/include would come before Emscripten's C library.
set(headers ${CMAKE_BINARY_DIR}/headers)
file(MAKE_DIRECTORY ${headers})
foreach(header toml++ nlohmann xxhash.h xxh3.h)
  file(CREATE_LINK /usr/include/${header} ${headers}/${header} SYMBOLIC)
endforeach()
set(CMAKE_CXX_FLAGS_INIT "-fwasm-exceptions -isystem ${headers} -include ${CMAKE_CURRENT_LIST_DIR}/lacking.h")

# Node's own fetch() would be taken for a browser's; the parser recurses up to its limit of depth,
# which takes 3300 KiB of stack, and 4000 in code that Node hasn't optimised yet; Linux gives it 8192.
set(CMAKE_CROSSCOMPILING_EMULATOR node --no-experimental-fetch --stack-size=6000)

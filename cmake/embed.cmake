# rotatebook_embed(ROOM NAME FILE [NAME FILE]...): puts files into a room's library, and the header
# "embedded/ROOM.h" before its sources, with a function rotatebook::ROOM::NAME() for each: of type
# std::span<const std::uint8_t> for pictures, else std::string_view.
function(rotatebook_embed room)
  set(folder ${PROJECT_BINARY_DIR}/embedded/${room})
  set(declarations)
  set(functions)
  while(ARGN)
    list(POP_FRONT ARGN name file)
    set(symbol rotatebook_${room}_${name})
    file(CONFIGURE OUTPUT ${folder}/${symbol}.S @ONLY CONTENT [[
    .section .rodata
    .global @symbol@_begin
    .global @symbol@_end
@symbol@_begin:
    .incbin "@file@"
@symbol@_end:
    .section .note.GNU-stack,"",%progbits
]])
    set_source_files_properties(${folder}/${symbol}.S PROPERTIES OBJECT_DEPENDS ${file})
    target_sources(rotatebook_${room} PRIVATE ${folder}/${symbol}.S)
    set(letter char)
    set(type std::string_view)
    if(file MATCHES "\\.png$")
      set(letter std::uint8_t)
      set(type std::span<const\ std::uint8_t>)
    endif()
    string(APPEND declarations "extern \"C\" const ${letter} ${symbol}_begin[], ${symbol}_end[];\n")
    string(APPEND functions "inline ${type} ${name}() { return {${symbol}_begin, ${symbol}_end}; }\n")
  endwhile()
  file(CONFIGURE OUTPUT ${folder}/embedded/${room}.h @ONLY CONTENT [[
// Written by cmake/embed.cmake.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

@declarations@
namespace rotatebook::@room@ {

@functions@
}  // namespace rotatebook::@room@
]])
  target_include_directories(rotatebook_${room} PRIVATE ${folder})
endfunction()

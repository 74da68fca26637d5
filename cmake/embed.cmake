# rotatebook_embed(TARGET SYMBOL FILE): puts FILE's bytes into TARGET, between the symbols
# embedded_SYMBOL_begin and embedded_SYMBOL_end.
function(rotatebook_embed target symbol file)
  set(assembly ${CMAKE_CURRENT_BINARY_DIR}/${symbol}.S)
  file(CONFIGURE OUTPUT ${assembly} @ONLY CONTENT [[
    .section .rodata
    .global embedded_@symbol@_begin
    .global embedded_@symbol@_end
embedded_@symbol@_begin:
    .incbin "@file@"
embedded_@symbol@_end:
    .section .note.GNU-stack,"",%progbits
]])
  set_source_files_properties(${assembly} PROPERTIES OBJECT_DEPENDS ${file})
  target_sources(${target} PRIVATE ${assembly})
endfunction()

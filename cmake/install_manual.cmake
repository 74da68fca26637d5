# Installs what the program says of itself: its manual page, what shells complete, and the schema of scenes. Run by cmake
# --install, with `rotatebook_program`, its path.
set(share $ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}/share)

# write(FILE ARGUMENT...): leaves what `rotatebook ARGUMENT...` prints in share/FILE.
function(write file)
  get_filename_component(folder ${share}/${file} DIRECTORY)
  file(MAKE_DIRECTORY ${folder})
  execute_process(COMMAND ${rotatebook_program} ${ARGN} OUTPUT_FILE ${share}/${file} COMMAND_ERROR_IS_FATAL ANY)
  message(STATUS "Installing: ${share}/${file}")
endfunction()

write(man/man1/rotatebook.1 help --man)
execute_process(COMMAND gzip -9nf ${share}/man/man1/rotatebook.1 COMMAND_ERROR_IS_FATAL ANY)
write(bash-completion/completions/rotatebook help --completion bash)
write(zsh/vendor-completions/_rotatebook help --completion zsh)
write(fish/vendor_completions.d/rotatebook.fish help --completion fish)
write(rotatebook/scene.schema.json check --schema)

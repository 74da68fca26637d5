# Installs what the program says of itself: its manual page, and what shells complete. Run by cmake
# --install, with `rotatebook_program`, its path.
set(share $ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}/share)

# write(FILE ARGUMENT...): leaves what `rotatebook help ARGUMENT...` prints in share/FILE.
function(write file)
  get_filename_component(folder ${share}/${file} DIRECTORY)
  file(MAKE_DIRECTORY ${folder})
  execute_process(COMMAND ${rotatebook_program} help ${ARGN} OUTPUT_FILE ${share}/${file} COMMAND_ERROR_IS_FATAL ANY)
  message(STATUS "Installing: ${share}/${file}")
endfunction()

write(man/man1/rotatebook.1 --man)
execute_process(COMMAND gzip -9nf ${share}/man/man1/rotatebook.1 COMMAND_ERROR_IS_FATAL ANY)
write(bash-completion/completions/rotatebook --completion bash)
write(zsh/vendor-completions/_rotatebook --completion zsh)
write(fish/vendor_completions.d/rotatebook.fish --completion fish)

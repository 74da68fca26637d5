# Writes what Debian wants beside a program: its licences and its changes. Run for the package, with
# `source`, the project's folder, and `version`; DEBFULLNAME and DEBEMAIL say who makes it.
set(folder $ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}/share/doc/rotatebook)
file(MAKE_DIRECTORY ${folder})

file(COPY_FILE ${source}/LICENSE ${folder}/copyright)
# append(WHAT FILE): adds a licence of something that is part of the program.
function(append what file)
  file(READ ${file} text)
  file(APPEND ${folder}/copyright "\n${what}:\n\n${text}")
endfunction()
append("The fonts in the program" ${source}/assets/fonts/OFL.txt)
append("uPlot, which is in the pages that it writes" ${source}/assets/page/uplot/LICENSE)
foreach(package libeigen3-dev libtomlplusplus-dev libcli11-dev libxxhash-dev nlohmann-json3-dev)
  append("Compiled into it, from Debian's ${package}" /usr/share/doc/${package}/copyright)
endforeach()

if(EXISTS ${source}/build/play/play.html)
  append("Emscripten, of which the live book has parts" /usr/share/doc/emscripten/copyright)
endif()

string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)  # SOURCE_DATE_EPOCH, where it is set.
file(WRITE ${folder}/changelog
  "rotatebook (${version}) unstable; urgency=medium\n\n  * As of this day; NEWS.gz says what changed.\n\n -- $ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>  ${date}\n")
file(COPY_FILE ${source}/CHANGELOG.md ${folder}/NEWS)
execute_process(COMMAND gzip -9nf ${folder}/changelog ${folder}/NEWS COMMAND_ERROR_IS_FATAL ANY)

# The Debian package, which `make deb` makes: the component `program` of what is installed, and what
# Debian wants beside it.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_CMAKE_PROJECTS "${PROJECT_BINARY_DIR};rotatebook;program;/"
                                 "${PROJECT_BINARY_DIR};rotatebook;debian;/")
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_PACKAGE_DESCRIPTION
  "A book that spins about its middle axis turns over, again and again.
 rotatebook simulates it, draws it without a display, and writes videos
 that are checked against what they must show.")
# What the program links, dpkg-shlibdeps finds; what is loaded by name while it runs, it can't:
# libepoxy loads EGL and OpenGL, EGL loads Mesa, and Mesa its drivers; the program itself loads FFmpeg.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libegl1, libegl-mesa0, libgl1-mesa-dri, libopengl0")
foreach(library avformat avcodec avutil swscale avfilter)
  pkg_check_modules(LIB${library} REQUIRED QUIET lib${library})
  string(REGEX MATCH "^[0-9]+" major ${LIB${library}_VERSION})
  string(APPEND CPACK_DEBIAN_PACKAGE_DEPENDS ", lib${library}${major}")
  if(library MATCHES "avformat|avcodec|avfilter")
    string(APPEND CPACK_DEBIAN_PACKAGE_DEPENDS " | lib${library}-extra${major}")
  endif()
endforeach()
install(CODE "set(source ${PROJECT_SOURCE_DIR})\nset(version ${PROJECT_VERSION})"
        COMPONENT debian EXCLUDE_FROM_ALL)
install(SCRIPT ${PROJECT_SOURCE_DIR}/cmake/install_debian.cmake COMPONENT debian EXCLUDE_FROM_ALL)
include(CPack)

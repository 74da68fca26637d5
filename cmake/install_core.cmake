# The package that find_package(rotatebook) finds: rotatebook::core, and rotatebook::ROOM for each room.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

add_library(rotatebook_core INTERFACE)
add_library(rotatebook::core ALIAS rotatebook_core)
set(targets ${core})
list(TRANSFORM targets PREPEND rotatebook_)
target_link_libraries(rotatebook_core INTERFACE ${targets})
foreach(target core numerics ${core})
  set_target_properties(rotatebook_${target} PROPERTIES EXPORT_NAME ${target})
endforeach()

if(ROTATEBOOK_SANITIZE)  # What they link isn't installed.
  return()
endif()

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/rotatebook)
install(TARGETS rotatebook_core rotatebook_numerics ${targets} EXPORT rotatebook)
install(EXPORT rotatebook NAMESPACE rotatebook:: DESTINATION ${package} FILE rotatebookTargets.cmake)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/rotatebookConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_SOURCE_DIR}/cmake/rotatebookConfig.cmake
              ${PROJECT_BINARY_DIR}/rotatebookConfigVersion.cmake DESTINATION ${package})
install(CODE "set(core ${core})\nset(core_source ${PROJECT_SOURCE_DIR}/src/core)")
install(SCRIPT ${PROJECT_SOURCE_DIR}/cmake/install_headers.cmake)

# `cmake --install`: the library with its headers, CMake package and pkg-config file, the programs with manual pages and
# completions, their data, the adapters for other engines and the licence. `cpack -G DEB` makes a Debian package of it.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS ricochet_core ricochet_verify_order EXPORT ricochetTargets)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/core/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  FILES_MATCHING PATTERN "*.hpp")
install(DIRECTORY ${PROJECT_SOURCE_DIR}/verify/include/ricochet/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ricochet
  FILES_MATCHING PATTERN "*.hpp")
install(DIRECTORY ${PROJECT_BINARY_DIR}/core/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  FILES_MATCHING PATTERN "*.hpp")
if(EXISTS ${PROJECT_SOURCE_DIR}/data)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/data/ DESTINATION ${CMAKE_INSTALL_DATADIR}/ricochet/data)
endif()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/engines/conformance DESTINATION ${CMAKE_INSTALL_DATADIR}/ricochet
  USE_SOURCE_PERMISSIONS FILES_MATCHING PATTERN "*.py" PATTERN "__pycache__" EXCLUDE)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CHANGELOG.md
  DESTINATION ${CMAKE_INSTALL_DOCDIR})

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/ricochet)
install(EXPORT ricochetTargets NAMESPACE ricochet:: DESTINATION ${package_folder})
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/ricochetConfig.cmake.in ricochetConfig.cmake
  INSTALL_DESTINATION ${package_folder})
# 0.x: a new minor version may change names.
write_basic_package_version_file(ricochetConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/ricochetConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/ricochetConfigVersion.cmake
  DESTINATION ${package_folder})

# pkg-config, from wherever the prefix is moved to.
file(RELATIVE_PATH prefix_from_pkgconfig ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
configure_file(${CMAKE_CURRENT_LIST_DIR}/ricochet.pc.in ricochet.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/ricochet.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

# What the programs say of themselves, by the options that they have.
set(described ${PROJECT_BINARY_DIR}/described)
function(ricochet_describe program)
  set(files)
  foreach(kind man-page bash zsh fish)
    set(file ${described}/${program}.${kind})
    set(asked --completion ${kind})
    if(kind STREQUAL man-page)
      set(asked --man-page)
    endif()
    add_custom_command(OUTPUT ${file} COMMAND ${program} ${asked} > ${file} DEPENDS ${program} VERBATIM)
    list(APPEND files ${file})
  endforeach()
  add_custom_target(describe_${program} ALL DEPENDS ${files})
  # So that what `./ricochet calibrate` built can be installed and packed.
  add_dependencies(programs describe_${program})
  install(FILES ${described}/${program}.man-page DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 RENAME ${program}.1)
  install(FILES ${described}/${program}.bash
    DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME ${program})
  install(FILES ${described}/${program}.zsh DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions
    RENAME _${program})
  install(FILES ${described}/${program}.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d
    RENAME ${program}.fish)
endfunction()
file(MAKE_DIRECTORY ${described})
foreach(program calibrate verify simulate)
  if(TARGET ${program})
    ricochet_describe(${program})
  endif()
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VENDOR "The Ricochet developers")
set(CPACK_PACKAGE_CONTACT "The Ricochet developers")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# The figures, and the adapters of the conformance cases; and what a user's own program needs who links the library.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "gnuplot-nox, fonts-dejavu-core, python3")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "cmake, g++, libboost-dev, libeigen3-dev, libgsl-dev")
include(CPack)

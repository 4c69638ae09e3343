# `cmake --install`: the library with its headers and CMake package, the programs, their data and the licence.
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

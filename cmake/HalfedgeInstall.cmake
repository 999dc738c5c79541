# `cmake --install`: the library, its headers, and a package for find_package(halfedge CONFIG).

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(halfedge_package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/halfedge")

install(TARGETS halfedge EXPORT halfedge-targets)
install(DIRECTORY src/halfedge DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}"
  FILES_MATCHING PATTERN "*.h")
install(EXPORT halfedge-targets NAMESPACE halfedge:: DESTINATION "${halfedge_package_dir}")
install(FILES LICENSE DESTINATION "${CMAKE_INSTALL_DOCDIR}")

configure_package_config_file(cmake/halfedge-config.cmake.in
  "${CMAKE_CURRENT_BINARY_DIR}/halfedge-config.cmake"
  INSTALL_DESTINATION "${halfedge_package_dir}")
write_basic_package_version_file("${CMAKE_CURRENT_BINARY_DIR}/halfedge-config-version.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES
  "${CMAKE_CURRENT_BINARY_DIR}/halfedge-config.cmake"
  "${CMAKE_CURRENT_BINARY_DIR}/halfedge-config-version.cmake"
  DESTINATION "${halfedge_package_dir}")

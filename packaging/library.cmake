# The library for other programs: headers, libasos, find_package(asos) and pkg-config.
include(CMakePackageConfigHelpers)
set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/asos")
install(DIRECTORY "${CMAKE_SOURCE_DIR}/include/asos" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}"
  COMPONENT development FILES_MATCHING PATTERN "*.h")
install(TARGETS libasos EXPORT asosTargets
  ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT development
  LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT library NAMELINK_COMPONENT development
  INCLUDES DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
# ./run builds the program alone; what it built can be installed.
add_dependencies(asos libasos)
install(EXPORT asosTargets NAMESPACE asos:: DESTINATION "${package_dir}" COMPONENT development)

configure_package_config_file(asosConfig.cmake.in "${CMAKE_CURRENT_BINARY_DIR}/asosConfig.cmake"
  INSTALL_DESTINATION "${package_dir}")
write_basic_package_version_file("${CMAKE_CURRENT_BINARY_DIR}/asosConfigVersion.cmake"
  COMPATIBILITY SameMajorVersion)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/asosConfig.cmake"
  "${CMAKE_CURRENT_BINARY_DIR}/asosConfigVersion.cmake"
  DESTINATION "${package_dir}" COMPONENT development)

# pkg-config finds the prefix from the file's own place, so that the tree can be moved.
file(RELATIVE_PATH to_prefix "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
string(REGEX REPLACE "/$" "" ASOS_PC_PREFIX "\${pcfiledir}/${to_prefix}")
set(ASOS_PC_LIBS "")
set(ASOS_PC_PRIVATE ".private")
if(NOT BUILD_SHARED_LIBS)
  set(ASOS_PC_LIBS " -lembree3 -lmeshoptimizer -pthread")
  set(ASOS_PC_PRIVATE "")
endif()
configure_file(asos.pc.in "${CMAKE_CURRENT_BINARY_DIR}/asos.pc" @ONLY)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/asos.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig"
  COMPONENT development)

# What `cmake --install` leaves: headers, library, tool with its manual page and completions,
# licence, CMake package, pkg-config file. Everything
# finds its neighbours relative to itself, so an installed tree may be moved.
include(CMakePackageConfigHelpers)

install(TARGETS abut EXPORT abutTargets
  RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}"
  LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
install(TARGETS abut_device EXPORT abutDeviceTargets
  RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}"
  LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/include/abut" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}"
  FILES_MATCHING PATTERN "*.hpp")

set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/abut")
install(EXPORT abutTargets NAMESPACE abut:: DESTINATION "${package_dir}")
install(EXPORT abutDeviceTargets NAMESPACE abut:: DESTINATION "${package_dir}")
# A static abut::device leaves the runtime of CUDA to who links it.
set(ABUT_NEEDS_CUDA_RUNTIME OFF)
if(ABUT_USE_CUDA AND NOT BUILD_SHARED_LIBS)
  set(ABUT_NEEDS_CUDA_RUNTIME ON)
endif()
configure_package_config_file(
  "${CMAKE_CURRENT_LIST_DIR}/abutConfig.cmake.in" "${PROJECT_BINARY_DIR}/abutConfig.cmake"
  INSTALL_DESTINATION "${package_dir}")
# Before 1.0 a minor version may change what programs were compiled against.
write_basic_package_version_file("${PROJECT_BINARY_DIR}/abutConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/abutConfig.cmake" "${PROJECT_BINARY_DIR}/abutConfigVersion.cmake"
  DESTINATION "${package_dir}")

# From the folder of abut.pc up to the prefix; folders that were given as absolute stay so.
file(RELATIVE_PATH ABUT_PC_TO_PREFIX
  "${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig" "${CMAKE_INSTALL_PREFIX}")
cmake_path(APPEND ABUT_PC_LIBDIR "\${prefix}" "${CMAKE_INSTALL_LIBDIR}")
cmake_path(APPEND ABUT_PC_INCLUDEDIR "\${prefix}" "${CMAKE_INSTALL_INCLUDEDIR}")
# Who links a static library links what it needs; a shared one brings it.
set(ABUT_PC_NEEDS)
foreach(library IN LISTS ABUT_CORE_LIBRARIES)
  if(library MATCHES "^-")
    string(APPEND ABUT_PC_NEEDS " ${library}")
  else()
    string(APPEND ABUT_PC_NEEDS " -l${library}")
  endif()
endforeach()
get_target_property(abut_type abut TYPE)
if(abut_type STREQUAL "STATIC_LIBRARY")
  set(ABUT_PC_LIBS "${ABUT_PC_NEEDS}")
  set(ABUT_PC_LIBS_PRIVATE)
else()
  set(ABUT_PC_LIBS)
  set(ABUT_PC_LIBS_PRIVATE "${ABUT_PC_NEEDS}")
endif()
configure_file("${CMAKE_CURRENT_LIST_DIR}/abut.pc.in" "${PROJECT_BINARY_DIR}/abut.pc" @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/abut.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig")

install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DOCDIR}")

if(ABUT_BUILD_TOOL AND TARGET abut_tool)
  install(TARGETS abut_tool RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
endif()
if(TARGET abut_told)
  install(DIRECTORY "${PROJECT_BINARY_DIR}/share/" DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}")
endif()

# SPDX-License-Identifier: MIT
# The native library, for programs in C++:
#   cmake --build build/native --target remesher
#   cmake --install build/native --prefix PLACE
# A program's find_package(remesher) then gives remesher::remesher. Its headers are those that
# remesher.h includes; beside them only Eigen's are needed.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

add_library(remesher STATIC EXCLUDE_FROM_ALL ${core_objects})
set_target_properties(remesher PROPERTIES LINKER_LANGUAGE CXX)
target_link_libraries(remesher INTERFACE $<INSTALL_INTERFACE:Eigen3::Eigen>)
target_compile_features(remesher INTERFACE cxx_std_20)
target_compile_definitions(remesher INTERFACE EIGEN_UNALIGNED_VECTORIZE=0)  # as it is built
target_include_directories(remesher INTERFACE
  $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/remesher>)

set(place_of_package ${CMAKE_INSTALL_LIBDIR}/cmake/remesher)
install(TARGETS remesher EXPORT targets)
install(EXPORT targets NAMESPACE remesher:: FILE targets.cmake DESTINATION ${place_of_package})
install(FILES src/remesher.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/remesher)
install(FILES
  src/base/boolean.h
  src/base/diagnostics.h
  src/base/error.h
  src/base/file.h
  src/base/frame.h
  src/base/options.h
  src/base/phase_clock.h
  src/base/progress.h
  src/base/quarter_turn.h
  src/base/report.h
  src/base/triangle_mesh.h
  src/base/types.h
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/remesher/base
)
file(WRITE ${CMAKE_BINARY_DIR}/remesherConfig.cmake
  "include(CMakeFindDependencyMacro)\n"
  "find_dependency(Eigen3)\n"
  "include(\${CMAKE_CURRENT_LIST_DIR}/targets.cmake)\n")
write_basic_package_version_file(${CMAKE_BINARY_DIR}/remesherConfigVersion.cmake
  COMPATIBILITY SameMajorVersion)
install(FILES
  ${CMAKE_BINARY_DIR}/remesherConfig.cmake
  ${CMAKE_BINARY_DIR}/remesherConfigVersion.cmake
  DESTINATION ${place_of_package}
)

# SPDX-License-Identifier: MIT
#
# The package: find_package(delref COMPONENTS core delref io images expression module_core module).

include(CMakePackageConfigHelpers)

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/delrefConfig.cmake.in ${PROJECT_BINARY_DIR}/delrefConfig.cmake
                              INSTALL_DESTINATION ${delref_cmake_install_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/delrefConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(
  FILES ${PROJECT_BINARY_DIR}/delrefConfig.cmake ${PROJECT_BINARY_DIR}/delrefConfigVersion.cmake
        ${PROJECT_SOURCE_DIR}/cmake/FindLibNifti.cmake
  DESTINATION ${delref_cmake_install_dir}
  COMPONENT core)
install(
  DIRECTORY ${PROJECT_SOURCE_DIR}/LICENSES/
  DESTINATION ${CMAKE_INSTALL_DOCDIR}
  COMPONENT core)

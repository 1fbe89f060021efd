# SPDX-License-Identifier: MIT
#
# libnifti2 of the NIfTI C libraries: LibNifti::nifti2. Their own package configuration is not used: Debian's names programs that are in
# another package, and fails without them.
#
# Installed beside delrefConfig.cmake.

find_path(LibNifti_INCLUDE_DIR nifti2_io.h PATH_SUFFIXES nifti)
find_library(LibNifti_LIBRARY nifti2)
mark_as_advanced(LibNifti_INCLUDE_DIR LibNifti_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(LibNifti REQUIRED_VARS LibNifti_LIBRARY LibNifti_INCLUDE_DIR)

if(LibNifti_FOUND AND NOT TARGET LibNifti::nifti2)
  set(LibNifti_scope)
  if(CMAKE_FIND_PACKAGE_TARGETS_GLOBAL)
    set(LibNifti_scope GLOBAL)
  endif()
  add_library(LibNifti::nifti2 UNKNOWN IMPORTED ${LibNifti_scope})
  set_target_properties(LibNifti::nifti2 PROPERTIES IMPORTED_LOCATION ${LibNifti_LIBRARY} INTERFACE_INCLUDE_DIRECTORIES
                                                                                          ${LibNifti_INCLUDE_DIR})
endif()

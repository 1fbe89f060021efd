# SPDX-License-Identifier: MIT
#
# What delref::delref, delref::io, delref::images and delref::expression need. The targets are global, so that a project which adds
# delref as a subdirectory can link to them. Imported targets are SYSTEM: their headers do not warn.

set(DELREF_HAS_CGAL OFF)
set(DELREF_HAS_IO OFF)
set(DELREF_HAS_IMAGES OFF)
set(DELREF_HAS_EXPRESSION OFF)
if(NOT DELREF_CORE_ONLY)
  set(CMAKE_FIND_PACKAGE_TARGETS_GLOBAL ON)
  if(NOT DEFINED CMAKE_POLICY_DEFAULT_CMP0167)
    set(CMAKE_POLICY_DEFAULT_CMP0167 NEW) # CGAL finds Boost by Boost's own package
  endif()
  find_package(CGAL 5.5 REQUIRED)
  find_package(range-v3 REQUIRED)
  find_package(fmt REQUIRED)
  set(DELREF_HAS_CGAL ON)

  find_package(nlohmann_json QUIET)
  find_package(pugixml QUIET)
  if(nlohmann_json_FOUND AND pugixml_FOUND)
    set(DELREF_HAS_IO ON)
  else()
    message(STATUS "delref: no file formats, for they need nlohmann_json and pugixml")
  endif()

  find_package(ZLIB QUIET)
  list(APPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR})
  find_package(LibNifti QUIET)
  if(DELREF_HAS_IO AND TARGET ZLIB::ZLIB AND TARGET LibNifti::nifti2)
    set(DELREF_HAS_IMAGES ON)
  else()
    message(STATUS "delref: no images, for they need the file formats, zlib and libnifti")
  endif()

  find_package(muparser QUIET)
  if(TARGET muparser::muparser)
    set(DELREF_HAS_EXPRESSION ON)
  else()
    message(STATUS "delref: no expressions, for they need muParser")
  endif()
endif()

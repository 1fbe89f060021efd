# SPDX-License-Identifier: MIT
#
# The one function that makes a library of delref: target, alias, header and module file sets, installation and export.

include(GNUInstallDirs)

set(delref_cmake_install_dir ${CMAKE_INSTALL_LIBDIR}/cmake/delref)

# delref_add_library(<target> EXPORT_NAME <name> COMPONENT <component>
#                    [HEADERS <files>...] [MODULES <files>...] [LINKS <targets>...])
#
# Gives <target> and delref::<name>. With MODULES it is a static library that holds these module interface units, else an
# interface library. HEADERS are relative to include/, and each of them is compiled alone by the target
# all_verify_interface_header_sets. The library is installed with, and exported for, the package component <component>.
function(delref_add_library target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "EXPORT_NAME;COMPONENT" "HEADERS;MODULES;LINKS")

  if(arg_MODULES)
    set(scope PUBLIC)
    add_library(${target} STATIC)
    target_sources(
      ${target}
      PUBLIC FILE_SET CXX_MODULES
             BASE_DIRS ${CMAKE_CURRENT_SOURCE_DIR}
             FILES ${arg_MODULES})
    set_target_properties(${target} PROPERTIES CXX_SCAN_FOR_MODULES ON)
  else()
    set(scope INTERFACE)
    add_library(${target} INTERFACE)
    list(TRANSFORM arg_HEADERS PREPEND ${PROJECT_SOURCE_DIR}/include/)
    target_sources(
      ${target}
      INTERFACE FILE_SET HEADERS
                BASE_DIRS ${PROJECT_SOURCE_DIR}/include
                FILES ${arg_HEADERS})
    set_target_properties(${target} PROPERTIES VERIFY_INTERFACE_HEADER_SETS ${PROJECT_IS_TOP_LEVEL})
  endif()
  add_library(delref::${arg_EXPORT_NAME} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${arg_EXPORT_NAME})

  target_compile_features(${target} ${scope} cxx_std_20)
  # Contraction to fused multiply-add breaks the error bounds of adaptive geometric predicates.
  target_compile_options(
    ${target} ${scope} "$<$<COMPILE_LANG_AND_ID:CXX,GNU,Clang,AppleClang>:-ffp-contract=off>"
    "$<$<COMPILE_LANG_AND_ID:CXX,MSVC>:/fp:precise>")
  target_link_libraries(${target} ${scope} ${arg_LINKS})

  if(DELREF_INSTALL)
    if(arg_MODULES)
      set(file_set CXX_MODULES DESTINATION ${CMAKE_INSTALL_LIBDIR}/delref/modules)
      set(export_modules CXX_MODULES_DIRECTORY ${arg_COMPONENT}-modules)
    else()
      set(file_set HEADERS)
      set(export_modules)
    endif()
    install(
      TARGETS ${target}
      EXPORT delref-${arg_COMPONENT}-targets
      ARCHIVE COMPONENT ${arg_COMPONENT}
      FILE_SET ${file_set} COMPONENT ${arg_COMPONENT})
    install(
      EXPORT delref-${arg_COMPONENT}-targets
      NAMESPACE delref::
      DESTINATION ${delref_cmake_install_dir}
      COMPONENT ${arg_COMPONENT} ${export_modules})
  endif()
endfunction()

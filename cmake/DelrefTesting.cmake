# SPDX-License-Identifier: MIT
#
# What the folders of tests/ and the examples use to make test programs.

include(Catch OPTIONAL)

# delref_add_test_executable(<name> LABELS <labels>... SOURCES <files>... [LIBS <targets>...] [WITHOUT_CGAL] [TIMEOUT <seconds>])
#
# A Catch2 program, each of whose test cases is one test of ctest with these labels. With WITHOUT_CGAL it is compiled where no
# header of CGAL and of what CGAL needs can be found.
function(delref_add_test_executable name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "WITHOUT_CGAL" "TIMEOUT" "LABELS;SOURCES;LIBS")
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 300)
  endif()

  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE Catch2::Catch2WithMain ${arg_LIBS})
  if(arg_WITHOUT_CGAL)
    delref_hide_cgal(${name})
  endif()
  list(POP_FRONT arg_LABELS label)
  catch_discover_tests(${name} TEST_PREFIX "${name}/" TEST_LIST ${name}_tests PROPERTIES LABELS ${label} TIMEOUT ${arg_TIMEOUT})
  if(arg_LABELS)
    # catch_discover_tests can pass on one label only; the others are added when ctest has read the list of tests.
    set(script ${CMAKE_CURRENT_BINARY_DIR}/${name}_labels.cmake)
    file(WRITE ${script} "foreach(test IN LISTS ${name}_tests)\n"
                         "  set_tests_properties(\"\${test}\" PROPERTIES LABELS \"${label};${arg_LABELS}\")\n" "endforeach()\n")
    set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${script})
  endif()
endfunction()

# delref_add_test_groups(<folder>...): adds the subdirectories of those that exist and whose first part is in DELREF_TEST_GROUPS.
function(delref_add_test_groups)
  foreach(folder IN LISTS ARGN)
    string(REGEX REPLACE "/.*" "" group ${folder})
    if(group IN_LIST DELREF_TEST_GROUPS AND EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/CMakeLists.txt)
      add_subdirectory(${folder})
    endif()
  endforeach()
endfunction()

# delref_flags_without_cgal(<variable>): the compiler flags under which every header of the system is found but those of CGAL,
# Boost, GMP and MPFR. Each folder that the compiler searches is replaced by a folder of links to all else that is in it.
function(delref_flags_without_cgal variable)
  set(flags -nostdinc)
  foreach(folder IN LISTS CMAKE_CXX_IMPLICIT_INCLUDE_DIRECTORIES)
    string(MD5 view ${folder})
    set(view ${PROJECT_BINARY_DIR}/without_cgal/${view})
    if(NOT EXISTS ${view})
      file(MAKE_DIRECTORY ${view})
      file(GLOB entries LIST_DIRECTORIES true RELATIVE ${folder} ${folder}/*)
      list(FILTER entries EXCLUDE REGEX "^(CGAL|boost|gmp.*|mpfr.*|mpf2mpfr.*)$")
      foreach(entry IN LISTS entries)
        file(CREATE_LINK ${folder}/${entry} ${view}/${entry} SYMBOLIC)
      endforeach()
    endif()
    list(APPEND flags -isystem ${view})
  endforeach()
  set(${variable} ${flags} PARENT_SCOPE)
endfunction()

# delref_hide_cgal(<target>): compiles a target with those flags.
function(delref_hide_cgal target)
  delref_flags_without_cgal(flags)
  list(JOIN flags " " flags)
  target_compile_options(${target} PRIVATE "SHELL:${flags}")
endfunction()

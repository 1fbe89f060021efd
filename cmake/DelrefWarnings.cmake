# SPDX-License-Identifier: MIT
#
# Warnings are options of the directory, not of a target: so they reach the targets that CMake itself makes to compile every
# public header alone, and they never reach a target of a project that uses delref. BUILD_INTERFACE keeps them out of the
# flags with which such a project compiles our installed module interface units.

if(DELREF_WARNINGS)
  if(MSVC)
    set(delref_warning_flags /W4)
    set(delref_error_flag /WX)
  else()
    set(delref_warning_flags -Wall -Wextra -Wconversion -Wshadow)
    set(delref_error_flag -Werror)
  endif()
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    # GCC bug 105651: g++ 12 sees overlapping copies in every concatenation of strings that it inlines.
    list(APPEND delref_warning_flags -Wno-restrict)
  endif()
  # Boost 1.74 derives its hashes from std::unary_function, and CGAL's triangulations of space use them: Clang says so at our calls.
  if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    list(APPEND delref_warning_flags -Wno-deprecated-declarations)
  endif()
  if(DELREF_WERROR)
    list(APPEND delref_warning_flags ${delref_error_flag})
  endif()
  foreach(flag IN LISTS delref_warning_flags)
    add_compile_options($<BUILD_INTERFACE:${flag}>)
  endforeach()
endif()

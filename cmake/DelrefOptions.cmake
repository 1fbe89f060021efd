# SPDX-License-Identifier: MIT
#
# What a user of the build may choose. Everything that only developers of delref need is off inside another project.

option(DELREF_BUILD_TESTS "Build the tests" ${PROJECT_IS_TOP_LEVEL})
option(DELREF_BUILD_EXAMPLES "Build the examples and run them as tests" ${PROJECT_IS_TOP_LEVEL})
option(DELREF_BUILD_TOOLS "Build the program delref" ${PROJECT_IS_TOP_LEVEL})
option(DELREF_BUILD_DOCS "Give the target docs, if doxygen is found" ${PROJECT_IS_TOP_LEVEL})
option(DELREF_BUILD_BENCHMARKS "Build the benchmarks" OFF)
option(DELREF_MODULES "Build the modules delref.core and delref (Clang 19 or later, Ninja)" OFF)
option(DELREF_INSTALL "Give install rules" ${PROJECT_IS_TOP_LEVEL})
option(DELREF_WARNINGS "Compile delref's own targets with many warnings" ${PROJECT_IS_TOP_LEVEL})
option(DELREF_WERROR "Treat those warnings as errors" ${PROJECT_IS_TOP_LEVEL})
option(DELREF_CORE_ONLY "Offer delref::core alone and look for no dependency" OFF)

set(DELREF_TEST_GROUPS
    "unit;concepts;compile_fail;property;regression;package;cli;interchange;fuzz;module"
    CACHE STRING "The folders of tests/ that are configured; module needs DELREF_MODULES")

# Only targets that hold a module are scanned for imports.
set(CMAKE_CXX_SCAN_FOR_MODULES OFF)

if(PROJECT_IS_TOP_LEVEL)
  set(CMAKE_CXX_STANDARD 20)
  set(CMAKE_CXX_STANDARD_REQUIRED ON)
  set(CMAKE_CXX_EXTENSIONS OFF)
  if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE
        Release
        CACHE STRING "Debug, Release, RelWithDebInfo or MinSizeRel" FORCE)
  endif()
endif()

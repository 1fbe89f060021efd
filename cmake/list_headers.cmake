# SPDX-License-Identifier: MIT
#
# Writes cmake/DelrefHeaders.cmake, the list of the public headers, from the folders of include/delref; with -D CHECK=ON writes
# nothing and fails when the list is not right. The build itself never searches folders.
#
#   cmake -P cmake/list_headers.cmake

cmake_minimum_required(VERSION 3.28)
cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH root)

# Which target the headers of a folder belong to; what is not named here belongs to delref_headers.
set(core_folders core testing)
set(io_folders io)
set(images_folders images)
set(expression_folders expression)

file(GLOB_RECURSE headers RELATIVE ${root}/include ${root}/include/delref/*.hpp)
list(SORT headers)
set(core)
set(io)
set(images)
set(expression)
set(rest)
foreach(header IN LISTS headers)
  string(REGEX REPLACE "^delref/([^/]*).*" "\\1" folder ${header})
  if(folder IN_LIST core_folders)
    list(APPEND core ${header})
  elseif(folder IN_LIST io_folders)
    list(APPEND io ${header})
  elseif(folder IN_LIST images_folders)
    list(APPEND images ${header})
  elseif(folder IN_LIST expression_folders)
    list(APPEND expression ${header})
  else()
    list(APPEND rest ${header})
  endif()
endforeach()

function(print_list name out)
  set(text "set(${name}")
  foreach(header IN LISTS ARGN)
    string(APPEND text "\n    ${header}")
  endforeach()
  set(${out} "${text})\n" PARENT_SCOPE)
endfunction()
print_list(delref_core_headers core_text ${core})
print_list(delref_headers rest_text ${rest})
print_list(delref_io_headers io_text ${io})
print_list(delref_images_headers images_text ${images})
print_list(delref_expression_headers expression_text ${expression})

string(
  CONCAT text "# SPDX-License-Identifier: MIT\n#\n"
         "# The public headers of each library, relative to include/. After adding or removing one, run\n"
         "#   cmake -P cmake/list_headers.cmake\n\n"
         "# The frame: no CGAL, MIT.\n${core_text}\n# Planar meshing.\n${rest_text}\n# File formats.\n${io_text}\n# Images.\n${images_text}\n"
         "# Functions written as text.\n${expression_text}")

set(list ${root}/cmake/DelrefHeaders.cmake)
file(READ ${list} old)
if(old STREQUAL text)
  message(STATUS "${list} lists every public header")
elseif(CHECK)
  message(FATAL_ERROR "${list} is not the list of the headers in include/delref; run\n  cmake -P cmake/list_headers.cmake")
else()
  file(WRITE ${list} "${text}")
  message(STATUS "wrote ${list}")
endif()

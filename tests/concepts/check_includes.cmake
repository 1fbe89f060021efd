# SPDX-License-Identifier: MIT
#
# Fails if one of SOURCES includes, through whatever header, a file of CGAL or of what CGAL needs, or a file of delref that is not MIT;
# asks COMPILER for the list of what is included. CGAL may be on the include path.

foreach(source IN LISTS SOURCES)
  execute_process(
    COMMAND ${COMPILER} -std=c++20 -I ${INCLUDE} -M ${source}
    OUTPUT_VARIABLE included
    RESULT_VARIABLE result)
  if(result)
    message(FATAL_ERROR "${COMPILER} does not compile ${source}")
  endif()
  string(REGEX REPLACE "[ \\\\\r\n]+" ";" included "${included}")
  set(ours 0)
  foreach(file IN LISTS included)
    if(file MATCHES "/(CGAL|boost)/|/(gmp|gmpxx|mpfr)\\.h$")
      message(SEND_ERROR "${source} includes ${file}")
    elseif(file MATCHES "/delref/.*\\.hpp$")
      math(EXPR ours "${ours} + 1")
      file(STRINGS ${file} licence LIMIT_COUNT 1)
      if(NOT licence MATCHES "SPDX-License-Identifier: MIT$")
        message(SEND_ERROR "${source} includes ${file}, which is not under the MIT licence")
      endif()
    endif()
  endforeach()
  message(STATUS "${source} includes ${ours} headers of delref")
  if(ours EQUAL 0)
    message(SEND_ERROR "the list of what ${source} includes could not be read")
  endif()
endforeach()

# SPDX-License-Identifier: MIT
#
# Compiles SOURCE with COMPILER and FLAGS, no code made, and fails unless the compiler gives the sentence that the source's first line,
# `// expect: SENTENCE`, announces, in exactly one error, or in as many as a second line `// times: N` says. A source whose first
# line announces nothing must compile.

file(STRINGS ${SOURCE} lines LIMIT_COUNT 2)
list(GET lines 0 first)
list(GET lines 1 second)
string(REGEX MATCH "^// expect: (.*)$" announces "${first}")
set(sentence "${CMAKE_MATCH_1}")
set(times 1)
if(second MATCHES "^// times: ([0-9]+)$")
  set(times ${CMAKE_MATCH_1})
endif()

cmake_path(GET SOURCE PARENT_PATH folder)
if(COMPILER MATCHES "clang")
  list(APPEND FLAGS -ferror-limit=0)
endif()
execute_process(
  COMMAND ${COMPILER} ${FLAGS} -I ${folder}/../concepts -fsyntax-only ${SOURCE}
  RESULT_VARIABLE result
  OUTPUT_VARIABLE output
  ERROR_VARIABLE output)

if(NOT announces)
  if(result)
    message(FATAL_ERROR "this source must compile, and does not:\n${output}")
  endif()
  return()
endif()
if(NOT result)
  message(FATAL_ERROR "this source compiles, and must not")
endif()

# Errors only, not the lines of source that compilers quote below them.
string(REPLACE ";" "," output "${output}")
string(REPLACE ";" "," sentence "${sentence}")
string(REPLACE "[" "(" output "${output}")
string(REPLACE "]" ")" output "${output}")
string(REPLACE "\n" ";" output_lines "${output}")
set(found 0)
foreach(line IN LISTS output_lines)
  if(line MATCHES "error: ")
    string(FIND "${line}" "${sentence}" position)
    if(NOT position EQUAL -1)
      math(EXPR found "${found} + 1")
    endif()
  endif()
endforeach()
if(NOT found EQUAL times)
  message(FATAL_ERROR "expected in ${times} error(s), found in ${found}:\n  ${sentence}\nThe compiler says:\n${output}")
endif()

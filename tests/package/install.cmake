# SPDX-License-Identifier: MIT
#
# Installs the build tree BINARY into the folder STAGE, which is emptied before.
file(REMOVE_RECURSE ${STAGE})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BINARY} --prefix ${STAGE} COMMAND_ERROR_IS_FATAL ANY)

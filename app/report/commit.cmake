# cmake -D SOURCE=... -D HEADER=... -P commit.cmake: writes the commit of the sources to a header.
# An unchanged header is not touched, so that nothing is compiled again.
find_program(GIT git)
set(commit "unknown")
if(GIT)
  execute_process(COMMAND "${GIT}" -C "${SOURCE}" describe --always --dirty --abbrev=12
    OUTPUT_VARIABLE described OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  if(NOT failed)
    set(commit "${described}")
  endif()
endif()
set(text "#pragma once\n\n#define ASOS_COMMIT \"${commit}\"\n")
set(present "")
if(EXISTS "${HEADER}")
  file(READ "${HEADER}" present)
endif()
if(NOT text STREQUAL present)
  file(WRITE "${HEADER}" "${text}")
endif()

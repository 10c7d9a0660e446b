# SPDX-License-Identifier: BSD-3-Clause
execute_process(COMMAND ${NM} --undefined-only ${LIBRARY} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
set(heap "malloc|calloc|realloc|free|_Zn[wa][a-z0-9]*|_Zd[la][A-Za-z0-9]*")
set(exceptions "__cxa[a-z_]*|_Unwind[A-Za-z_]*|_ZSt[0-9]+__throw[a-z_A-Z0-9]*")
string(REGEX MATCHALL " U (${heap}|${exceptions})\n" forbidden "${symbols}")
if(forbidden)
  list(JOIN forbidden "" listed)
  message(FATAL_ERROR "the firmware uses what a board has not:\n${listed}")
endif()

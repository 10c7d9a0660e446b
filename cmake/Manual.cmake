# SPDX-License-Identifier: BSD-3-Clause
# Manual pages and shells' completion. The programs tell their options: all of them are built first.
get_property(programs GLOBAL PROPERTY GALILEAN_PROGRAMS)
set(share ${PROJECT_BINARY_DIR}/share)
set(completion $<TARGET_FILE:galilean-manual> completion)
set(stamp ${PROJECT_BINARY_DIR}/generated/manual.stamp)
add_custom_command(OUTPUT ${stamp} DEPENDS ${programs} ship_programs ship_scenarios ship_expectations
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${share}/man
  COMMAND ${CMAKE_COMMAND} -E make_directory
          ${share}/bash-completion/completions ${share}/zsh/site-functions ${share}/fish/vendor_completions.d
  COMMAND galilean-manual manual --into ${share}/man/man1
  COMMAND ${completion} bash > ${share}/bash-completion/completions/galilean
  COMMAND ${completion} zsh > ${share}/zsh/site-functions/_galilean
  COMMAND ${completion} fish > ${share}/fish/vendor_completions.d/galilean.fish
  COMMAND ${CMAKE_COMMAND} -E touch ${stamp}
  COMMENT "Writing manual pages and shells' completion" VERBATIM)
add_custom_target(manual ALL DEPENDS ${stamp})
add_dependencies(programs manual)
install(DIRECTORY ${share}/man ${share}/bash-completion ${share}/zsh ${share}/fish DESTINATION share)

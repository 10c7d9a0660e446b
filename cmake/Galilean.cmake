# SPDX-License-Identifier: BSD-3-Clause
# The ways in which a folder adds to the build. Sources are always listed, never globbed.

# All programs; those that demo.sh waits for; and what the sanitizer builds build.
add_custom_target(programs ALL)
add_custom_target(demo_programs)
add_custom_target(unit_tests)
add_custom_target(thread_tests)

# galilean_library(NAME [COLD|WEB] [JSON] SOURCES a.cpp … LINK lib …): a static library, includable from
# the root. JSON is for one that reads or makes JSON, so that its headers are precompiled. COLD is for one
# whose time nobody notices, such as the reading of options; WEB for one made of Boost.Beast's templates,
# which take minutes to optimise with sanitizers in them. In a release neither is optimised differently,
# because precompiled headers serve one level of optimisation: for a few, see galilean_hurry.
function(galilean_library name)
  cmake_parse_arguments(arg "COLD;WEB;JSON" "" "SOURCES;LINK;PRIVATE_LINK" ${ARGN})
  add_library(${name} STATIC ${arg_SOURCES})
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/generated)
  target_link_libraries(${name} PUBLIC ${arg_LINK} PRIVATE ${arg_PRIVATE_LINK} galilean_warnings)
  if(arg_COLD OR (arg_WEB AND GALILEAN_SANITIZE))
    galilean_compile_cold(${name} "${arg_JSON}")
  elseif(arg_WEB)
    galilean_precompile(${name} galilean_web_headers)
  else()
    galilean_precompile_for(${name} "${arg_JSON}")
  endif()
endfunction()

# galilean_vectorise(NAME): a library of loops over pixels, which -O2 leaves as they are.
function(galilean_vectorise name)
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O3>)
endfunction()

# galilean_hurry(NAME): a library whose time nobody notices and which a release takes longest to optimise.
# Without precompiled headers and hardly optimised it compiles in three quarters of the time.
function(galilean_hurry name)
  if(CMAKE_BUILD_TYPE STREQUAL Release)
    target_compile_options(${name} PRIVATE -O1)
    set_target_properties(${name} PROPERTIES DISABLE_PRECOMPILE_HEADERS ON)
  endif()
endfunction()

# galilean_executable(NAME [DEMO] [JSON] SOURCES main.cpp … LINK lib …): a program in build/bin. DEMO is for
# one that `galilean demo` runs.
function(galilean_executable name)
  cmake_parse_arguments(arg "DEMO;JSON" "" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_LINK} galilean_command_line galilean_warnings)
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
  add_dependencies(programs ${name})
  if(arg_DEMO)
    add_dependencies(demo_programs ${name})
  endif()
  set_property(GLOBAL APPEND PROPERTY GALILEAN_PROGRAMS ${name})
  install(TARGETS ${name} RUNTIME DESTINATION bin)
  galilean_compile_cold(${name} "${arg_JSON}")
endfunction()

# galilean_ship(ROOM FILE…): copies files to where programs look for them, share/galilean/ROOM.
function(galilean_ship room)
  set(shipped)
  foreach(file IN LISTS ARGN)
    get_filename_component(name ${file} NAME)
    set(copy ${PROJECT_BINARY_DIR}/share/galilean/${room}/${name})
    add_custom_command(OUTPUT ${copy} DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${file}
      COMMAND ${CMAKE_COMMAND} -E copy ${CMAKE_CURRENT_SOURCE_DIR}/${file} ${copy} COMMENT "")
    list(APPEND shipped ${copy})
  endforeach()
  add_custom_target(ship_${room} ALL DEPENDS ${shipped})
  add_dependencies(programs ship_${room})
  add_dependencies(demo_programs ship_${room})
  add_dependencies(unit_tests ship_${room})
endfunction()

# galilean_benchmark(NAME SOURCES a.cpp … LINK lib …): figures beside those of a peer, in build/bin.
function(galilean_benchmark name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_LINK} benchmark::benchmark_main galilean_warnings)
  target_compile_definitions(${name} PRIVATE GALILEAN_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
  galilean_precompile(${name} galilean_headers)
endfunction()

# galilean_test(NAME [THREADS] [DDS] [LONG] SOURCES a_test.cpp … LINK lib …): a GoogleTest program,
# run by ctest.
# One program a folder keeps linking cheap. ctest runs whole programs, because to start one for each test
# takes longer than the tests; with GALILEAN_TESTS_BY_NAME it lists every test by its own name.
# THREADS marks tests that run under ThreadSanitizer as well; DDS those that must not run beside one
# another, since they would hear one another; LONG those that would take minutes under sanitizers.
# In its sources GALILEAN_SANITIZED is 1 where it is built with sanitizers, otherwise 0.
function(galilean_test name)
  cmake_parse_arguments(arg "THREADS;DDS;LONG" "" "SOURCES;LINK" ${ARGN})
  set(sanitized 0)
  if(GALILEAN_SANITIZE)
    set(sanitized 1)
  endif()
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_LINK} GTest::gtest GTest::gmock GTest::gtest_main
                                        galilean_runs_once galilean_warnings)
  target_compile_definitions(${name} PRIVATE GALILEAN_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
                                             GALILEAN_BINARY_DIR="${PROJECT_BINARY_DIR}"
                                             GALILEAN_SANITIZED=${sanitized})
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests)
  if(NOT arg_LONG)
    add_dependencies(unit_tests ${name})
  endif()
  galilean_precompile(${name} galilean_test_headers)
  set(label unit)
  if(arg_THREADS)
    set(label unit-threads)
    add_dependencies(thread_tests ${name})
  endif()
  set(properties TIMEOUT 300 LABELS ${label})
  if(arg_DDS)
    list(APPEND properties RESOURCE_LOCK dds)
  endif()
  if(GALILEAN_TESTS_BY_NAME)
    gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 PROPERTIES ${properties})
  elseif(NOT (arg_LONG AND GALILEAN_SANITIZE))
    add_test(NAME ${name} COMMAND ${name})
    set_tests_properties(${name} PROPERTIES ${properties})
  endif()
endfunction()
